#!/usr/bin/env python3
"""Compares suggested systems with those made by hand on public data sets, and writes a table.

usage: suggest_study.py --data FOLDER --out OUT [--seeds N] [--program FILE] [--threads N] [--only SET]

FOLDER contains the data sets (docs/public-data.md). The explorations of each set are divided into two
halves. `somato suggest` searches in the first one, without labels; all systems are then trained and
tested on the second half only, with held-out explorations. Completed runs are not repeated. OUT/table.md
contains the table of docs/suggest.md.
"""

import argparse
import csv
import json
import re
import statistics
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Callable


@dataclass(frozen=True)
class DataSet:
    """A set in its folder: its files, and whether a file belongs to the half that is searched."""
    name: str
    format: str
    label: str
    files: str  # pattern
    is_searched: Callable
    protocol: str
    systems: tuple  # made by hand
    channels: tuple  # name, and 10 points or the bands of a spectrum


def trial_below(limit):
    return lambda path: int(re.search(r"_(\d+)\.\w+$", path.name)[1]) < limit


def first_days(path):
    """The first three impacts of each surface in the order of time."""
    root = path.parents[1]
    with open(root / "index.tsv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file, delimiter="\t"))
    own = next(row for row in rows if row["file"].endswith(path.name))
    same = sorted(row["timestamp"] for row in rows if row["material"] == own["material"])
    return same.index(own["timestamp"]) < len(same) / 2


SETS = (
    DataSet("icub_grasp", "icub_grasp", "object", "trials/*.txt", trial_below(8), "k_folds",
            ("studies/icub_joints", "studies/icub_change", "studies/icub_tensor",
             "studies/icub_t_mpsom", "systems/recorded/single_tensor_product_icub",
             "systems/recorded/tensor_chain_icub", "systems/recorded/t_mpsom_multiplied_icub",
             "systems/recorded/t_mpsom_added_icub", "systems/recorded/shape_and_size_icub"),
            (("joints", "points"), ("finger_pressure", "points"), ("taxels", "points"))),
    DataSet("fabricslide", "fabricslide", "fabric", "fabric/*.csv", trial_below(1), "k_folds",
            ("studies/fabricslide", "systems/recorded/texture_fabricslide"),
            (("touch", "points"), ("speed", "points"))),
    DataSet("hkust_press_slide", "hkust_press_slide", "material", "data_raw/*.csv", trial_below(4),
            "leave_one_out",
            ("studies/hkust_press", "systems/recorded/texture_hkust",
             "systems/recorded/hardness_hkust", "systems/recorded/combined_hkust",
             "systems/recorded/bimodal_hkust"),
            (("force", "points"),)),
    DataSet("acoustic_hardness", "acoustic_hardness", "material", "phase0/*.json", first_days,
            "leave_one_out",
            ("studies/acoustic_surface", "systems/recorded/texture_acoustic",
             "systems/recorded/hardness_acoustic"),
            (("sound", "bands"),)),
)


METRICS = ("accuracy", "baseline_accuracy_raw", "baseline_accuracy_standardized")


def read_options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--program", default="build/release/somato")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--only", help="name of a data set")
    return parser.parse_args()


def halves_of(data_set, options):
    """Folders with links to the files of either half."""
    root = (options.data / data_set.name).resolve()
    halves = []
    for half in ("searched", "tested"):
        folder = options.out / data_set.name / half
        halves.append(folder)
        if folder.exists():
            continue
        for path in sorted(root.glob(data_set.files)):
            if data_set.is_searched(path) != (half == "searched"):
                continue
            link = folder / path.relative_to(root)
            link.parent.mkdir(parents=True, exist_ok=True)
            link.symlink_to(path)
    return halves


def run(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"suggest_study: {' '.join(map(str, arguments))}: {done.stderr.strip()}")


