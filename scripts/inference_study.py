#!/usr/bin/env python3
"""Runs the inferences of systems/inference, and writes docs/inference.md of them.

usage: inference_study.py --out OUT [--only NAME,...] [--held-out N] [--reproduction FILE] [--program P]

An inference is a file NAME.toml with a prior, whose first comment contains the commands that run it, and its targets,
NAME_targets.toml. Its results are in OUT/NAME. An interrupted study is resumed by the same command: draws
that are stored are not computed again. OUT/inference.md is the page, which scripts/inference_page.py makes of all results in
OUT; FILE is the results.json of `somato reproduce all questions`, with the shipped bodies.

With --held-out N, the first N posterior bodies of each inference are also tested by the protocols of the shipped systems, whose
held-out accuracies the inference does not contain.
"""

import argparse
import json
import re
import resource
import shlex
import subprocess
import sys
import time
import tomllib
from pathlib import Path

TREE = Path(__file__).resolve().parents[1]
INFERENCES = TREE / "systems" / "inference"
BODIES = ("probes", "hand_2", "hand_3")  # those of the papers
OUT_IN_FILES = "out/inference"  # the folder that the comments name
HELD_OUT_PAIRS = 5
HELD_OUT_SEED = 300001  # no draw and no fresh setting has these seeds


def names_of_inferences(folder=INFERENCES):
    """Names with a file of targets, those of BODIES first."""
    found = sorted(file.stem.removesuffix("_targets") for file in folder.glob("*_targets.toml"))
    return sorted(found, key=lambda name: BODIES.index(name) if name in BODIES else len(BODIES))


def commands_of(text):
    """The commands `somato ...` in the comment with which a file of a prior begins, as lists of arguments."""
    comment = re.match(r"(?:#.*\n)*", text)[0]
    joined = re.sub(r"\\\n#\s*", "", comment)
    return [shlex.split(found)[1:] for found in re.findall(r"^#\s{2,}(somato .*)$", joined, re.MULTILINE)]


def moved(command, out):
    """The command with OUT in place of the folder that the comment names."""
    return [str(out) + one.removeprefix(OUT_IN_FILES) if one.startswith(OUT_IN_FILES) else one for one in command]


def read_options(arguments=None):
    known = names_of_inferences()
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--only", default=",".join(known), help="names of inferences")
    parser.add_argument("--held-out", type=int, default=0, help="number of posterior bodies that are tested on held-out data")
    parser.add_argument("--reproduction", type=Path, help="results.json of the shipped bodies")
    parser.add_argument("--program", default="somato", help="the program; default: somato")
    options = parser.parse_args(arguments)
    options.only = options.only.split(",")
    unknown = [name for name in options.only if name not in known]
    if unknown:
        sys.exit(f"inference_study: --only: '{unknown[0]}' is not one of {', '.join(known)}")
    if "/" in options.program:
        options.program = str(Path(options.program).resolve())
    options.out = options.out.resolve()
    return options


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def timed(run, file):
    """Adds the seconds that `run` takes to those of earlier parts of the same study, even if it is interrupted."""
    spent = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {"seconds": 0, "processor_seconds": 0}
    began, used = time.monotonic(), processor_seconds()
    try:
        run()
    finally:
        spent["seconds"] += time.monotonic() - began
        spent["processor_seconds"] += processor_seconds() - used
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps(spent) + "\n", encoding="utf-8")


def run_inference(name, options):
    commands = commands_of((INFERENCES / f"{name}.toml").read_text(encoding="utf-8"))
    if not commands:
        sys.exit(f"inference_study: the comment at the head of systems/inference/{name}.toml contains no command of somato")

    def run():
        for command in commands:
            subprocess.run([options.program, *moved(command, options.out)], check=True, cwd=TREE)

    timed(run, options.out / name / "seconds.json")


def with_protocols(text, study):
    """A system's file with the protocols and groups of another study."""
    for key in ("protocols", "groups"):
        values = json.dumps(study.get(key, []))
        text = re.sub(rf"^{key} = \[[^\]]*\]$", f"{key} = {values}", text, count=1, flags=re.MULTILINE)
    return text


def test_held_out(name, options):
    """Runs the first posterior bodies by the protocols of the shipped systems."""
    bodies = sorted((options.out / name / "bodies").iterdir())[: options.held_out]
    for body in bodies:
        folder = options.out / name / "held_out" / body.name
        if (folder / "results.json").exists():
            continue
        folder.mkdir(parents=True, exist_ok=True)
        files = []
        for system in sorted(body.glob("*.toml")):
            shipped = tomllib.loads((TREE / "systems" / system.name).read_text(encoding="utf-8"))
            files.append(folder / system.name)
            files[-1].write_text(with_protocols(system.read_text(encoding="utf-8"), shipped["study"]), encoding="utf-8")
        subprocess.run([options.program, "reproduce", *map(str, files), "--pairs", str(HELD_OUT_PAIRS), "--recordings",
                        str(HELD_OUT_PAIRS), "--seed", str(HELD_OUT_SEED), "--out", str(folder), "--quiet"], check=True, cwd=TREE)


def main(arguments=None):
    options = read_options(arguments)
    for name in options.only:
        print(f"inference: {name}", file=sys.stderr, flush=True)
        run_inference(name, options)
        test_held_out(name, options)
    page = [sys.executable, TREE / "scripts" / "inference_page.py", options.out]
    if options.reproduction:
        page += ["--reproduction", options.reproduction]
    made = subprocess.run(page, check=True, capture_output=True, text=True)
    (options.out / "inference.md").write_text(made.stdout, encoding="utf-8")


if __name__ == "__main__":
    main()
