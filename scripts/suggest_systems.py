#!/usr/bin/env python3
"""Writes the suggested systems of systems/announced again, or compares them.

usage: suggest_systems.py --out OUT [--program FILE] [--check]

Each body explores as for a system of the papers, with seed 1, which is not among the seeds of the
recordings on which the systems are compared, and `somato suggest` searches in this recording. With
--check the files are compared with those of systems/announced instead of replacing them.
"""

import argparse
import subprocess
import sys
from pathlib import Path

STUDIES = {"suggested_lucs2": "tensor_chain", "suggested_lucs3": "shape_and_size",
           "suggested_probes": "texture"}
FOLDER = Path(__file__).resolve().parents[1] / "systems" / "announced"


def read_options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--program", default="build/release/somato")
    parser.add_argument("--check", action="store_true")
    return parser.parse_args()


def recording_for(study, options):
    """A recording of `somato reproduce`, which stores it in its folder."""
    out = options.out / study
    subprocess.run([options.program, "reproduce", study, "--seed", "1", "--recordings", "1", "--pairs",
                    "1", "--out", str(out), "--quiet"], check=True)
    recordings = [path for path in out.rglob("*.mcap") if "-new-" not in path.name]
    if len(recordings) != 1:
        sys.exit(f"suggest_systems: {out} must contain one recording; remove it")
    return recordings[0]


def main():
    options = read_options()
    different = []
    for name, study in STUDIES.items():
        written = options.out / f"{name}.toml" if options.check else FOLDER / f"{name}.toml"
        subprocess.run([options.program, "suggest", str(recording_for(study, options)), "-o",
                        str(written), "--name", name, "--study", study], check=True)
        if written.read_bytes() != (FOLDER / f"{name}.toml").read_bytes():
            different.append(name)
    if different:
        sys.exit(f"suggest_systems: differ from systems/announced: {', '.join(different)}")


if __name__ == "__main__":
    main()
