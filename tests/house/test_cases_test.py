import contextlib
import io
import json
import os
import unittest
from unittest import mock

from support import TreeTest

import test_cases

# A stand-in for ctest: writes the tests that it was to run beside the reports of a build.
CTEST = """#!/usr/bin/env python3
import json, os, sys
words = sys.argv[1:]
build = words[words.index("--test-dir") + 1]
with open(build + "/ran.json", "w") as file:
    json.dump([words[words.index("-R") + 1] if "-R" in words else "", os.environ.get("GTEST_FILTER")], file)
with open(words[words.index("--output-junit") + 1], "w") as file:
    file.write(open(build + "/wanted.xml").read())
os.makedirs(build + "/test_cases", exist_ok=True)
for name, suites in json.load(open(build + "/wanted.json")).items():
    json.dump({"testsuites": suites}, open(f"{build}/test_cases/{name}.json", "w"))
"""


def suite(*cases):
    return [{"testsuite": [
        dict({"classname": "Grid", "name": name, "time": f"{seconds}s"},
             **({"failures": []} if failed else {})) for name, seconds, failed in cases]}]


class TestCases(TreeTest):
    def setUp(self):
        super().setUp()
        path = self.write("bin/ctest", CTEST)
        path.chmod(0o755)
        self.enterContext(mock.patch.dict(
            os.environ, PATH=f"{path.parent}{os.pathsep}{os.environ['PATH']}"))

    def run_with(self, tests, reports, runner=None):
        self.write("wanted.xml", "<testsuite>" + "".join(
            f'<testcase name="{name}" time="{seconds}" status="{status}"/>'
            for name, seconds, status in tests) + "</testsuite>")
        self.write("wanted.json", json.dumps(reports))
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            passed = runner(self.tree) if runner else test_cases.run(self.tree, [])
        return passed, printed.getvalue()

    def test_names_the_slowest_cases(self):
        passed, printed = self.run_with(
            [("maps.som", 3, "run"), ("web.view", 9, "run")],
            {"maps.som": suite(("Quick", 0.1, False), ("Slow", 2.5, False))})
        self.assertTrue(passed)
        lines = [line.split("s  ")[-1] for line in printed.splitlines() if " s  " in line]
        self.assertEqual(lines, ["web.view", "maps.som: Grid.Slow", "maps.som: Grid.Quick"])
        self.assertIn("3 cases in 2 processes", printed)

    def test_runs_failed_cases_of_a_room(self):
        passed, printed = self.run_with(
            [("maps.som", 3, "fail"), ("maps.grid", 3, "run"), ("web.view", 9, "fail")],
            {"maps.som": suite(("A", 1, True), ("B", 1, False)), "maps.grid": suite(("C", 1, False))})
        self.assertFalse(passed)
        self.assertIn("FAILED    maps.som: Grid.A\n", printed)
        self.assertIn("FAILED    web.view\n", printed)
        passed, _ = self.run_with([("maps.som", 1, "run")], {"maps.som": suite(("A", 1, False))},
                                  test_cases.run_failed)
        self.assertTrue(passed)
        names, cases = json.loads((self.tree / "ran.json").read_text())
        self.assertEqual((names, cases), (r"^(web\.view|maps\.som)$", "Grid.A"))
        self.assertEqual(self.run_with([], {}, test_cases.run_failed)[1],
                         "No test failed in the last run.\n")

    def test_a_room_that_crashed_runs_again_whole(self):
        self.assertFalse(self.run_with([("maps.som", 3, "fail")], {})[0])
        self.run_with([("maps.som", 3, "run")], {}, test_cases.run_failed)
        self.assertEqual(json.loads((self.tree / "ran.json").read_text()),
                         [r"^(maps\.som)$", None])

    def test_no_test_at_all_is_a_failure(self):
        self.assertFalse(self.run_with([], {})[0])


if __name__ == "__main__":
    unittest.main()