def suggested(data_set, searched, options):
    """The file of the suggested system, and the seconds of the search."""
    path = options.out / data_set.name / "suggested.toml"
    recording = path.with_name("searched.mcap")
    if not recording.exists():
        run(options.program, "import", data_set.format, searched, "-o", recording)
    begin = time.monotonic()
    run(options.program, "suggest", recording, "-o", path, "--label", data_set.label,
        "--threads", options.threads)
    return path, time.monotonic() - begin


def concatenated(data_set, options):
    """All channels, each as ten points of the exploration or as bands of its spectrum."""
    text = f'[study]\nname = "concatenated"\nlabel = "{data_set.label}"\nprotocols = ["leave_one_out"]\n'
    for channel, form in data_set.channels:
        code = ('type = "resampling"\npoints = 10' if form == "points"
                else 'type = "spectrum"\nsegment_length = 4096\nbands = 24')
        text += (f'\n[module.{channel}]\ntype = "channel"\nchannel = "{channel}"\n'
                 f'\n[module.vector_of_{channel}]\n{code}\ninput = "{channel}"\n')
    inputs = ", ".join(f'"vector_of_{channel}"' for channel, _ in data_set.channels)
    text += (f'\n[module.all]\ntype = "concatenation"\ninputs = [{inputs}]\n'
             '\n[module.standardized]\ntype = "standardization"\ninput = "all"\n'
             'constant_columns = "zero"\n'
             '\n[module.map]\ntype = "som"\ninput = "standardized"\niterations = 20000\n'
             'radius_end = 0.5\n')
    path = options.out / data_set.name / "concatenated.toml"
    path.write_text(text, encoding="utf-8")
    return path


def with_protocol(path, data_set, folder):
    """The study with the protocol by which all are compared."""
    text = path.read_text(encoding="utf-8")
    keys = "protocols|groups|folds|fold_choice|label|labels|order|within|individual"
    text = re.sub(rf"^({keys}) = .*\n", "", text, flags=re.MULTILINE)
    study = (f'[study]\nlabel = "{data_set.label}"\nprotocols = ["{data_set.protocol}"]\n' +
             ('folds = 5\nfold_choice = "interleaved"\n' if data_set.protocol == "k_folds" else ""))
    changed = folder / path.name
    changed.write_text(text.replace("[study]\n", study), encoding="utf-8")
    return changed


def accuracies_of(path, data_set, tested, options):
    """The metrics of a study on the second half, from a stored or a new run."""
    out = options.out / data_set.name / "runs" / path.stem
    if not (out / "results.json").exists():
        folder = options.out / data_set.name / "studies"
        folder.mkdir(exist_ok=True)
        run(options.program, "run", with_protocol(path, data_set, folder), "--data", tested,
            "--seeds", options.seeds, "--threads", options.threads, "--out", out)
    results = json.loads((out / "results.json").read_text(encoding="utf-8"))
    (protocol,) = results["parts"][0]["protocols"]
    return protocol["metrics"]


def figure(values):
    mean = statistics.fmean(values)
    spread = statistics.stdev(values) if len(values) > 1 else 0.0
    return f"{mean:.3f} ± {spread:.3f}" if spread else f"{mean:.3f}"


def rows_of(data_set, options):
    searched, tested = halves_of(data_set, options)
    path, seconds = suggested(data_set, searched, options)
    studies = [path, *(Path(f"{name}.toml") for name in data_set.systems),
               concatenated(data_set, options)]
    for study in studies:
        found = accuracies_of(study, data_set, tested, options)
        name = f"{study.stem} ({seconds:.1f} s)" if study == path else study.stem
        figures = [figure(found[metric]["values"]) for metric in METRICS]
        yield f"| {data_set.name} | {name} | " + " | ".join(figures) + " |"


def main():
    options = read_options()
    lines = ["| set | system | map | nearest neighbour, raw | standardized |", "|---|---|---|---|---|"]
    for data_set in SETS:
        if options.only not in (None, data_set.name):
            continue
        for line in rows_of(data_set, options):
            print(line, flush=True)
            lines.append(line)
    (options.out / "table.md").write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
