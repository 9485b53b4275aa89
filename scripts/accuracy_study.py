#!/usr/bin/env python3
"""Compares maps with nearest neighbours, a linear discriminant and an SVM on the shared data sets, with folds that
keep neighbouring explorations together.

usage: accuracy_study.py --data FOLDER --out OUT [--seeds N] [--jobs N] [--only SET,...] [--methods NAME,...]

FOLDER contains the data sets (docs/public-data.md). The script requires pysomato and the packages of
tests/python/requirements.txt. If pysomato is not installed, it runs in the environment of a build of this
tree (build/release or build/dev). OUT gets accuracy/SET/METHOD.json and clusters/SET/METHOD.json;
stored cells are not computed again, unless the data, the settings or the library have changed.
OUT/accuracy.md is docs/accuracy.md, which scripts/accuracy_page.py makes of them.
"""

import argparse
import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

TREE = Path(__file__).resolve().parents[1]


def use_environment_of_build():
    """Runs this script again in the environment of a build if pysomato is not installed."""
    if find_spec("pysomato"):
        return
    for build in ("release", "dev"):
        folder = TREE / "build" / build / "python"
        python = folder / "environment" / "bin" / "python"
        if python.exists() and (folder / "pysomato").exists() and os.environ.get("PYTHONPATH") != str(folder):
            os.execve(python, [python, *sys.argv], {**os.environ, "PYTHONPATH": str(folder)})
    sys.exit("accuracy_study: pysomato is not installed; run './dev build dev' or 'pip install .' first")


if __name__ == "__main__":
    use_environment_of_build()
    os.environ.setdefault("OMP_NUM_THREADS", "1")  # processes share the cores
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from accuracy import cells, data, methods, study  # noqa: E402: after the variables


def names_of(text, known, flag):
    """The names in a list separated by commas; an unknown one ends the program."""
    names = text.split(",")
    unknown = [name for name in names if name not in known]
    if unknown:
        sys.exit(f"accuracy_study: {flag}: '{unknown[0]}' is not one of {', '.join(known)}")
    return names


def read_options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--seeds", type=int, default=methods.SEEDS)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", default=",".join(data.SETS), help="names of sets")
    parser.add_argument("--methods", default=",".join(methods.METHODS), help="names of methods")
    options = parser.parse_args()
    options.only = names_of(options.only, data.SETS, "--only")
    options.methods = names_of(options.methods, methods.METHODS, "--methods")
    return options


def check_methods(chosen):
    """Ends the program before the first cell if the installed package lacks a method."""
    missing = {}
    for name in chosen:
        try:
            methods.METHODS[name].check()
        except methods.MissingFeature as error:
            missing[name] = error
    if missing:
        others = ",".join(name for name in chosen if name not in missing)
        sys.exit("accuracy_study: " + "; ".join(f"{name}: {error}" for name, error in missing.items()) +
                 f"; install a version that has it, or choose --methods {others}")


def main():
    options = read_options()
    check_methods(options.methods)
    print(f"reading {len(options.only)} sets", file=sys.stderr, flush=True)
    made = study.make_vectors(options.data, options.out, options.only)
    study.describe(options.out, options.seeds)
    failed = cells.run(study.cells(options.out, made, options.methods, options.seeds), options.jobs)
    for name, error in failed.items():
        print(f"\n{name}: {error}", file=sys.stderr)
    if failed:
        sys.exit(f"accuracy_study: {len(failed)} cells failed: {', '.join(failed)}")
    page = TREE / "scripts" / "accuracy_page.py"
    made_page = subprocess.run([sys.executable, page, options.out], check=True, capture_output=True, text=True)
    (options.out / "accuracy.md").write_text(made_page.stdout, encoding="utf-8")


if __name__ == "__main__":
    main()
