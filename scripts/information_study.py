#!/usr/bin/env python3
"""Measures the information in the simulated hands' recordings under several conditions, and writes
tables.

usage: information_study.py --out OUT [--seeds FIRST-LAST] [--program FILE] [--studies FOLDER]
                            [--threads N] [--keep-recordings]

Every condition is explored once with each seed; each seed has different placements and noise.
`somato information` then measures the vectors of each study. Completed measurements are stored in
OUT/figures and not repeated, so an interrupted run can be resumed. OUT/tables.md contains the tables
of docs/studies/simulated-hands.md, mean and standard deviation over the seeds.
"""

import argparse
import json
import re
import statistics
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True)
class Hand:
    """A body, the studies by which its recordings are measured, and the measured labels."""
    body: str
    studies: dict = field(hash=False)  # by the name in the tables: file, channel of touch
    noises: tuple  # mm; the rotation is 2 degrees per mm
    flags: tuple  # flags of `somato information`


@dataclass(frozen=True)
class Condition:
    hand: Hand
    noise: float
    free: bool

    @property
    def name(self):
        return f"{self.hand.body}_{self.noise:g}mm_{self.held_or_free}"

    @property
    def held_or_free(self):
        return "free" if self.free else "held"


CHANNEL_OF_TOUCH = r'(\[module\.touch\][^[]*?\nchannel = )"\w+"'
EVERY_READING = """[simulation]
touch_threshold = 0.0
piezo_converter = "bipolar"
"""
HAND_2 = Hand(
    "lucs2",
    {"chain, force": ("tensor_chain.toml", "touch"),
     "product, force": ("single_tensor_product.toml", "touch"),
     "chain, change": ("tensor_chain.toml", "touch_change"),
     "product, change": ("single_tensor_product.toml", "touch_change")},
    (0, 1, 2, 4),
    ("--labels", "object,shape", "--individual", "object"))
HAND_3 = Hand(
    "lucs3", {"joints": ("shape_and_size.toml", None)}, (0, 0.5, 1, 2, 4),
    ("--labels", "object,shape", "--individual", "object", "--order", "girth", "--within", "shape"))
HANDS = (HAND_2, HAND_3)
CONDITIONS = [Condition(hand, noise, free)
              for hand in HANDS for free in (False, True) for noise in hand.noises]

DONE_WITH_LOSSES = 3  # exit code: some explorations failed and are not recorded


def read_options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--seeds", default="101-106", help="FIRST-LAST")
    parser.add_argument("--program", default="build/release/somato")
    parser.add_argument("--studies", type=Path, default=Path("systems"))
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--keep-recordings", action="store_true")
    options = parser.parse_args()
    first, _, last = options.seeds.partition("-")
    options.seeds = range(int(first), int(last or first) + 1)
    return options


def somato(options, *arguments, may_lose=False):
    """Runs the program and passes its reports of losses to standard error."""
    done = subprocess.run([options.program, *map(str, arguments)], check=False,
                          capture_output=True, text=True)
    if done.returncode != 0 and not (may_lose and done.returncode == DONE_WITH_LOSSES):
        sys.exit(f"somato {' '.join(map(str, arguments))}\n{done.stderr.strip()}")
    if done.stderr:
        print(done.stderr.strip(), file=sys.stderr)


def write_studies(options, hand):
    """The study files of a hand, with their channel of touch, by their names in the tables."""
    folder = options.out / "studies"
    folder.mkdir(parents=True, exist_ok=True)
    files = {}
    for name, (file, channel) in hand.studies.items():
        text = (options.studies / file).read_text(encoding="utf-8")
        if channel:
            text, found = re.subn(CHANNEL_OF_TOUCH, rf'\1"{channel}"', text)
            if found != 1:
                sys.exit(f"{file} has no module \"touch\" with a channel")
        files[name] = folder / f"{Path(file).stem}_{channel or 'all'}.toml"
        files[name].write_text(text, encoding="utf-8")
    return files


def figures_of(options, condition, study_file, seed):
    return options.out / "figures" / f"{condition.name}_{seed}_{study_file.stem}.json"


def explore(options, condition, seed):
    """Records a condition once, every reading of the sensors; returns the recording's file."""
    settings = options.out / "settings.toml"
    settings.write_text(EVERY_READING, encoding="utf-8")
    recording = options.out / f"{condition.name}_{seed}.mcap"
    somato(options, "explore", "--body", condition.hand.body, "--seed", seed,
           "--settings", settings, "--placement-noise", condition.noise,
           "--free", str(condition.free).lower(), "--threads", options.threads, "-o", recording, may_lose=True)
    return recording


def measure(options, condition, seed, study_files):
    """Runs the missing explorations and measurements."""
    missing = [file for file in study_files
               if not figures_of(options, condition, file, seed).exists()]
    if not missing:
        return
    recording = explore(options, condition, seed)
    for file in missing:
        somato(options, "information", file, "--data", recording, *condition.hand.flags,
               "--threads", options.threads, "-o", figures_of(options, condition, file, seed))
    if not options.keep_recordings:
        recording.unlink()


