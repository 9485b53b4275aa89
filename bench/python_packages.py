#!/usr/bin/env python3
"""Compares the Python packages of self-organizing maps, and writes the table of docs/python.md.

Every package runs in a process and an environment of its own (build/peers), with one thread. The same
samples, map and epochs; the column 'work' says what a package computes instead of a batch epoch. A round
runs all packages once, so that other load of the machine affects all alike; the figures are medians of
processor time over the rounds. A package that cannot be installed or run is listed with the reason.

usage: python_packages.py [--build FOLDER] [--rounds N] [--only PACKAGE]...
"""

import argparse
import array
import contextlib
import functools
import json
import os
import platform
import random
import struct
import subprocess
import sys
import tomllib
from pathlib import Path

import peer_environments
from driven import Driven, Failure, environment, last_line, median

TREE = Path(__file__).resolve().parent.parent
PEERS = TREE / "bench/peers"
PAGE = TREE / "docs/python.md"
FOLDER = TREE / "build/peers/data/python_packages"
BEGIN, END = "<!-- made by bench/python_packages.py -->", "<!-- end -->"
PATIENCE = 900  # seconds for an answer

SAMPLES, FEATURES, CLUSTERS, SIDE, EPOCHS = 5000, 64, 20, 20, 10
CASE = {"rows": SIDE, "columns": SIDE, "features": FEATURES, "samples": SAMPLES, "steps": EPOCHS,
        "batch": True, "sparse": False, "hexagonal": False, "whole": True, "radius_start": SIDE / 2,
        "radius_end": 1.0, "learning_rate_start": 0.5, "learning_rate_end": 0.01}


def write_npy(path, rows):
    """Rows of numbers as a file of numpy, float32 in C order."""
    header = f"{{'descr': '<f4', 'fortran_order': False, 'shape': ({len(rows)}, {len(rows[0])}), }}"
    header += " " * (-(len(header) + 11) % 64) + "\n"
    numbers = array.array("f", (number for row in rows for number in row))
    path.write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + numbers.tobytes())


def write_case():
    """Samples around random centres, and initial weights that are samples."""
    draw = random.Random(1)
    centres = [[draw.gauss(0, 1) for _ in range(FEATURES)] for _ in range(CLUSTERS)]
    samples = [[draw.gauss(number, 0.5) for number in centres[i % CLUSTERS]] for i in range(SAMPLES)]
    FOLDER.mkdir(parents=True, exist_ok=True)
    write_npy(FOLDER / "samples.npy", samples)
    write_npy(FOLDER / "initial.npy", draw.sample(samples, SIDE * SIDE))
    (FOLDER / "case.json").write_text(json.dumps(CASE), encoding="utf-8")


class Package:
    """A package: its description, its environment, and what was measured."""

    def __init__(self, name, described, python):
        self.name = name
        self.title = described.get("name", name)
        self.described = described
        self.python = python
        self.times = []

    @functools.cached_property
    def error(self):
        """The quantization error of the last map, computed in the same way for all packages."""
        file = FOLDER / f"{self.name}.npy"
        if not self.driven.ask(f"weights {file}").get("written"):
            return None
        return float(self.printed(PEERS / "judge.py", file, FOLDER / "samples.npy"))

    def printed(self, *words):
        done = subprocess.run([str(word) for word in (self.python, "-B", *words)], capture_output=True,
                              text=True, timeout=PATIENCE, check=False,
                              env=environment(1) | {"SCIPY_ARRAY_API": "1"})
        if done.returncode != 0:
            raise Failure(last_line(done.stderr))
        return done.stdout

    def version(self):
        if self.name == "pysomato":
            return "(this version)"
        text = self.printed("-c", "import importlib.metadata as m, sys; print(m.version(sys.argv[1]))", self.title)
        return text.strip()

    def check_functions(self):
        """Raises Failure if a function that the table mentions does not exist."""
        names = self.described["functions"]
        self.printed("-c", "import pydoc, sys\n"
                     "lost = [name for name in sys.argv[1:] if pydoc.locate(name) is None]\n"
                     "sys.exit(f'without {lost}' if lost else 0)", *names)

    def verdicts(self):
        return json.loads(self.printed(PEERS / "check_estimators.py", *self.described["estimators"]))

    def start(self, stack):
        command = [self.python, "-B", PEERS / "serve.py", self.name, "dense_batch", FOLDER, 1]
        self.driven = stack.enter_context(Driven(command, 1, PATIENCE))

    def run(self):
        self.times.append(self.driven.run()["processor_seconds"])


