#!/usr/bin/env python3
"""Builds and tests Somato in stages, each of which detects faults that no other stage detects.

usage: ./dev test              the stages required for every change
       ./dev test --all        all stages; a stage that has passed for the same tree is not repeated
       ./dev test ROOM...      the tests of these wings and rooms only, such as maps or maps/online
       ./dev test --changed    the checks, and the tests that the changes since the parent branch can reach
       ./dev test --failed     the tests that failed when tests were last run
       ./dev test --rooms      the rooms that have tests
       ./dev test --budget     like ./dev test; fails if a stage or a test takes 30 % more processor time than in
                               scripts/budget.txt
       ./dev test --update-budget
                               writes the figures of the last runs to scripts/budget.txt
       ./dev test --table      the stages with the seconds of their last runs, as docs/testing.md shows
"""

import argparse
import difflib
import hashlib
import os
import resource
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import budget
import changed_run
import changed_tests
import fixed_job
import stage_table
import test_cases

TREE = Path(__file__).resolve().parent.parent
DEV = TREE / "build/dev"


@dataclass(frozen=True)
class Stage:
    name: str
    run: callable  # returns whether the stage passes
    finds: str  # faults that no other stage detects
    before: int | None = None  # seconds on two cores at commit f8e6f4e
    preset: str = ""  # whose build folder it needs
    thorough: bool = False  # for --all only


def passes(*command):
    return subprocess.run(command, cwd=TREE).returncode == 0


def command(*words):
    return lambda: passes(*words)


def tests(preset, *selection):
    return lambda: test_cases.run(TREE / "build" / preset, selection)


# With g++, the tests of the wings whose results are numbers, and what is not in the wheel, for which g++
# compiles the program.
GCC_WINGS = ["base", "maps", "systems"]
NOT_IN_WHEEL = ["somato_topics"]


def build_gcc():
    return passes("cmake", "--preset", "gcc") and passes(
        "cmake", "--build", "build/gcc", "--target", *NOT_IN_WHEEL, "same_bits_group", *[f"{wing}_tests" for wing in GCC_WINGS])


STAGES = [
    Stage("set-up", command("scripts/setup.sh", "build", "test"),
          "packages missing on a fresh machine"),
    Stage("checks", command("scripts/lint.sh"),
          "wrong format, crowded rooms, forbidden includes between rooms and of private headers, missing mirrored tests, forbidden wording, "
          "types of the pages that differ from their schema, errors in shell scripts"),
    Stage("dev: build", command("./dev", "build", "dev"),
          "clang warnings, all treated as errors", 748, "dev"),
    Stage("dev: tests", tests("dev", "-LE", "^long$"),
          "wrong results, messages and pages; failing commands in the documentation", 511, "dev"),
    Stage("long tests", tests("dev", "-L", "^long$"),
          "an unusable installed package or Python wheel; g++ warnings of the program; a broken link or page of the "
          "site, undocumented public symbols; harmful damaged inputs (5,000 of them) and boundary values",
          None, "dev", thorough=True),
    Stage("asan: build", command("./dev", "build", "asan"), "nothing; required by the next stage",
          678, "asan", thorough=True),
    # The long tests repeat others with more cases, and have run without a sanitizer.
    Stage("asan: tests", tests("asan", "-LE", "^long$"), "invalid memory accesses, leaks, undefined behaviour",
          390, "asan", thorough=True),
    Stage("tsan: build", command("./dev", "build", "tsan"), "nothing; required by the next stage",
          306, "tsan", thorough=True),
    Stage("tsan: tests", tests("tsan"), "data races", 105, "tsan", thorough=True),
    Stage("gcc: build", build_gcc, "g++ warnings of the library; its sources that only clang accepts",
          None, "gcc", thorough=True),
    Stage("gcc: tests", tests("gcc", "-L", f"^({'|'.join([*GCC_WINGS, 'same_bits'])})$", "-LE", "^long$", "-E", "mpi"),
          "results that depend on the compiler or on release optimization",
          None, "gcc", thorough=True),
    Stage("clang-tidy", command("scripts/run_clang_tidy.py"),
          "unsafe and redundant constructs, naming",
          None, "lint", thorough=True),
]


