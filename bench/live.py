"""The time of one frame of a running system, from live_bench, where that program is built."""

import json

from driven import Failure
from measuring import run

NAME = "p99"  # part of the name of the counter, in seconds


def measure_live(bench, program):
    result = {"name": "live_frame", "title": "one live frame, 99 of 100 take less", "threads": 1,
              "others": [], "limit": None, "quantization_error": None}
    if not program.exists():
        return result | {"left_out": "there is no live_bench"}
    bench.say("live_frame")
    try:
        found = json.loads(run([program, "--benchmark_format=json"]))["benchmarks"]
        times = [value for entry in found for key, value in entry.items() if NAME in key]
        return result | {"times": times, "seconds": max(times)}
    except (Failure, ValueError, KeyError) as failure:
        return result | {"left_out": str(failure) or "live_bench counted nothing"}
