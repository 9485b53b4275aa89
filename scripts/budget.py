"""Processor time of the stages and tests of ./dev test, compared with the budget in the repository.

Figures are in units: processor seconds, divided by those of a fixed job (fixed_job.py) measured in the same
run, so that they can be compared between machines. Entries are the names of stages, and PRESET: TEST.
"""

import json
import re
from dataclasses import dataclass
from pathlib import Path

TREE = Path(__file__).resolve().parent.parent
FILE = TREE / "scripts/budget.txt"
LAST = TREE / "build/processor_time.json"  # the last figures of each stage, for update()
NAMED = 0.10  # growth that is named at the end of a run
FAILS = 0.30  # growth with which ./dev test --budget fails
LEAST = 2.0  # processor seconds: less is noise
LINE = re.compile(r"(\S.*\S) +(\d+\.\d)")
HEADER = """\
# Processor time of the stages and tests of ./dev test, in units of scripts/fixed_job.py.
# docs/testing.md describes it; './dev test --update-budget' writes it after complete runs.
"""


class BudgetError(Exception):
    """The file of the budget cannot be used."""


@dataclass(frozen=True)
class Growth:
    name: str
    seconds: float
    allowed: float | None  # seconds; None if the budget has no line for it

    @property
    def share(self):
        return float("inf") if not self.allowed else self.seconds / self.allowed - 1

    def __str__(self):
        if self.allowed is None:
            return f"{self.name}: {self.seconds:.1f} s; the budget has no line for it"
        return f"{self.name}: {self.seconds:.1f} s instead of {self.allowed:.1f} s"


def read(file=None):
    file = file or FILE
    lines = file.read_text(encoding="utf-8").splitlines() if file.is_file() else []
    found = {}
    for number, line in enumerate(lines, 1):
        if not line or line.startswith("#"):
            continue
        match = LINE.fullmatch(line)
        if not match or match[1] in found:
            raise BudgetError(f"{file}:{number}: '{line}' is not a new name and a number of units, such as 'dev: maps  12.3'")
        found[match[1]] = float(match[2])
    return found


def text_of(units):
    width = max(map(len, units), default=0)
    return HEADER + "".join(f"{name:{width}}  {units[name]:8.1f}\n" for name in sorted(units))


def times_of(text):
    """Seconds of the children in what bash's `times` prints, or None if it is incomplete."""
    parts = re.findall(r"(\d+)m(\d+[.,]\d+)s", text)
    if len(parts) != 4:
        return None
    return sum(60 * int(minutes) + float(seconds.replace(",", ".")) for minutes, seconds in parts[2:])


def seconds_of_tests(folder, preset):
    """Processor seconds by entry of the tests that have written to `folder`."""
    found = {}
    for file in sorted(folder.glob("*")):
        seconds = times_of(file.read_text(encoding="utf-8"))
        if seconds is not None:
            found[f"{preset}: {file.name}"] = seconds
    return found


def grown(seconds, unit, units, limit):
    """The entries that grew by more than `limit` and LEAST, the largest growth first."""
    found = []
    for name, now in seconds.items():
        allowed = units[name] * unit if name in units else None
        growth = Growth(name, now, allowed)
        if now - (allowed or 0) > LEAST and growth.share > limit:
            found.append(growth)
    return sorted(found, key=lambda growth: growth.seconds - (growth.allowed or 0), reverse=True)


@dataclass(frozen=True)
class Figures:
    """What one stage has taken."""
    seconds: dict  # by entry
    unit: float  # processor seconds of the fixed job
    reused: int = 0  # results of earlier builds or of a cache, with which a stage takes less


def growth_of(runs, limit, units):
    return [growth for run in runs for growth in grown(run.seconds, run.unit, units, limit)]


def report(runs, units):
    """Prints the growth of all runs by name; returns whether none is above FAILS."""
    if not units:
        print(f"{FILE} has no lines yet; './dev test --update-budget' writes them")
        return False
    for growth in growth_of(runs, NAMED, units):
        print(f"GROWN     {growth}")
    return not growth_of(runs, FAILS, units)


def note(stage, figures):
    """Keeps the figures of a stage that ran completely."""
    kept = json.loads(LAST.read_text(encoding="utf-8")) if LAST.is_file() else {}
    kept[stage] = {"seconds": figures.seconds, "unit": figures.unit, "reused": figures.reused}
    LAST.parent.mkdir(exist_ok=True)
    LAST.write_text(json.dumps(kept, indent=1), encoding="utf-8")


def updated(units, kept):
    """The budget with the figures of the last runs, and the stages whose figures count for nothing."""
    found, skipped = dict(units), []
    for stage, last in kept.items():
        if last["reused"]:
            skipped.append(stage)
            continue
        found.update({name: seconds / last["unit"] for name, seconds in last["seconds"].items()})
    return found, skipped


def update():
    """Writes the figures of the last runs; returns whether there are any."""
    kept = json.loads(LAST.read_text(encoding="utf-8")) if LAST.is_file() else {}
    units, skipped = updated(read(), kept)
    for stage in skipped:
        print(f"{stage}: not updated, because it used earlier results; remove build and use empty caches")
    if len(skipped) == len(kept):
        print("No figures to write: first run ./dev test")
        return False
    FILE.write_text(text_of(units), encoding="utf-8")
    print(f"{FILE}: written; each changed line is a change of the budget")
    return True
