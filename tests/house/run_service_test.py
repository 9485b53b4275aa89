"""Tests of scripts/release/run_service.py, and of the unit whose command it runs."""

import unittest

from support import TREE

import run_service

UNIT = TREE / "packaging/systemd/somato-live@.service"


class RunService(unittest.TestCase):
    def test_variables_are_replaced_as_systemd_does_it(self):
        unit = "[Service]\nExecStart=/usr/bin/somato live %i --model ${MODEL} $SOURCE $NONE\nRestart=always\n"
        variables = {"MODEL": "a b.somato", "SOURCE": "--body 'lucs 2' --seed 1", "NONE": ""}
        self.assertEqual(run_service.command_of(unit, variables),
                         ["/usr/bin/somato", "live", "skin", "--model", "a b.somato", "--body", "lucs 2", "--seed", "1"])

    def test_the_example_sets_every_variable_of_the_unit(self):
        example = (TREE / "packaging/example.conf").read_text(encoding="utf-8")
        variables = dict(line.split("=", 1) for line in example.splitlines() if line and not line.startswith("#"))
        command = run_service.command_of(UNIT.read_text(encoding="utf-8"), variables)
        self.assertEqual(command[:2], ["/usr/bin/somato", "live"])
        self.assertIn("--unattended", command)
        self.assertIn("{time}.mcap", command)


if __name__ == "__main__":
    unittest.main()
