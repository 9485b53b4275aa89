#!/usr/bin/env python3
"""Gives every parameter the least and the greatest value that the reference allows.

Exploring: every run ends by itself within the body's time that --longest allows, with a whole
recording or a refusal. Training and studies, whose length is what the parameters ask for: every run
ends by itself, or within seconds of Ctrl-C, with an exit code that says so. No signal ends a run, and
no recording or model is left half-written.

usage: extreme_values.py --program FILE --source DIR
"""

import argparse
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from small_inputs import ROWS, STUDY

LONGEST = 5.0  # seconds of the body's time that an exploration may take
RUN = 120.0  # seconds of processor time after which an exploration counts as endless
ENDLESS = 1200.0  # seconds after which a run that waits is killed
PATIENCE = 1.0  # seconds until Ctrl-C is pressed
STOP = 10.0  # seconds of processor time for ending after that, which other work on the machine does not change
BODIES = {"simulation": "lucs2", "plan": "lucs2", "grasp": "lucs2", "closing": "lucs3",
          "texture_probe": "texture", "stroke": "texture", "hardness_probe": "hardness",
          "press": "hardness"}


def sections(page):
    """The parameters of each table of the reference: [(key, what values it takes)]."""
    tables, table = {}, None
    for line in page.splitlines():
        if line.startswith("#"):
            title = re.search(r"`\[*([a-zA-Z_.]+)\]*`|(\S+)$", line)
            table = tables.setdefault(title.group(1) or title.group(2), [])
        row = re.match(r"\| `(\w+)` \| (.*?) \| `", line)
        if row and table is not None:
            table.append((row.group(1), row.group(2)))
    return tables