def run_all(options, studies):
    (options.out / "figures").mkdir(parents=True, exist_ok=True)
    tasks = [(condition, seed) for condition in CONDITIONS for seed in options.seeds]
    begin = time.monotonic()
    for done, (condition, seed) in enumerate(tasks):
        left = (time.monotonic() - begin) / done * (len(tasks) - done) if done else 0
        print(f"{done + 1} of {len(tasks)}: {condition.name}, seed {seed}; {left:.0f} s left",
              file=sys.stderr, flush=True)
        measure(options, condition, seed, studies[condition.hand].values())


class Figures:
    """The measurements of one condition with one study: a list over the seeds."""

    def __init__(self, options, condition, study_file):
        self.all = [json.loads(figures_of(options, condition, study_file, seed).read_text("utf-8"))
                    for seed in options.seeds]

    def label(self, label, figure):
        return [next(about[figure] for about in one["labels"] if about["label"] == label)
                for one in self.all]

    def order(self, figure):
        return [one["order"][figure] for one in self.all]

    def explorations(self):
        return [one["explorations"] for one in self.all]


def spread(values):
    """Mean and standard deviation over the seeds."""
    if any(value is None for value in values):
        return "–"
    deviation = statistics.stdev(values) if len(values) > 1 else 0.0
    return f"{statistics.mean(values):.2f} ± {deviation:.2f}"


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def place_of(condition):
    return [f"{condition.noise:g} mm", condition.held_or_free]


def accuracies_and_ratios(figures):
    """Accuracies and ratios that both hands' tables show."""
    return [spread(figures.label("object", "accuracy")),
            spread(figures.label("shape", "accuracy")),
            spread(figures.label("shape", "accuracy_new_individuals")),
            spread(figures.label("object", "distance_ratio")),
            spread(figures.label("shape", "distance_ratio"))]


MEASURES = ["object", "shape", "shape, new objects", "ratio, objects", "ratio, shapes"]


def table_of_codes(options, conditions, files):
    rows = [[*place_of(condition), name, *accuracies_and_ratios(Figures(options, condition, file))]
            for condition in conditions for name, file in files.items()]
    return table(["placement", "", "code", *MEASURES], rows)


def compared(first, second):
    """Differences of the first and the second, recording by recording."""
    differences = [a - b for a, b in zip(first, second)]
    more = sum(difference > 1e-9 for difference in differences)
    less = sum(difference < -1e-9 for difference in differences)
    mean = statistics.mean(differences)
    deviation = statistics.stdev(differences) if len(differences) > 1 else 0.0
    return f"{mean:+.3f} ± {deviation:.3f} ({more}, {less})"


def table_of_differences(options, conditions, files):
    rows = []
    for condition in conditions:
        for channel in ("force", "change"):
            chain = Figures(options, condition, files[f"chain, {channel}"])
            product = Figures(options, condition, files[f"product, {channel}"])
            compared_labels = [("object", "accuracy"), ("shape", "accuracy"),
                     ("shape", "accuracy_new_individuals"), ("object", "distance_ratio")]
            rows.append([*place_of(condition), channel,
                         *(compared(chain.label(*one), product.label(*one)) for one in compared_labels)])
    return table(["placement", "", "touch", *MEASURES[:4]], rows)


def table_of_joints(options, conditions, files):
    rows = []
    for condition in conditions:
        figures = Figures(options, condition, files["joints"])
        rows.append([*place_of(condition), *accuracies_and_ratios(figures), spread(figures.order("correlation")),
                     spread(figures.order("shuffled")), spread(figures.order("shuffled_share"))])
    return table(["placement", "", *MEASURES, "size order", "shuffled", "as high by chance"], rows)


def chances(options, condition, file):
    figures = Figures(options, condition, file)
    parts = [f"object {spread(figures.label('object', 'chance'))}",
             f"shape {spread(figures.label('shape', 'chance'))}",
             f"shape of new objects {spread(figures.label('shape', 'chance_new_individuals'))}"]
    return "Chance: " + ", ".join(parts) + ".\n"


def losses(options, conditions, files):
    """The conditions with fewer explorations than the others."""
    counts = {condition: Figures(options, condition, next(iter(files.values()))).explorations()
              for condition in conditions}
    most = max(max(numbers) for numbers in counts.values())
    lost = [f"{condition.name}: {', '.join(str(number) for number in numbers)}"
            for condition, numbers in counts.items() if min(numbers) < most]
    return f"{most} explorations per recording" + (
        "; fewer in " + "; ".join(lost) if lost else ", none lost") + ".\n"


def tables(options, studies):
    text = []
    for hand in HANDS:
        conditions = [condition for condition in CONDITIONS if condition.hand == hand]
        files = studies[hand]
        text += [f"## {hand.body}\n", losses(options, conditions, files),
                 chances(options, conditions[0], next(iter(files.values())))]
        if hand == HAND_2:
            text += [table_of_codes(options, conditions, files),
                     "Chain less product, on the same recordings; in brackets in how many it is "
                     "higher, lower.\n", table_of_differences(options, conditions, files)]
        else:
            text.append(table_of_joints(options, conditions, files))
    return "\n".join(text)


def main():
    options = read_options()
    studies = {hand: write_studies(options, hand) for hand in HANDS}
    run_all(options, studies)
    (options.out / "tables.md").write_text(tables(options, studies), encoding="utf-8")
    print(f"Written: {options.out / 'tables.md'}")


if __name__ == "__main__":
    main()
