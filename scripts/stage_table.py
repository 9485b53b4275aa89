"""Durations of the stages of ./dev test, compared with an earlier state of the project."""

import json
import os
from pathlib import Path

TREE = Path(__file__).resolve().parent.parent
TIMES = TREE / "build/stage_seconds.json"


def seconds_of():
    return json.loads(TIMES.read_text(encoding="utf-8")) if TIMES.is_file() else {}


def note(stage, seconds):
    TIMES.parent.mkdir(exist_ok=True)
    TIMES.write_text(json.dumps({**seconds_of(), stage: round(seconds)}), encoding="utf-8")


def table(stages):
    """Markdown: a line for each stage."""
    now = seconds_of()
    lines = [f"On {os.cpu_count()} cores, in seconds:", "",
             "| stage | before | now | faults that only this stage finds |", "|---|---|---|---|"]
    for stage in stages:
        shown = ["-" if value is None else str(value) for value in (stage.before, now.get(stage.name))]
        lines.append(f"| {stage.name} | {shown[0]} | {shown[1]} | {stage.finds} |")
    lines.append(f"| all | | {sum(now.get(stage.name, 0) for stage in stages)} | |")
    return "\n".join(lines)
