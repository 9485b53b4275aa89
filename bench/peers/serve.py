"""Runs a case with a program of others, each time when a line on the standard input says so.

usage: serve.py PEER CASE FOLDER THREADS

FOLDER holds case.json, samples.npy and initial.npy. Lines and answers are those of workloads.cc:
`run`, `weights FILE`, `quit`. A peer's own messages go to the standard error.
"""

import importlib
import json
import os
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace

import numpy


@dataclass
class Job:
    """A peer's answers for a case: `run` does `part` of the work, `weights` gives the map."""

    run: object
    weights: object = None  # of no arguments: neurons x features, in the order of the grid's rows
    part: float = 1.0


def load_case(folder, threads):
    described = json.loads((folder / "case.json").read_text(encoding="utf-8"))
    case = SimpleNamespace(**{"whole": False} | described)  # whole: no part is measured for all
    case.data = numpy.load(folder / "samples.npy")
    case.initial = numpy.load(folder / "initial.npy")
    case.neurons = case.rows * case.columns
    case.threads = threads
    return case


def peak_kib():
    """Reads the peak of this program only: getrusage() includes the program that started it."""
    for line in Path("/proc/self/status").read_text(encoding="utf-8").splitlines():
        if line.startswith("VmHWM:"):
            return int(line.split()[1])
    return 0


def answer(job, line):
    if line.startswith("weights "):
        if job.weights is None or job.part < 1:
            return {"written": False}
        weights = numpy.asarray(job.weights(), dtype=numpy.float32)
        numpy.save(line.removeprefix("weights "), weights.reshape(-1, weights.shape[-1]))
        return {"written": True}
    begin, used = time.perf_counter(), time.process_time()
    job.run()
    seconds, used = time.perf_counter() - begin, time.process_time() - used
    return {"seconds": seconds / job.part, "processor_seconds": used / job.part, "took": seconds,
            "part": job.part, "peak_kib": peak_kib()}


def main():
    peer, name, folder, threads = sys.argv[1:]
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # peers print
    sys.modules["serve"] = sys.modules["__main__"]  # what adapters import: one Job, not two
    module = importlib.import_module(f"run_{peer}")
    job = module.prepare(load_case(Path(folder), int(threads)), name)
    print(json.dumps({"ready": True}), file=answers, flush=True)
    for line in sys.stdin:
        if line.strip() == "quit":
            break
        print(json.dumps(answer(job, line.strip())), file=answers, flush=True)


if __name__ == "__main__":
    main()