def extremes(values):
    """The least and greatest values, and those far beyond: [text as TOML]."""
    kind = values.split(",")[0].split(" ")[0]
    if kind not in ("integer", "number", "float"):
        return []
    numbers = re.findall(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?", values.split("[")[0])
    limits = [float(number) for number in numbers]
    texts = [f"{int(limit)}" if kind == "integer" else repr(limit) for limit in limits]
    beyond = ["9007199254740991", "-1", "0"] if kind == "integer" else ["1e300", "1e-300", "-1.0",
                                                                        "0.0"]
    return list(dict.fromkeys(texts + beyond))


class Runs:
    def __init__(self, program, source, folder):
        self.program = program
        self.folder = folder
        page = subprocess.run([program, "reference"], capture_output=True, text=True, check=True)
        self.tables = sections(page.stdout)
        (folder / "data.csv").write_text(ROWS, encoding="utf-8")
        subprocess.run([program, "import", "icub_grasp",
                        str(source / "examples/synthetic_grasps/trials"), "-o", "rec.mcap"],
                       cwd=folder, check=True, stdout=subprocess.DEVNULL)

    def all(self):
        """Every run: (what it is, a function that gives what is wrong, or None)."""
        for table, body in BODIES.items():
            for key, values in self.tables[table]:
                for value in extremes(values):
                    yield f"[{table}] {key} = {value}", self.explorer(table, body, key, value)
        for key, values in self.tables["map"]:
            for value in extremes(values):
                flag = "--" + key.replace("_", "-")
                yield f"som train {flag} {value}", self.trainer(flag, value)
                yield f"module.map.{key} = {value}", self.student("module", "map", key, value)
        for key, values in self.tables["study"]:
            for value in extremes(values):
                yield f"[study] {key} = {value}", self.student(None, "study", key, value)

    def explorer(self, table, body, key, value):
        def run(place):
            (place / "s.toml").write_text(f"[{table}]\n{key} = {value}\n", encoding="utf-8")
            words = ["explore", "--body", body, "--explorations", "1", "--longest", str(int(LONGEST)),
                     "--settings", "s.toml", "-o", "x.mcap", "--threads", "1"]
            code, err = self.end(words, place)
            if code is None:
                return f"it did not end within {RUN:.0f} s of processor time"
            if code not in (0, 1, 2, 3):
                return f"it ended with {code}: {err}"
            return self.judge_recording(place)
        return run

    def judge_recording(self, place):
        if not (place / "x.mcap").exists():
            return None
        inspected = subprocess.run([self.program, "inspect", "x.mcap", "--json"], cwd=place,
                                   capture_output=True, text=True, check=False)
        if inspected.returncode != 0:
            return "its recording is not whole"
        summary = json.loads(inspected.stdout)
        most = (LONGEST + 1.0) * summary["explorations"]
        if summary.get("duration", 0.0) > most:
            return f"its explorations take {summary['duration']} s of the body's time"
        return None

    def trainer(self, flag, value):
        def run(place):
            words = ["som", "train", str(self.folder / "data.csv"), "-o", "m.map", f"{flag}={value}"]
            return self.judge_stopped(words, place)
        return run

    def student(self, group, table, key, value):
        def run(place):
            study = tomllib.loads(STUDY)
            (study[group] if group else study)[table][key] = tomllib.loads(f"x = {value}")["x"]
            (place / "study.toml").write_text(as_toml(study), encoding="utf-8")
            words = ["run", "study.toml", "--data", str(self.folder / "rec.mcap"), "--out", "out"]
            return self.judge_stopped(words, place)
        return run

    def judge_stopped(self, words, place):
        code, err = self.end(words, place, interrupt=signal.SIGINT)
        if code is None:
            return f"it did not end within {STOP:.0f} s of processor time after Ctrl-C"
        if code not in (0, 1, 2, 130):
            return f"it ended with {code}: {err}"
        left = [path.name for path in place.rglob("*.partial")]
        return f"it left {left}" if left else None

    def end(self, words, place, interrupt=None):
        """The exit code, or None where it does not end, and the last line of standard error. The
        signal `interrupt`, if there is one, is sent after PATIENCE."""
        process = subprocess.Popen([self.program, *words], cwd=place, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        if interrupt:
            err = within(process, PATIENCE, RUN)
            if err is None:
                process.send_signal(interrupt)
                err = within(process, ENDLESS, STOP)
        else:
            err = within(process, ENDLESS, RUN)
        if err is None:
            process.kill()
            process.communicate()
            return None, ""
        return process.returncode, err.decode(errors="replace").strip().rpartition("\n")[2]


def within(process, seconds, processor):
    """What the process prints on standard error until its end, or None if it takes longer."""
    started, used = time.monotonic(), processor_seconds(process)
    while time.monotonic() - started < seconds and processor_seconds(process) - used < processor:
        try:
            return process.communicate(timeout=min(seconds, 0.2))[1]
        except subprocess.TimeoutExpired:
            pass
    return None


def processor_seconds(process):
    fields = Path(f"/proc/{process.pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def as_toml(tables, name=""):
    """Nested tables of plain values as TOML."""
    plain = {key: value for key, value in tables.items() if not isinstance(value, dict)}
    text = f"[{name}]\n" if name and plain else ""
    text += "".join(f"{key} = {json.dumps(value)}\n" for key, value in plain.items())
    for key, value in tables.items():
        if isinstance(value, dict):
            text += as_toml(value, f"{name}.{key}" if name else key)
    return text


def main():
    parser = argparse.ArgumentParser(description="Gives every parameter its extreme values.")
    parser.add_argument("--program", required=True)
    parser.add_argument("--source", type=Path, required=True)
    given = parser.parse_args()
    folder = Path(tempfile.mkdtemp(prefix="somato-extremes-"))
    runs = Runs(str(Path(given.program).resolve()), given.source.resolve(), folder)

    def judge(task):
        what, run = task
        with tempfile.TemporaryDirectory(dir=folder) as place:
            wrong = run(Path(place))
        return f"{what}: {wrong}" if wrong else None

    tasks = list(runs.all())
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        wrong = [what for what in pool.map(judge, tasks) if what]
    for what in wrong:
        print(what, file=sys.stderr)
    print(f"{len(tasks)} extreme values, {len(wrong)} judged wrong")
    shutil.rmtree(folder)
    return 1 if wrong or len(tasks) < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
