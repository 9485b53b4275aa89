#!/usr/bin/env python3
"""Presses of a stage with a force sensor, as those of a probe that stops at a constant force: one depth each."""
import csv
import pathlib
import sys

RATE = 97.0  # rows a second
SPEED = 2.5  # mm/s: steps of 1 mm, one each 0.4 s
TOUCHED, FORCE = 0.1, 1.0  # N
COUNTS = 100.0  # a mm, as a converter of 12 bits over 40.96 mm

print("material,trial,depth")
for path in sorted(pathlib.Path(sys.argv[1]).glob("Material_*_raw_*.csv")):
    force = [float(row["Fz"]) for row in csv.DictReader(path.open())]
    end = next(i for i, value in enumerate(force) if value >= FORCE)
    begin = max(i for i in range(end) if force[i] < TOUCHED)
    _, material, _, trial = path.stem.split("_")
    print(f"{material},{trial},{round((end - begin) / RATE * SPEED * COUNTS)}")
