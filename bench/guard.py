#!/usr/bin/env python3
"""Fails if kernels and small trainings take more instructions than recorded.

Instructions do not depend on who else uses the machine. Callgrind counts them with each set of
instructions that it knows (AVX-512 is not among them); the counts in guard.json are those of one
compiler each. Exit status: 0 no more than before, 1 more, 3 no counts of this compiler.

usage: ./dev bench --guard [--update]
"""

import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

TREE = Path(__file__).resolve().parent.parent
GUARD = TREE / "build/bench/bench/guard"
KNOWN = TREE / "bench/guard.json"
SETS = ("portable", "avx2")
ALLOWED = 0.02  # allowed relative increase of instructions
NOTHING_KNOWN = 3
PART = re.compile(r"^desc: Trigger: Client Request: (?P<name>\S+)\n(?:.*\n)*?summary: (?P<count>\d+)",
                  re.MULTILINE)


def count(instruction_set):
    """The number of instructions of each part of the program, by name."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/counts", GUARD,
             instruction_set], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"guard: {instruction_set}: {done.stderr.strip().splitlines()[-1]}")
        texts = [path.read_text(encoding="utf-8") for path in Path(folder).iterdir()]
    found = [match for text in texts if (match := PART.search(text))]
    return {match["name"]: int(match["count"]) for match in sorted(found, key=lambda m: m["name"])}


def compare(instruction_set, counted, known):
    """Parts above the allowance, one line each."""
    for name in sorted(counted.keys() | known.keys()):
        if name not in counted or name not in known:
            where = "guard.json" if name not in known else "the program"
            yield f"{instruction_set} {name}: not in {where}; --update when that is meant"
        elif counted[name] > known[name] * (1 + ALLOWED):
            yield (f"{instruction_set} {name}: {counted[name]} instructions, {known[name]} before "
                   f"(+{100 * (counted[name] / known[name] - 1):.1f} %)")


def less(counted, known):
    """Number of parts that take fewer instructions by more than the allowance."""
    return sum(counted[name] < known.get(name, 0) * (1 - ALLOWED) for name in counted)


def save(known):
    """Atomic: the file is written completely or not at all."""
    part = KNOWN.with_suffix(".part")
    part.write_text(json.dumps(known, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    os.replace(part, KNOWN)


def report(counts, of_compiler):
    problems = [line for name in SETS for line in compare(name, counts[name], of_compiler.get(name, {}))]
    fewer = sum(less(counts[name], of_compiler.get(name, {})) for name in SETS)
    if fewer:
        print(f"guard: {fewer} parts take fewer instructions than recorded; record the new counts with --update")
    print(*problems, sep="\n", end="\n" if problems else "", file=sys.stderr)
    total = sum(len(counts[name]) for name in SETS)
    print(f"guard: {total} counts, {len(problems)} above {100 * ALLOWED:.0f} % or unknown")
    return 1 if problems else 0


def main():
    compiler = subprocess.run([GUARD, "--compiler"], capture_output=True, text=True,
                              check=True).stdout.strip()
    known = json.loads(KNOWN.read_text(encoding="utf-8")) if KNOWN.exists() else {}
    if "--update" not in sys.argv and compiler not in known:
        print(f"guard: no counts are recorded for {compiler}, so nothing is compared; recorded compilers: "
              f"{', '.join(known) or 'none'}", file=sys.stderr)
        return NOTHING_KNOWN
    counts = {name: count(name) for name in SETS}
    if "--update" in sys.argv:
        save(known | {compiler: counts})
        print(f"guard: counts of {compiler} written")
        return 0
    return report(counts, known[compiler])


if __name__ == "__main__":
    sys.exit(main())
