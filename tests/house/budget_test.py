import contextlib
import io
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

from support import TreeTest

import budget
import fixed_job
import test as dev_test

LAUNCHER = Path(budget.__file__).parent / "with_processor_time.sh"
UNITS = {"dev: tests": 400.0, "dev: maps": 20.0, "dev: web.view": 100.0, "dev: codes": 1.0}


def printed_by(call, *arguments):
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        result = call(*arguments)
    return result, printed.getvalue()


class Growth(unittest.TestCase):
    def report(self, unit=0.5, **seconds):
        names = {"stage": "dev: tests", "maps": "dev: maps", "view": "dev: web.view", "codes": "dev: codes"}
        figures = budget.Figures({names.get(name, name): value for name, value in seconds.items()}, unit)
        return printed_by(budget.report, [figures], UNITS)

    def test_a_test_slowed_by_40_percent_of_its_stage_is_named_and_fails(self):
        slowed = 0.4 * 200
        within, printed = self.report(stage=200 + slowed, maps=10 + slowed, view=50)
        self.assertFalse(within)
        self.assertEqual(printed, "GROWN     dev: tests: 280.0 s instead of 200.0 s\n"
                                  "GROWN     dev: maps: 90.0 s instead of 10.0 s\n")

    def test_growth_between_10_and_30_percent_is_only_named(self):
        within, printed = self.report(stage=225, view=64)
        self.assertTrue(within)
        self.assertEqual(printed.count("GROWN"), 2)

    def test_ten_percent_or_two_seconds_are_not_growth(self):
        self.assertEqual(self.report(stage=219, codes=2.4), (True, ""))

    def test_a_machine_of_half_the_speed_has_not_grown(self):
        self.assertEqual(self.report(unit=1.0, stage=400, maps=20, view=100), (True, ""))
        self.assertFalse(self.report(unit=0.25, stage=200)[0])

    def test_a_new_test_needs_a_line(self):
        within, printed = self.report(added=3)
        self.assertFalse(within)
        self.assertIn("added: 3.0 s; the budget has no line for it", printed)
        self.assertEqual(self.report(added=1.9), (True, ""))

    def test_nothing_keeps_to_an_empty_budget(self):
        within, printed = printed_by(budget.report, [], {})
        self.assertFalse(within)
        self.assertIn("--update-budget", printed)


class File(TreeTest):
    def test_what_is_written_is_read(self):
        self.assertEqual(budget.read(self.write("budget.txt", budget.text_of(UNITS))), UNITS)
        self.assertEqual(budget.read(self.tree / "missing.txt"), {})

    def test_the_budget_of_the_repository_can_be_read(self):
        budget.read()

    def test_wrong_lines_are_errors(self):
        for text in ("dev: maps\n", "dev: maps  2.0 s\n", "dev: maps  1.0\ndev: maps  2.0\n"):
            with self.assertRaisesRegex(budget.BudgetError, r"budget.txt:\d: 'dev: maps"):
                budget.read(self.write("budget.txt", text))

    def test_only_figures_without_reuse_are_written(self):
        self.enterContext(mock.patch.multiple(
            budget, FILE=self.write("budget.txt", budget.text_of(UNITS)), LAST=self.tree / "build/last.json"))
        self.assertFalse(printed_by(budget.update)[0])
        budget.note("dev: tests", budget.Figures({"dev: tests": 300, "dev: maps": 8}, 0.5))
        budget.note("dev: build", budget.Figures({"dev: build": 7}, 0.5, 12))
        updated, printed = printed_by(budget.update)
        self.assertTrue(updated)
        self.assertIn("dev: build: not updated", printed)
        self.assertEqual(budget.read(), {**UNITS, "dev: tests": 600.0, "dev: maps": 16.0})


