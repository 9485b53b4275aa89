#!/usr/bin/env python3
"""Counts the instructions of the kernels on 64-bit ARM, with qemu-user, and prints them as a table.

usage: guard_arm64.py BUILD

BUILD is a folder of the preset arm64, with its targets guard_arm64 and guard_arm64_scalar. The columns are the portable
kernels that the compiler did not vectorize, those that it vectorized as it can, the ones of NEON, and how many times
fewer instructions the latter take. Exit status: 1 if a kernel takes too many, or the sets give other bits.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

COUNTER = Path(__file__).resolve().parent / "instruction_counter.cc"

# What fills the time of training and of searches: the kernels for which NEON takes at least so many times fewer
# instructions than portable ones that are not vectorized, in single and in double precision.
LEAST = {"single": 3.0, "double": 1.6}
PRODUCTS = ("inner_products", "sparse_inner_products", "squared_norms")
PROMISED = {
    "single": {f"float.{name}" for name in (*PRODUCTS, "squared_distances", "move_towards", "scale_rows",
                                            "clear_negligible")}
              | {"distance.absolute", "distance.greatest", "distance.squares", "distance.products",
                 "batch.screen", "batch.score", "batch.least", "online.multiply", "online.multiply_block",
                 "online.multiply_long_rows", "online.combine", "online.combine_row"},
    "double": {f"double.{name}" for name in (*PRODUCTS, "squared_distances", "move_towards", "scale_rows",
                                             "clear_negligible")}
              | {"batch.squared_distance", "batch.inner_product", "batch.absolute_distance", "batch.mix",
                 "product.add_products", "product.products_with", "product.least", "product.move"},
}


def build_counter(folder):
    counter = Path(folder) / "counter.so"
    subprocess.run(["g++", "-std=gnu++20", "-shared", "-fPIC", "-O2", "-o", counter, COUNTER], check=True)
    return counter


def count(counter, program, instruction_set):
    """The digest and the number of instructions of each part, by name."""
    counts = counter.with_name("counts")
    done = subprocess.run(["qemu-aarch64", "-plugin", f"{counter},to={counts}", program, instruction_set],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"guard_arm64: {program} {instruction_set}: {done.stderr.strip()}")
    numbers = [int(line) for line in counts.read_text(encoding="utf-8").split()]
    parts = [line.split() for line in done.stdout.splitlines()]
    return {name: (digest, number) for (name, digest), number in zip(parts, numbers, strict=True)}


def kind_of(name):
    return next((kind for kind, names in PROMISED.items() if name in names), "")


def rows(scalar, vectorized, neon):
    """For each part: name, kind, three counts and two ratios."""
    for name, (_, number) in neon.items():
        plain, automatic = scalar[name][1], vectorized[name][1]
        yield name, kind_of(name), plain, automatic, number, plain / number, automatic / number


def print_table(table):
    print("| kernel | promised | portable | vectorized by the compiler | NEON | times fewer | than vectorized |")
    print("| --- | --- | ---: | ---: | ---: | ---: | ---: |")
    for name, kind, plain, automatic, number, ratio, of_automatic in table:
        print(f"| `{name}` | {kind} | {plain} | {automatic} | {number} | {ratio:.1f} | {of_automatic:.1f} |")


def problems(table, *counted):
    for name, kind, *_, ratio, _ in table:
        if kind and ratio < LEAST[kind]:
            yield f"{name}: {ratio:.2f} times fewer, {LEAST[kind]} are promised"
    for name in counted[0]:
        if len({each[name][0] for each in counted}) > 1:
            yield f"{name}: other bits"
    for name in set().union(*PROMISED.values()) - counted[0].keys():
        yield f"{name}: not counted"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    programs = Path(sys.argv[1]) / "tests"
    with tempfile.TemporaryDirectory() as folder:
        counter = build_counter(folder)
        scalar = count(counter, programs / "guard_arm64_scalar", "portable")
        vectorized = count(counter, programs / "guard_arm64", "portable")
        neon = count(counter, programs / "guard_arm64", "neon")
    table = list(rows(scalar, vectorized, neon))
    print_table(table)
    found = list(problems(table, scalar, vectorized, neon))
    print(*found, sep="\n", end="\n" if found else "", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
