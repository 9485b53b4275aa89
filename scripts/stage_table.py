"""The seconds that each stage of ./dev test took, beside those of an earlier state of the project."""

import json
import os
from pathlib import Path

TREE = Path(__file__).resolve().parent.parent
TIMES = TREE / "build/stage_seconds.json"

# What a stage finds that no other stage does, and the seconds that it took on two cores before cases
# shared processes and headers were precompiled (commit f8e6f4e).
STAGES = {
    "set-up": ("a package that a fresh machine lacks", None),
    "checks": ("format, includes between rooms, missing mirrors, wording, shell mistakes", None),
    "dev: build": ("what clang warns of, with all warnings as errors", 748),
    "dev: tests": ("wrong results, messages and pages; commands of the documentation that fail", 511),
    "long tests": ("an installed package that cannot be used; long workflows", None),
    "asan: build": ("nothing; the next stage needs it", 678),
    "asan: tests": ("wrong memory accesses, leaks, undefined behaviour", 390),
    "tsan: build": ("nothing; the next stage needs it", 306),
    "tsan: tests": ("data races", 105),
    "gcc: build": ("what g++ warns of; sources that only clang accepts", None),
    "gcc: tests": ("results that depend on the compiler or on the optimization of a release", None),
    "clang-tidy": ("unsafe and superfluous constructs, names, sources that lack an include", None),
}


def seconds_of():
    return json.loads(TIMES.read_text(encoding="utf-8")) if TIMES.is_file() else {}


def note(stage, seconds):
    TIMES.parent.mkdir(exist_ok=True)
    TIMES.write_text(json.dumps({**seconds_of(), stage: round(seconds)}), encoding="utf-8")


def table():
    """Markdown: a line for each stage."""
    now = seconds_of()
    lines = [f"On {os.cpu_count()} cores, in seconds:", "",
             "| stage | before | now | finds what no other stage finds |", "|---|---|---|---|"]
    for stage, (finds, before) in STAGES.items():
        shown = [str(value) if value is not None else "-" for value in (before, now.get(stage))]
        lines.append(f"| {stage} | {shown[0]} | {shown[1]} | {finds} |")
    lines.append(f"| all | | {sum(now.get(stage, 0) for stage in STAGES)} | |")
    return "\n".join(lines)
