#!/usr/bin/env python3
"""Runs clang-tidy over the library, the program and the fuzzers, in parallel.

A file that passed, in this checkout or another one of the user, is not checked again until it, a project
header that it includes, its compile command, the rules or the version of clang-tidy change. Sources that are
compiled together are checked together, because reading headers takes most of the time.

--changed: only files that differ from the parent branch, and for a header the first source that includes it.
Each of them is read separately and without precompiled headers, so that a missing include and an unused using
declaration are reported. Changed tests are compiled in this way, and not checked further. A change of more than
MOST_SEPARATE files, such as a move of folders, is left to a run without --changed, which ./dev test --all
contains, and which does not find missing includes.

usage: run_clang_tidy.py [--fix] [--changed]
"""

import argparse
import os
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import compile_commands
import passed_marks
from changed_files import changed_files, included_by

TREE = Path(__file__).resolve().parent.parent
SEPARATE = TREE / "build/lint"
# The static analyzer walks included sources only if the path of the including file contains this name.
TOGETHER = SEPARATE / "UnifiedSource"
REUSED = "reused_marks"  # number of marks that the last run has used
CHECKED = ("src", "program", "fuzz")
COMPILED = "tests"
MOST_SEPARATE = 150  # some ten minutes
TIDY = str(TREE / "build/clang-tidy/bin/clang-tidy")


def entries(build, folders=CHECKED):
    """The files of `folders` to check with their compile commands, in the folder `build`."""
    options = ["-DSOMATO_SOURCES_AT_ONCE=1"] if build == SEPARATE else []
    subprocess.run(["cmake", "--preset", "dev", "-B", str(build), *options,
                    "-DSOMATO_BUILD_PYTHON=OFF", "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON"],
                   cwd=TREE, stdout=subprocess.DEVNULL, check=True)
    return {compiled: command for source, (command, compiled) in compile_commands.by_file(build).items()
            if source.is_relative_to(TREE) and source.relative_to(TREE).parts[0] in folders}


def only_changed(files):
    """The changed files among `files`, and one source for each changed header."""
    changed = changed_files()
    chosen = {file for file in files if file in changed}
    unseen = {file for file in changed if file.suffix == ".h"}
    for file in sorted(files):
        if not unseen:
            break
        known = set()
        reached(file, known)
        if known & unseen:
            chosen.add(file)
            unseen -= known
    return {file: files[file] for file in chosen}


def reached(path, known):
    """`path` and the project headers that it includes, directly or indirectly."""
    if path in known:
        return
    known.add(path)
    for header in included_by(path):
        reached(header, known)


def key_of(file, command, options):
    known = set()
    reached(file, known)
    rules = [TREE / ".clang-tidy", TREE / "scripts/clang_tidy.txt"]  # the version is in the second
    return passed_marks.key_of(TREE, [command, *options], [*rules, *sorted(known)])


def options_for(build):
    return ["--checks=-bugprone-suspicious-include"] if build == TOGETHER else []


def check(build, file, command, fix):
    """Returns whether `file` passes, and whether a mark says so."""
    options = options_for(build)
    key = key_of(file, command, options)
    if passed_marks.has(key):
        return True, True
    if file.relative_to(TREE).parts[0] == COMPILED:
        reader = [*shlex.split(command), "-fsyntax-only"]
    else:
        reader = [TIDY, "-p", str(build), "--quiet", *options, *(["--fix", "--fix-errors"] if fix else []), str(file)]
    done = subprocess.run(reader, cwd=build, capture_output=True, text=True)
    if done.returncode != 0:
        print(done.stdout, done.stderr, sep="", end="", file=sys.stderr)
        return False, False
    if not fix:  # a fix has changed the file whose key this is
        passed_marks.add(key)
    return True, False


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--fix", action="store_true")
    parser.add_argument("--changed", action="store_true")
    given = parser.parse_args()
    fix = given.fix
    build = SEPARATE if given.changed else TOGETHER
    files = only_changed(entries(build, (*CHECKED, COMPILED))) if given.changed else entries(build)
    if given.changed and len(files) > MOST_SEPARATE:
        print(f"{len(files)} files have changed, too many to read one by one for missing includes: ./dev test --all reads "
              "all together")
        return 0
    passed_marks.prune()
    # Two at once would write the same header's fixes twice.
    with ThreadPoolExecutor(1 if fix else os.cpu_count()) as pool:
        results = list(pool.map(lambda item: check(build, *item, fix), sorted(files.items())))
    marked = sum(by_mark for _, by_mark in results)
    print(f"{len(files)} files, {marked} of which have passed before")
    (SEPARATE / REUSED).write_text(str(marked), encoding="utf-8")
    return 0 if all(passed for passed, _ in results) else 1


if __name__ == "__main__":
    sys.exit(main())
