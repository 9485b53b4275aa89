#!/usr/bin/env python3
"""Writes examples/synthetic_strokes/trials: a made-up finger stroking made-up fabrics.

    make_synthetic_strokes.py FOLDER

writes FOLDER/FABRIC_SPEEDmmps_TRIAL.csv. Everything is arithmetic with seeded noise; nothing was
recorded or simulated. Only +, -, * and / and Python's `random.Random(seed).random()` are used, so
the bytes are the same on every machine.
"""

import pathlib
import random
import sys

SEED = 1
TRIALS = 2
ROWS = 96
STEP_MS = 20
TAXELS = 4

# Ridges a millimetre: the only thing in which the fabrics differ.
FABRICS = {"coarse_rib": 0.04, "coarse_knit": 0.065, "fine_rib": 0.1, "fine_knit": 0.16}
SPEEDS = (40, 60, 80)  # mm/s
TAXEL_DISTANCE = 2.5  # mm, along the stroke
NOISE = 12.0  # counts, of every reading


def wave(phase):
    """About a sine: two parabolas a period, from -1 to 1."""
    u = 2.0 * (phase - int(phase)) - 1.0
    return 4.0 * u * (1.0 - abs(u))


def stroke(source, ridges, speed):
    """The text of one stroke."""
    start = 1000 + int(9000.0 * source.random())
    level = [400.0 + 200.0 * source.random() for _ in range(TAXELS)]
    strength = 60.0 + 60.0 * source.random()
    offset = source.random()
    temperature = 24.0 + source.random()
    lines = ["time_ms,temperature," + ",".join(f"taxel{t + 1}" for t in range(TAXELS))]
    for row in range(ROWS):
        way = speed * row * STEP_MS / 1000.0
        fields = [str(start + row * STEP_MS), f"{temperature:.1f}"]
        for taxel in range(TAXELS):
            phase = offset + ridges * (way + taxel * TAXEL_DISTANCE)
            noise = NOISE * (source.random() + source.random() - 1.0)
            fields.append(str(int(level[taxel] + strength * wave(phase) + noise)))
        lines.append(",".join(fields))
    return "\n".join(lines) + "\n"


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    source = random.Random(SEED)
    for fabric, ridges in FABRICS.items():
        for speed in SPEEDS:
            for trial in range(1, TRIALS + 1):
                text = stroke(source, ridges, speed)
                name = f"{fabric}_{speed}mmps_{trial}.csv"
                (folder / name).write_bytes(text.encode("ascii"))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main()
