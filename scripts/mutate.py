#!/usr/bin/env python3
"""Mutation test: changes the sources of a wing or a room one place at a time and reports undetected changes.

Each mutant is compiled beside the tree and linked in front of the library, so that nothing in the
checkout changes. A mutant that does not compile is replaced by another. The same seed draws the same
mutants from the same sources.

usage: ./dev mutate ROOM [--count N] [--seed S]
"""

import argparse
import os
import random
import re
import shlex
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import compile_commands
import mutants
import rooms

TREE = Path(__file__).resolve().parent.parent
DEV = TREE / "build/dev"
LONGEST = 60  # seconds beyond three times what the tests take without a mutant


def is_loaded_library(path):
    """Whether the source belongs to the library of MPI, which the tests load instead of linking it."""
    return path.is_relative_to(TREE / "src/base/mpi")


class Room:
    """The tests of a wing, linked or run with a mutant of one of its rooms."""

    def __init__(self, name):
        wing = name.split("/")[0]
        self.is_program = wing == "program"
        self.tests = DEV / "tests" / f"{wing}_tests"
        folder = TREE / rooms.Table.folder(*name.split("/"))
        self.sources = [path for path in sorted(folder.rglob("*.cc")) if not is_loaded_library(path)]
        self.compile = compile_commands.by_file(DEV)
        self.link = self.link_command("somato" if self.is_program else f"tests/{wing}_tests")
        self.seconds = self.measure()

    @staticmethod
    def link_command(target):
        commands = subprocess.run(["ninja", "-C", str(DEV), "-t", "commands", target],
                                  capture_output=True, text=True, check=True).stdout
        return commands.splitlines()[-1].split(" && ")[1]

    def measure(self):
        started = time.monotonic()
        if not self.passes(DEV / "somato" if self.is_program else self.tests, "*", None):
            sys.exit(f"./dev mutate: the tests of '{self.name}' fail without a mutant")
        return time.monotonic() - started

    def passes(self, linked, cases, limit):
        """Whether the cases pass in `linked`, or with `linked` as the tested program."""
        tests = self.tests if self.is_program else linked
        try:
            done = subprocess.run([tests, "--gtest_brief=1", "--gtest_fail_fast",
                                   f"--gtest_filter={cases}"], cwd=DEV / "tests",
                                  env=dict(os.environ, SOMATO_PROGRAM=str(linked)),
                                  capture_output=True, timeout=limit)
        except subprocess.TimeoutExpired:
            return False
        return done.returncode == 0

    def build(self, mutant, folder):
        """The binary linked with `mutant`, or None if it does not compile."""
        command, compiled = self.compile[mutant.file]
        source = folder / mutant.file.name
        source.write_text(mutant.text(), encoding="utf-8")
        if compiled != mutant.file:  # the sources that are compiled together, one of them broken
            together = folder / compiled.name
            text = compiled.read_text(encoding="utf-8")
            together.write_text(text.replace(f'"{mutant.file.relative_to(TREE)}"', f'"{source}"'), encoding="utf-8")
            source = together
        words = shlex.split(command)
        original = words[words.index("-o") + 1]
        words[words.index("-o") + 1] = str(folder / "mutant.o")
        words[words.index("-c") + 1] = str(source)
        # Only for quoted includes: a room's png.h must not stand in for the system's.
        words += ["-iquote", str(mutant.file.parent), "-w"]
        if subprocess.run(words, cwd=DEV, capture_output=True).returncode != 0:
            return None
        # In front of the library, whose own object is then not taken.
        linked = folder / "linked"
        link = self.link.replace(f" {original} ", " ")
        link = re.sub(r" -o \S+", f" {folder / 'mutant.o'} -o {linked}", link, count=1)
        subprocess.run(link, shell=True, cwd=DEV, capture_output=True, check=True)
        return linked

    def mirrored_cases(self, file):
        """A filter for the test cases of `file`, which are the most likely to detect the mutant."""
        folder = Path("tests") / rooms.read().place_of(file.relative_to(TREE))[0]
        text = "".join(test.read_text(encoding="utf-8") for test in (TREE / folder).rglob(f"{file.stem}_test.cc"))
        return ":".join(f"{suite}.*" for suite in sorted(set(re.findall(r"^TEST\w*\((\w+)", text,
                                                                       re.MULTILINE))))

    def try_mutant(self, mutant):
        """"caught", "survived" or "does not compile"."""
        with tempfile.TemporaryDirectory() as folder:
            linked = self.build(mutant, Path(folder))
            if linked is None:
                return "does not compile"
            limit = LONGEST + 3 * self.seconds
            mirrored = self.mirrored_cases(mutant.file)
            if mirrored and not self.passes(linked, mirrored, limit):
                return "caught"
            return "survived" if self.passes(linked, "*", limit) else "caught"


def draw(room, count, seed):
    """Tries mutants until `count` of them compile; returns those that survived."""
    drawn = mutants.of_files(room.sources)
    random.Random(seed).shuffle(drawn)
    survivors, tried, started = [], 0, time.monotonic()
    with ThreadPoolExecutor(2) as pool:
        while tried < count and drawn:
            some, drawn = drawn[:count - tried], drawn[count - tried:]
            for mutant, outcome in zip(some, pool.map(room.try_mutant, some)):
                if outcome == "does not compile":
                    continue
                tried += 1
                print(f"{tried:3} {time.monotonic() - started:6.0f} s  {outcome:8}  {mutant}",
                      flush=True)
                if outcome == "survived":
                    survivors.append(mutant)
    return tried, survivors


def parse_arguments():
    parser = argparse.ArgumentParser(prog="./dev mutate", description=__doc__.split("\n")[0])
    parser.add_argument("room", help="a wing or a room, such as maps or maps/online")
    parser.add_argument("--count", type=int, default=20, help="number of mutants (default: 20)")
    parser.add_argument("--seed", type=int, default=1, help="seed of the choice (default: 1)")
    given = parser.parse_args()
    table = rooms.read()
    known = [*table.wings, *(f"{wing}/{room}" for wing in table.wings for room in table.rooms(wing))]
    known.remove("base/mpi")
    if given.room not in known:
        parser.error(f"'{given.room}' is not a room; there are: {', '.join(known)}")
    if given.count < 1:
        parser.error("--count must be at least 1")
    return given


def main():
    given = parse_arguments()
    subprocess.run(["cmake", "--build", str(DEV), "--target", f"{given.room.split('/')[0]}_tests"], check=True)
    tried, survivors = draw(Room(given.room), given.count, given.seed)
    print(f"\n{given.room}: {tried} mutants, {len(survivors)} survived"
          + (":" if survivors else ""))
    for mutant in survivors:
        print(f"  {mutant}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
