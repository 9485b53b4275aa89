"""The names of what the profile for robots leaves out (program/flags/left_out.cc) are those of the whole program."""

import re
import unittest

from support import TREE

import robot_profile


class LeftOut(unittest.TestCase):
    def setUp(self):
        source = (TREE / "program/flags/left_out.cc").read_text(encoding="utf-8")
        table = source[source.index("all{"):source.index("return all;")]
        lists = [re.findall(r'"([^"]+)"', names) for names in re.findall(r"\{((?:\s*\"[^\"]+\",?)+)\}", table)]
        self.commands = [name for names in lists for name in names if not name.startswith("--")]
        self.flags = [name for names in lists for name in names if name.startswith("--")]
        self.reference = (TREE / "docs/reference/flags-and-keys.md").read_text(encoding="utf-8")

    def test_commands_are_those_of_the_program_and_of_the_check(self):
        self.assertEqual(self.commands, robot_profile.LEFT_OUT)
        for name in self.commands:
            self.assertRegex(self.reference, f"(?m)^### `somato {name}\\b")

    def test_flags_are_those_of_explore_and_live(self):
        sections = [re.split(f"(?m)^### `somato {name}\\b", self.reference)[1].split("\n### ")[0]
                    for name in ("explore", "live")]
        for flag in self.flags:
            self.assertIn(f"`{flag}", "".join(sections))


if __name__ == "__main__":
    unittest.main()
