"""The time of one frame of a running system, from live_bench, where that program is built."""

import json

from driven import Failure
from measuring import run

COUNTER = "p99_us"  # microseconds
TITLE = "one live frame, 99 of 100 take less"


def row(name, **more):
    return {"name": "live_frame", "title": f"{TITLE}{name}", "threads": 1, "others": [],
            "limit": None, "quantization_error": None} | more


def medians(found):
    """Each benchmark that counts frames, with its median over all repetitions."""
    for entry in found["benchmarks"]:
        if COUNTER in entry and entry.get("aggregate_name") == "median":
            yield entry["run_name"].split("/")[-1], entry[COUNTER] * 1e-6, entry["repetitions"]


def measure_live(bench, program):
    """A row for each system that live_bench runs."""
    if not program.exists():
        return [row("", left_out="there is no live_bench")]
    bench.say("live_frame")
    repetitions = bench.options.repeats or 5
    try:
        found = json.loads(run([program, "--benchmark_format=json",
                                f"--benchmark_repetitions={repetitions}",
                                "--benchmark_report_aggregates_only=true"]))
    except (Failure, ValueError) as failure:
        return [row("", left_out=str(failure))]
    return [row(f": {name}", seconds=seconds, times=[seconds] * repeats)
            for name, seconds, repeats in medians(found)]