class Measured(TreeTest):
    def run_test(self, *command):
        file = self.tree / "times/maps.som"
        file.parent.mkdir(exist_ok=True)
        return subprocess.run([LAUNCHER, file, *command], capture_output=True, text=True), file

    def test_the_processor_time_of_all_processes_of_a_test(self):
        work = "(for ((i = 0; i < 50000; ++i)); do :; done); times; exit 3"
        done, _ = self.run_test("bash", "-c", work)
        self.assertEqual(done.returncode, 3)
        seconds = budget.seconds_of_tests(self.tree / "times", "dev")
        self.assertEqual(list(seconds), ["dev: maps.som"])
        # The times of the test's own processes, as it prints them itself.
        self.assertGreaterEqual(seconds["dev: maps.som"], budget.times_of(done.stdout))
        self.assertGreater(budget.times_of(done.stdout), 0)

    def test_tests_that_were_killed_have_no_entry(self):
        self.write("times/maps.som", "0m9.0s 0m9.0s\n1m2.500s 0m0.250s\n")
        self.write("times/web.view", "0m0.0s 0m0.0s\n0m3.000s 0m0,000s\n")
        self.write("times/web.killed", "")
        self.assertEqual(budget.seconds_of_tests(self.tree / "times", "dev"),
                         {"dev: maps.som": 62.75, "dev: web.view": 3.0})

    def test_the_fixed_job_is_the_same_work_everywhere(self):
        # Another checksum is other work: figures of the budget then have another unit.
        self.assertEqual(fixed_job.work(), "fa2054dc4dfcdbcdfa6b5c6050de9d5407fcd78761eeb46486118d26466ac8dc")


class Flags(unittest.TestCase):
    def test_each_flag_runs_what_it_names(self):
        for words, function in ((["--changed"], "run_changed"), (["--failed"], "run_failed"), (["--rooms"], "print_rooms"),
                                (["maps/som"], "run_rooms"), ([], "run_stages"), (["--all"], "run_stages")):
            with self.subTest(words), mock.patch.object(sys, "argv", ["test.py", *words]), \
                    mock.patch.object(dev_test, function, return_value=True) as called:
                self.assertTrue(dev_test.main())
                called.assert_called_once()


class Stages(TreeTest):
    """A run of made-up stages."""

    def test_tests_have_entries_and_the_set_up_has_none(self):
        self.write("build/dev/test_times/maps.som", "0m0.0s 0m0.0s\n0m5.000s 0m0.000s\n")
        stage = dev_test.Stage("dev: tests", None, "", preset="dev")
        with mock.patch.object(dev_test, "TREE", self.tree):
            self.assertEqual(dev_test.entries_of(stage, 9), {"dev: tests": 9, "dev: maps.som": 5})
            for name, entries in (("dev: build", {"dev: build": 9}), ("set-up", {}), ("checks", {})):
                self.assertEqual(dev_test.entries_of(dev_test.Stage(name, None, "", preset="dev"), 9), entries)

    def test_the_help_can_be_printed(self):
        with mock.patch("sys.argv", ["./dev test", "--help"]), self.assertRaises(SystemExit) as ended:
            printed_by(dev_test.parse_arguments)
        self.assertEqual(ended.exception.code, 0)

    def test_what_a_stage_reuses(self):
        build = dev_test.Stage("dev: build", None, "", preset="dev")
        with mock.patch.object(dev_test, "TREE", self.tree), \
                mock.patch.object(dev_test, "cache_hits", side_effect=[5, 12, 12, 12, 12, 12]):
            self.assertEqual(dev_test.Reuse(build).count(), 7)
            reuse = dev_test.Reuse(build)
            self.write("build/lint/reused_marks", "3")
            self.assertEqual(reuse.count(), 3)
            self.write("build/dev/build.ninja")
            self.assertEqual(dev_test.Reuse(build).count(), 1)

    def run_with(self, seconds, guarded):
        stage = dev_test.Stage("dev: tests", lambda: True, "", preset="dev")
        with mock.patch.multiple(dev_test, STAGES=[stage], TREE=self.tree, tree_hash=lambda: "hash",
                                 cache_hits=lambda: 0, entries_of=lambda *_: {"dev: tests": seconds}), \
                mock.patch.multiple(budget, LAST=self.tree / "last.json", read=lambda: UNITS), \
                mock.patch.object(dev_test.stage_table, "note"), \
                mock.patch.object(fixed_job, "measure", lambda: 0.5):
            return printed_by(dev_test.run_stages, False, guarded)

    def test_growth_fails_only_with_budget(self):
        for seconds, guarded, passes in ((280, True, False), (280, False, True), (200, True, True)):
            passed, printed = self.run_with(seconds, guarded)
            self.assertEqual(passed, passes)
            self.assertEqual("GROWN     dev: tests" in printed, seconds == 280)


if __name__ == "__main__":
    unittest.main()
