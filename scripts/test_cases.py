"""Runs the tests of a build by ctest, and reports single cases: a room's cases share a process."""

import json
import os
import re
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

TREE = Path(__file__).resolve().parent.parent
JUNIT = "tests.xml"
FAILED = "failed_tests.json"  # what run_failed() runs: names of tests, and cases by test
TIMES = "test_times"  # folder with the processor times of the tests that ran
SLOWEST = 10
TESTS_OF_A_CORE = 4  # at once, because many wait for browsers, servers and emulated devices


def cases_of(build, name):
    """Cases of the test `name` as (seconds, case, failed); None if there is no report."""
    report = build / "test_cases" / f"{name}.json"
    if not report.is_file():
        return None
    suites = json.loads(report.read_text(encoding="utf-8"))["testsuites"]
    return [(float(case["time"].rstrip("s")), f"{case['classname']}.{case['name']}",
             "failures" in case) for suite in suites for case in suite["testsuite"]]


def run_ctest(build, selection, environment):
    """Returns the tests that ran as (name, seconds, failed)."""
    junit = build / JUNIT
    junit.unlink(missing_ok=True)
    for report in [*(build / "test_cases").glob("*.json"), *(build / TIMES).glob("*")]:
        report.unlink()
    subprocess.run(["ctest", "--test-dir", str(build), "-j", str(TESTS_OF_A_CORE * os.cpu_count()),
                    "--output-on-failure", "--no-tests=error", "--output-junit", str(junit),
                    *selection], env=dict(os.environ, **environment))
    if not junit.is_file():
        return None
    return [(case.get("name"), float(case.get("time")), case.get("status") != "run")
            for case in ElementTree.parse(junit).getroot().iter("testcase")]


def failures_of(build, tests):
    """Names of tests to run again completely, and the failed cases by test."""
    whole, by_test = [], {}
    for name, _, failed in tests:
        failed_cases = [case for _, case, wrong in cases_of(build, name) or [] if wrong]
        if failed and failed_cases:
            by_test[name] = failed_cases
        elif failed:
            whole.append(name)
    return whole, by_test


def print_slowest(build, tests):
    timed = []
    for name, seconds, _ in tests:
        cases = cases_of(build, name)
        timed += [(seconds, name)] if cases is None else [
            (took, f"{name}: {case}") for took, case, _ in cases]
    print(f"\n{len(timed)} cases in {len(tests)} processes; the slowest:")
    for seconds, name in sorted(timed, reverse=True)[:SLOWEST]:
        print(f"{seconds:8.1f} s  {name}")


def summarize(build, tests):
    if not tests:
        return False
    whole, by_test = failures_of(build, tests)
    (build / FAILED).write_text(json.dumps([whole, by_test]), encoding="utf-8")
    print_slowest(build, tests)
    for name in whole:
        print(f"FAILED    {name}")
    for name, cases in by_test.items():
        for case in cases:
            print(f"FAILED    {name}: {case}")
    return not whole and not by_test


def run(build, selection):
    """Runs the tests of ctest's `selection`; returns whether there are tests and all pass."""
    return summarize(build, run_ctest(build, selection, {}))


def run_failed(build):
    """Runs the tests that failed in the last run, by case if the cases are known."""
    record = build / FAILED
    whole, by_test = json.loads(record.read_text()) if record.is_file() else ([], {})
    if not whole and not by_test:
        print("No test failed in the last run.")
        return True
    names = [re.escape(name) for name in [*whole, *by_test]]
    cases = [case for of_test in by_test.values() for case in of_test]
    crashed = any((TREE / "tests" / name.replace(".", "/")).is_dir() for name in whole)
    environment = {"GTEST_FILTER": ":".join(cases)} if cases and not crashed else {}
    return summarize(build, run_ctest(build, ["-R", f"^({'|'.join(names)})$"], environment))