def tree_hash():
    """Hash of the contents of all files of the tree that git does not ignore."""
    names = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                           cwd=TREE, capture_output=True, check=True).stdout.split(b"\0")
    digest = hashlib.sha256()
    for name in sorted(set(filter(None, names))):
        path = TREE / os.fsdecode(name)
        if path.is_file():
            digest.update(name + b"\0" + hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()


def mark_of(stage):
    """File with the hash of the tree on which the stage has passed; in the build folder."""
    name = stage.name.replace(": ", "-").replace(" ", "-")
    return TREE / "build" / stage.preset / "passed_stages" / name


def has_passed(stage, tree):
    mark = mark_of(stage)
    return mark.is_file() and mark.read_text(encoding="utf-8") == tree


def children_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def cache_hits():
    """Results that ccache has found so far; 0 without ccache."""
    try:
        printed = subprocess.run(["ccache", "--print-stats"], capture_output=True, text=True).stdout
    except FileNotFoundError:
        return 0
    return sum(int(count) for name, count in (line.split("\t") for line in printed.splitlines() if "\t" in line)
               if name in ("direct_cache_hit", "preprocessed_cache_hit"))


class Reuse:
    """Counts results of earlier runs that a stage reuses: with them it takes less than its budget."""

    def __init__(self, stage):
        self.hits = cache_hits()
        self.marks = TREE / "build/lint/reused_marks"
        self.marks.unlink(missing_ok=True)
        built = TREE / "build" / stage.preset / "build.ninja"
        self.built = int(stage.name.endswith("build") and built.is_file())

    def count(self):
        marks = int(self.marks.read_text(encoding="utf-8")) if self.marks.is_file() else 0
        return self.built + marks + cache_hits() - self.hits


# The set-up depends on what the machine lacks, and the checks on how many files a branch has changed.
WITHOUT_BUDGET = ("set-up", "checks")


def entries_of(stage, seconds):
    """Processor seconds by entry of the budget."""
    if stage.name in WITHOUT_BUDGET:
        return {}
    of_tests = stage.name.endswith("tests")
    folder = TREE / "build" / stage.preset / test_cases.TIMES
    return {stage.name: seconds, **(budget.seconds_of_tests(folder, stage.preset) if of_tests else {})}


def run_stage(stage, tree):
    """Returns whether the stage passes, its line of the summary and its processor seconds by entry."""
    print(f"\n== {stage.name}", flush=True)
    mark_of(stage).unlink(missing_ok=True)
    started, used = time.monotonic(), children_seconds()
    passed = stage.run()
    seconds, used = time.monotonic() - started, children_seconds() - used
    if passed:
        mark_of(stage).parent.mkdir(parents=True, exist_ok=True)
        mark_of(stage).write_text(tree, encoding="utf-8")
        stage_table.note(stage.name, seconds)
    line = f"{'ok    ' if passed else 'FAILED'} {seconds:6.0f} s {used:6.0f} s of processors  {stage.name}"
    return passed, line, entries_of(stage, used)


def measured(stage, tree, unit_before):
    """Runs a stage between two fixed jobs. Returns whether it passes, its line, figures and the second unit."""
    reuse = Reuse(stage)
    passed, line, seconds = run_stage(stage, tree)
    reused = reuse.count()
    unit = fixed_job.measure()
    figures = budget.Figures(seconds, (unit_before + unit) / 2, reused)
    if passed:
        budget.note(stage.name, figures)
    return passed, line, figures, unit


def run_stages(thorough, guarded=False):
    """Runs the stages in order up to the first failure; returns whether all pass, and keep to the budget if
    `guarded`."""
    tree, units = tree_hash(), budget.read()
    summary, runs = [], []
    passed = True
    unit = fixed_job.measure()
    for stage in STAGES:
        if stage.thorough and not thorough:
            continue
        if thorough and has_passed(stage, tree):
            summary.append(f"ok    earlier   {stage.name} (passed on the same tree)")
            continue
        passed, line, figures, unit = measured(stage, tree, unit)
        summary.append(line)
        runs.append(figures)
        if not passed:
            break
    print("\n" + "\n".join(summary))
    within = budget.report(runs, units)
    if passed and not thorough:
        left_out = ", ".join(stage.name for stage in STAGES if stage.thorough)
        print(f"Not run without --all: {left_out}")
    if guarded and not within:
        print("FAILED    the budget: make it faster, or raise the lines with ./dev test --update-budget")
    return passed and (within or not guarded)


def report_tests():
    """Compares the tests that ran last in the build folder `dev` with the budget, which decides nothing here."""
    seconds = budget.seconds_of_tests(DEV / test_cases.TIMES, "dev")
    print(f"{sum(seconds.values()):.0f} s of processors for these tests")
    budget.report([budget.Figures(seconds, fixed_job.measure())], budget.read())


def rooms():
    listed = subprocess.run(["ctest", "--test-dir", str(DEV), "--print-labels"],
                            capture_output=True, text=True, check=True).stdout
    labels = {line.strip() for line in listed.splitlines() if line.startswith("  ")}
    return sorted(labels - {"long"})


def configure():
    return (DEV / "CTestTestfile.cmake").is_file() or passes("cmake", "--preset", "dev")


def check_rooms(wanted):
    known = rooms()
    for room in wanted:
        if room not in known:
            near = difflib.get_close_matches(room, known, 1)
            wings = [room for room in known if "/" not in room]
            advice = f"did you mean '{near[0]}'?" if near else f"there are: {', '.join(wings)}, and their rooms"
            sys.exit(f"./dev test: '{room}' is not a room with tests; {advice}")


def run_rooms(wanted, thorough):
    if not configure():
        return False
    check_rooms(wanted)
    if not passes("cmake", "--build", str(DEV), "--target", *sorted({f"{room.split('/')[0]}_group" for room in wanted})):
        return False
    selection = ["-L", f"^({'|'.join(wanted)})$"] + ([] if thorough else ["-LE", "^long$"])
    passed = test_cases.run(DEV, selection)
    report_tests()
    others = ", ".join(room for room in rooms() if "/" not in room and not any(
        one.split("/")[0] == room for one in wanted))
    print(f"Not run: the tests of {others}, and of other rooms; {'' if thorough else 'long tests; '}"
          "all checks; sanitizers; the second compiler")
    return passed


def run_failed():
    if not configure() or not passes("cmake", "--build", str(DEV)):
        return False
    passed = test_cases.run_failed(DEV)
    report_tests()
    print("Not run: tests that passed before; all checks; sanitizers; the second compiler")
    return passed


def run_changed():
    names = changed_run.changed_names()
    chosen = changed_tests.select(TREE, names)
    if chosen.unbounded:
        print(f"{', '.join(chosen.unbounded)} can reach every test: the whole ./dev test runs")
        return run_stages(thorough=False)
    print(f"{len(names)} files differ from the parent branch")
    if not passes("scripts/lint.sh") or not configure():
        return False
    passed = changed_run.run(chosen)
    report_tests()
    return passed


def parse_arguments():
    parser = argparse.ArgumentParser(prog="./dev test", usage=__doc__.split("usage: ")[1].replace("%", "%%"))
    parser.add_argument("rooms", nargs="*", metavar="ROOM")
    only = parser.add_mutually_exclusive_group()
    for flag in ("all", "changed", "failed", "rooms", "table", "budget", "update-budget"):
        only.add_argument(f"--{flag}", action="store_const", const=flag, dest="only")
    given = parser.parse_args()
    if given.rooms and given.only not in (None, "all"):
        parser.error(f"--{given.only} takes no rooms; omit {' '.join(given.rooms)}")
    return given


def print_rooms():
    if not configure():
        return False
    print("\n".join(rooms()))
    return True


def main():
    given = parse_arguments()
    if given.only == "table":
        print(stage_table.table(STAGES))
        return True
    if given.only == "update-budget":
        return budget.update()
    if given.only == "rooms":
        return print_rooms()
    if given.only == "failed":
        return run_failed()
    if given.only == "changed":
        return run_changed()
    if given.rooms:
        return run_rooms(given.rooms, given.only == "all")
    return run_stages(given.only == "all", given.only == "budget")


if __name__ == "__main__":
    try:
        sys.exit(0 if main() else 1)
    except budget.BudgetError as error:
        sys.exit(f"./dev test: {error}")
