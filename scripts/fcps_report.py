#!/usr/bin/env python3
"""Trains maps on the FCPS point sets and writes the results: a table and pictures.

usage: fcps_report.py --data FOLDER --out OUT [--seeds FIRST-LAST] [--program FILE]
                      [--no-pictures] [FLAG=VALUE]...

FOLDER contains Atom.data, Chainlink.data, Hepta.data, Target.data and TwoDiamonds.data: one point per
line, numbers separated by blanks, without labels. LINES below lists the classes by line number.
FLAG=VALUE are flags of `somato som train` without dashes, such as iterations=20000, which replace or
supplement those of SETTINGS.

OUT gets SET.labels, table.md and, for each set, SET.svg: the map of the first seed on its grid of
PICTURES. docs/fcps.md shows them.
"""

import argparse
import statistics
import subprocess
import sys
from pathlib import Path

# Lines of each class, from 1, inclusive. Target's single points are its outliers.
LINES = {
    "Hepta": {"1": [(1, 32)], "2": [(33, 62)], "3": [(63, 92)], "4": [(93, 122)],
              "5": [(123, 152)], "6": [(153, 182)], "7": [(183, 212)]},
    "Chainlink": {"first ring": [(1, 500)], "second ring": [(501, 1000)]},
    "Atom": {"hull": [(1, 400)], "core": [(401, 800)]},
    "Target": {"core": [(5, 399)], "ring": [(404, 766)],
               "corner 1": [(1, 1), (400, 400), (767, 767)],
               "corner 2": [(2, 2), (401, 401), (768, 768)],
               "corner 3": [(4, 4), (403, 403), (770, 770)],
               "corner 4": [(3, 3), (402, 402), (769, 769)]},
    "TwoDiamonds": {"left": [(1, 400)], "right": [(401, 800)]},
}
GRIDS = [(lattice, topology) for lattice in ("rectangular", "hexagonal")
         for topology in ("plane", "torus")]
PICTURES = {"Hepta": ("hexagonal", "plane"), "Chainlink": ("hexagonal", "torus"),
            "Atom": ("hexagonal", "plane"), "Target": ("hexagonal", "plane"),
            "TwoDiamonds": ("rectangular", "plane")}
SETTINGS = {"rows": "20", "columns": "20", "iterations": "40000", "radius-end": "0.5"}
MEASURES = ["quantization_error", "topographic_error", "accuracy", "individuals_apart",
            "areas_connected"]
SHARES = {"individuals_apart", "areas_connected"}  # yes or no; the table gives the number of seeds


def labels_of(name):
    """The label of each line of a set."""
    by_line = {line: label for label, ranges in LINES[name].items()
               for first, last in ranges for line in range(first, last + 1)}
    return [by_line[line] for line in range(1, len(by_line) + 1)]


def somato(options, *arguments):
    done = subprocess.run([options.program, "som", *map(str, arguments)], check=False,
                          capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stderr.strip())
    return done.stdout


def train(options, name, grid, seed):
    """Trains one map; returns its file."""
    settings = dict(SETTINGS, lattice=grid[0], topology=grid[1], seed=seed)
    settings.update(flag.split("=", 1) for flag in options.flags)
    path = options.out / f"{name}.somato"
    flags = [part for flag, value in settings.items() for part in (f"--{flag}", value)]
    somato(options, "train", options.data / f"{name}.data", "--labels",
           options.out / f"{name}.labels", "-o", path, *flags)
    return path


def measure(options, name, path):
    """The measures of a map, as numbers."""
    printed = somato(options, "quality", path, options.data / f"{name}.data", "--labels",
                     options.out / f"{name}.labels")
    values = dict(line.split() for line in printed.splitlines())
    return {key: float({"true": 1, "false": 0}.get(values[key], values[key])) for key in MEASURES}


def cell(key, values):
    if key in SHARES:
        return f"{round(sum(values))} of {len(values)}"
    return f"{statistics.mean(values):.3f} ± {statistics.stdev(values):.3f}"


def rows_of(options, name):
    """The table's rows of one set."""
    for grid in GRIDS:
        found = [measure(options, name, train(options, name, grid, seed)) for seed in options.seeds]
        cells = [cell(key, [values[key] for values in found]) for key in MEASURES]
        yield f"| {name} | {grid[0]} {grid[1]} | " + " | ".join(cells) + " |"


def draw(options, name):
    path = train(options, name, PICTURES[name], options.seeds[0])
    somato(options, "plot", path, options.data / f"{name}.data", "--labels",
           options.out / f"{name}.labels", "--panels", "labels,u_matrix", "-o",
           options.out / f"{name}.svg")


def seeds_of(text):
    first, last = text.split("-")
    return list(range(int(first), int(last) + 1))


def main():
    parser = argparse.ArgumentParser(description="FCPS point sets on Somato's maps")
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("flags", nargs="*", help="FLAG=VALUE of somato som train")
    parser.add_argument("--seeds", type=seeds_of, default=seeds_of("1-10"))
    parser.add_argument("--program", default="build/release/somato")
    parser.add_argument("--no-pictures", action="store_true")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    table = ["| set | grid | " + " | ".join(MEASURES) + " |",
             "|---|---|" + "---|" * len(MEASURES)]
    for name in LINES:
        (options.out / f"{name}.labels").write_text("\n".join(labels_of(name)) + "\n",
                                                    encoding="utf-8")
        table += rows_of(options, name)
        if not options.no_pictures:
            draw(options, name)
    (options.out / "table.md").write_text("\n".join(table) + "\n", encoding="utf-8")
    print(*table, sep="\n")


if __name__ == "__main__":
    main()