def described_packages():
    return tomllib.loads((PEERS / "python_packages.toml").read_text(encoding="utf-8"))


def python_of(name, build, say):
    if name == "pysomato":
        os.environ["PYTHONPATH"] = str(build / "python")
        return build / "python/environment/bin/python"
    return peer_environments.python_of(name, peer_environments.all_peers().get(name, {}), say)


def prepared(name, described, build, stack):
    """The package, started; or a row with the reason why it is left out."""
    say(f"{name}: installing and starting")
    try:
        package = Package(name, described, python_of(name, build, say))
        package.check_functions()
        package.checked = package.verdicts()
        package.start(stack)
        package.driven.run()  # the first run compiles and loads
        return package
    except (Failure, subprocess.TimeoutExpired) as failure:
        say(f"{name}: {failure}")
        return f"| {described.get('name', name)} | left out: {failure} | | | | | |"


def say(text):
    print(text, file=sys.stderr, flush=True)


def text_of(verdict):
    if "refused" in verdict:
        return "refused"
    return ", ".join(f"{number} {status}" for status, number in sorted(verdict.items(), key=lambda item: item[0] != "passed"))


def checks_of(package):
    """The verdicts, with the names of the classes if there are several."""
    several = len(package.checked) > 1
    return "; ".join((f"`{expression.split('(')[0].rpartition('.')[2]}` " if several else "") + text_of(verdict)
                     for expression, verdict in package.checked.items())


def row_of(package, first):
    seconds = median(package.times)
    ratio = median([mine / its for mine, its in zip(package.times, first.times)])
    spread = f"{min(package.times):.2g} to {max(package.times):.2g}"
    error = "" if package.error is None else f"{package.error:.3f}"
    described = package.described
    return (f"| {package.title} {package.version()} | {checks_of(package)} | {described['work']} | "
            f"{seconds:.2g} ({spread}) | {ratio:.1f} | {error} | {described['reads']} | {described['draws']} |")


def processor():
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return platform.machine()


def table_of(packages, rounds, load):
    head = ["package", "`check_estimator`", "work", "processor seconds", "times pysomato", "quantization error",
            "reads", "draws"]
    first = packages[0]
    rows = [package if isinstance(package, str) else row_of(package, first) for package in packages]
    text = (f"{SAMPLES} samples of {FEATURES} numbers in {CLUSTERS} clusters, {SIDE} x {SIDE} neurons, {EPOCHS} epochs, "
            f"radius {SIDE / 2:g} to 1 in the last epoch, one thread; median and range of {rounds} rounds on {processor()} "
            f"with a load of {load[0]:.1f} to {load[1]:.1f}; Python {platform.python_version()}. "
            "A package that learns online processes as many samples. The quantization error is computed by the same "
            "function for all maps; it also depends on the schedule, because a greater radius at the end keeps the map stiffer.")
    return "\n".join([text, "", f"| {' | '.join(head)} |", "|" + "---|" * len(head), *rows])


def replace_table(table):
    text = PAGE.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    PAGE.write_text(f"{before}{BEGIN}\n\n{table}\n\n{END}{rest.split(END)[1]}", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description="Writes the table of Python packages in docs/python.md.")
    parser.add_argument("--build", type=Path, default=TREE / "build/python",
                        help="build folder of pysomato; default: that of the preset python")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--only", action="append", help="this package, beside pysomato; prints the table")
    options = parser.parse_args()
    write_case()
    chosen = {name: described for name, described in described_packages().items()
              if not options.only or name in [*options.only, "pysomato"]}
    with contextlib.ExitStack() as stack:
        packages = [prepared(name, described, options.build.resolve(), stack)
                    for name, described in chosen.items()]
        if isinstance(packages[0], str):
            sys.exit(f"the other packages are compared with pysomato, which cannot run: {packages[0]}")
        load = [os.getloadavg()[0]]
        for number in range(options.rounds):
            say(f"round {number + 1}")
            for package in packages:
                if not isinstance(package, str):
                    package.run()
        load.append(os.getloadavg()[0])
        table = table_of(packages, options.rounds, sorted(load))
    if options.only:
        print(table)
    else:
        replace_table(table)


if __name__ == "__main__":
    main()
