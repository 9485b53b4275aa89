#!/usr/bin/env python3
"""Writes examples/synthetic_grasps/trials: a made-up hand closing on made-up objects.

    make_synthetic_grasps.py FOLDER

writes FOLDER/OBJECT_TRIAL.txt in the text format that `import_icub_grasp` reads. Everything is
arithmetic with seeded noise; nothing was recorded or simulated. Only +, -, * and / and Python's
`random.Random(seed).random()` are used, so the bytes are the same on every machine.
"""

import pathlib
import random
import sys

SEED = 1
TRIALS = 5
FINGERS = 5
TAXELS = 12

# Width in mm that the fingers close on, from index to ring and little finger; how round the object
# is, 1 where the fingers lie around it and 0 where they lie flat on it.
OBJECTS = {
    "ball_small": ((57.0, 64.0, 57.0), 1.0),
    "ball_large": ((69.0, 76.0, 69.0), 1.0),
    "cylinder_small": ((58.0, 58.0, 58.0), 0.8),
    "cylinder_large": ((70.0, 70.0, 70.0), 0.8),
    "block_small": ((60.0, 60.0, 60.0), 0.2),
    "block_large": ((72.0, 72.0, 72.0), 0.2),
}

OPEN_HAND = (25.0, 45.0, 5.0, 3.0, 4.0, 3.0, 5.0, 4.0, 8.0)  # the nine joints, deg

PLACEMENT_NOISE = 1.7  # mm, of the object's position in the hand and its width at a finger
JOINT_NOISE = 0.7  # deg, of every reading
TAXEL_NOISE = 1.0  # counts, of every reading
REST = 244.0  # counts of a taxel without pressure


def normal(source):
    """Approximately normal with mean 0 and deviation 1: the sum of twelve uniform numbers.

    Not by sum(), which rounds otherwise since Python 3.12.
    """
    total = -6.0
    for _ in range(12):
        total += source.random()
    return total


def proximal_angle(width):
    """The angle at which a finger stops, which is smaller for wider objects."""
    return 95.0 - 0.75 * width


def distal_angle(width, roundness):
    """The flexion of a fingertip, which is larger on round objects than on flat ones."""
    return 30.0 + 22.0 * roundness - 0.2 * width


def closed_hand(source, widths, roundness):
    """The nine joint angles at the end of a grasp, deg."""
    shift = PLACEMENT_NOISE * normal(source)
    index, middle, ring = (w + shift + PLACEMENT_NOISE * normal(source) for w in widths)
    bend = roundness + 0.12 * normal(source)
    return (
        25.0 - 0.6 * (middle - (index + ring) / 2.0),
        60.0 + 0.25 * middle,
        proximal_angle(middle) * 0.6,
        distal_angle(middle, bend) * 0.8,
        proximal_angle(index),
        distal_angle(index, bend),
        proximal_angle(middle),
        distal_angle(middle, bend),
        2.0 * proximal_angle(ring),
    )


def smooth(progress):
    """Smooth transition from 0 to 1."""
    return progress * progress * (3.0 - 2.0 * progress)


def pressed_counts(source, contact, strength, roundness, taxel):
    """A taxel's reading; a round object presses mainly on the middle of a fingertip."""
    from_middle = (taxel - 5.5) / 5.5
    share = 1.0 - roundness * from_middle * from_middle
    counts = REST - 60.0 * contact * strength * share + TAXEL_NOISE * normal(source)
    return min(255.0, max(0.0, float(int(counts + 0.5))))


def numbers(values, digits):
    return " ".join(f"{value:.{digits}f}" for value in values)


def step_lines(source, progress, final, strengths, roundness):
    """The seven lines of one time step; touch begins when four fifths of the way are done."""
    closed = smooth(min(1.0, progress / 0.8))
    contact = max(0.0, progress - 0.8) / 0.2
    joints = [
        start + closed * (end - start) + JOINT_NOISE * normal(source)
        for start, end in zip(OPEN_HAND, final)
    ]
    taxels = [
        [pressed_counts(source, contact, strengths[f], roundness, t) for t in range(TAXELS)]
        for f in range(FINGERS)
    ]
    pressures = [255.0 - min(finger) for finger in taxels]
    return [numbers(joints, 3), numbers(pressures, 1)] + [numbers(f, 1) for f in taxels]


def grasp(source, widths, roundness):
    """The text of one grasp."""
    final = closed_hand(source, widths, roundness)
    strengths = [0.9 + 0.1 * source.random() for _ in range(FINGERS)]
    steps = 11 + int(3.0 * source.random())
    lines = ["-10000"]
    for step in range(steps):
        lines += step_lines(source, step / (steps - 1), final, strengths, roundness)
    return "\n".join(lines) + "\n"


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    source = random.Random(SEED)
    for name, (widths, roundness) in OBJECTS.items():
        for trial in range(1, TRIALS + 1):
            text = grasp(source, widths, roundness)
            (folder / f"{name}_{trial}.txt").write_bytes(text.encode("ascii"))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main()
