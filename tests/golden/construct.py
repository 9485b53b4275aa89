#!/usr/bin/env python3
"""Writes the golden files of formats whose commits were not built, from what these commits document: docs/reference/results.md
for results.json, src/studies/journal.cc and src/studies/part_file.cc for the others. No program of Somato takes part.

usage: construct.py FOLDER
"""

import argparse
import json
from pathlib import Path

POLYNOMIAL = 0x82F63B78  # CRC-32C, reversed


def crc32c(data):
    value = 0xFFFFFFFF
    for byte in data:
        value ^= byte
        for _ in range(8):
            value = (value >> 1) ^ (POLYNOMIAL if value & 1 else 0)
    return value ^ 0xFFFFFFFF


def checked_line(content):
    """A line of a journal or a part: the checksum, a blank, JSON with sorted keys and without blanks."""
    text = json.dumps(content, sort_keys=True, separators=(",", ":"))
    return f"{crc32c(text.encode()):08x} {text}\n"


def study_results(version):
    """A results.json of a study, versions 2 and 3 of docs/reference/results.md."""
    metrics = {"accuracy": {"mean": 1.0, "sd": 0.0, "values": [1.0]}}
    run = {"seed": 1, "winners": [0, 3], "labels": ["cup", "ball"], "predictions": ["cup", "ball"]}
    system = {"name": "grasps", "protocol": "train_is_test", "label": "object", "samples": 2, "metrics": metrics, "runs": [run]}
    return {"version": version, "study": "grasps", "seeds": 1, "settings": {"study": {"name": "grasps"}},
            "data_hash": "fnv1a64:0123456789abcdef", "systems": [system]}


def reproduction_results():
    """A results.json of a reproduction, version 1 of src/studies/reproduction.cc."""
    return {"version": 1, "seed": 2011, "pairs": 1, "recordings": [], "systems": [], "claims": [], "not_applicable": []}


def part(version):
    """A part of a sweep with one metric; versions before 3 had a name in each protocol."""
    protocol = {"group": "", "label": "object", "metrics": [["accuracy", [1.0], []]], "protocol": "train_is_test", "samples": 6}
    if version < 3:
        protocol["name"] = "grasps"
    if version > 3:
        protocol["chosen_neighbours"] = {}
    return {"somato_part": version, "question": "", "system": "grasps", "variation": "", "recordings": ["grasps.mcap"],
            "pairs": [[0, 2011]], "protocols": [protocol]}


def files():
    yield "results-2-constructed.json", json.dumps(study_results(2), indent=1) + "\n"
    yield "results-3-constructed.json", json.dumps(study_results(3), indent=1) + "\n"
    yield "reproduction-1-constructed.json", json.dumps(reproduction_results(), separators=(",", ":")) + "\n"
    for version in (1, 2, 3, 4, 5, 6):  # the first, of c4220103, has no checksums: journal-1-c4220103.jsonl
        yield f"journal-{version}-constructed.journal", checked_line({"somato_journal": version, "study": "name = \"grasps\"\n"})
    for version in (1, 2, 4):
        yield f"part-{version}-constructed.found", checked_line(part(version))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("folder", type=Path)
    folder = parser.parse_args().folder
    for name, text in files():
        (folder / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
