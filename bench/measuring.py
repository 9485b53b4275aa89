"""Measures one row: Somato, alternately with its variants and with other programs."""

import json
import subprocess
import time
from pathlib import Path

import peer_environments
from cases import THREADS
from driven import Driven, Failure, environment, last_line, median
from limits import limit

TREE = Path(__file__).resolve().parent.parent
PROGRAMS = TREE / "build/bench/bench"
SOMATO = TREE / "build/bench/somato"
PYTHON = TREE / "build/bench/python/environment/bin/python"
PACKAGE = TREE / "build/bench/python"
PATIENCE = 900  # seconds for an answer
SLOW = 20.0  # seconds above which there are three repetitions
VERY_SLOW = 60.0  # seconds above which a whole run of the program is done once
WARM_UP = 3.0  # seconds below which the first run is discarded
WHOLE = peer_environments.PEERS / "whole.py"
REST = 0.3  # seconds after which waiting threads of other programs are asleep


class Bench:
    """State shared by all rows: options, limits of the machine and folders of data."""

    def __init__(self, options, say):
        self.options = options
        self.say = say
        self.scale = 20 if options.quick else 1
        self.data = TREE / "build/bench/data" / ("quick" if options.quick else "whole")
        self.peers = {} if options.no_peers else peer_environments.all_peers()
        self.cases = {case["name"]: case for case in self.ask_workloads("list", "--scale", self.scale)}
        self.sets = self.ask_workloads("sets")
        self.machines = {}  # limits, by threads

    def ask_workloads(self, *words):
        return json.loads(run([PROGRAMS / "workloads", *words]))

    def machine(self, threads):
        if threads not in self.machines:
            self.say(f"limits of the machine, {threads} threads")
            self.machines[threads] = json.loads(run([PROGRAMS / "limits", threads]))
        return self.machines[threads]

    def repeats(self, seconds):
        return self.options.repeats or (5 if seconds < SLOW else 3)

    def chosen_peers(self, case):
        wanted = self.options.peers
        for peer, settings in self.peers.items():
            if case not in settings["cases"] or (wanted and peer not in [*wanted, "yardstick"]):
                continue
            if case in settings.get("only_long", []) and not self.options.long:
                settings = {**settings, "left_out": "takes minutes: measured with --long"}
            yield peer, settings


def run(command, threads=THREADS):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          env=environment(threads), check=False)
    if done.returncode != 0:
        raise Failure(last_line(done.stderr))
    return done.stdout


def ours(bench, case, variant=None):
    command = [PROGRAMS / "workloads", "serve", case, "--scale", bench.scale]
    threads = variant.threads if variant else THREADS
    command += ["--threads", threads]
    if variant and variant.set:
        command += ["--set", variant.set]
    return Driven(command, threads, PATIENCE)


def write_case(bench, name):
    """Writes the arrays and the description of the case for other programs."""
    folder = bench.data / name
    folder.mkdir(parents=True, exist_ok=True)
    run([PROGRAMS / "workloads", "write", name, folder, "--scale", bench.scale])
    (folder / "case.json").write_text(json.dumps(bench.cases[name]), encoding="utf-8")
    return folder


def turns(bench, first, other):
    """Alternating times of both (first, other, first, other, ...), and the last answer of the other."""
    answer = other.run()
    times = [] if answer.get("took", answer["seconds"]) < WARM_UP else [answer["seconds"]]
    own = []
    repeats = bench.repeats(answer.get("took", answer["seconds"]))
    while len(own) < repeats:
        time.sleep(REST)
        own.append(first.run()["seconds"])
        if len(times) < repeats:
            answer = other.run()
            times.append(answer["seconds"])
    return own, times, answer


def quantization_error(bench, driven, folder):
    """Error of the map saved by the program, computed by the same function for all; None without a map."""
    weights = folder / "weights.npy"
    if not driven.ask(f"weights {weights}").get("written"):
        return None
    python = peer_environments.python_of("yardstick", bench.peers["yardstick"], bench.say)
    return float(run([python, peer_environments.PEERS / "judge.py", weights, folder / "samples.npy"]))


def beside(bench, first, driven, folder):
    """Result of another program or variant, measured alternately with Somato."""
    own, times, answer = turns(bench, first, driven)
    return {"own": own, "times": times, "seconds": median(times),
            "ratio": median(times) / median(own), "estimated": answer.get("part", 1) < 1,
            "peak_kib": answer["peak_kib"],
            "quantization_error": quantization_error(bench, driven, folder) if folder else None}


def beside_peer(bench, first, peer, settings, name, folder, threads=THREADS):
    result = {"name": settings.get("name", peer), "threads": threads,
              "instead": settings["cases"][name]}
    try:
        command = peer_environments.command_of(peer, settings, bench.say)
        bench.say(f"{name}: {result['name']}, {threads} threads")
        with Driven([*command, name, folder, threads], threads, PATIENCE) as driven:
            result |= beside(bench, first, driven, folder)
        if threads != THREADS:
            del result["ratio"]  # Somato had another number
        return result
    except Failure as failure:
        return result | {"left_out": str(failure)}


def beside_variant(bench, first, row, variant):
    bench.say(f"{row.name}: ours, {variant.name}")
    with ours(bench, variant.case or row.name, variant) as driven:
        return {"name": f"Somato, {variant.name}", "threads": variant.threads, "is_ours": True,
                "instead": ""} | beside(bench, first, driven, None)


def counted_steps(row, case):
    return case["steps"] // 2 if row.half else case["steps"]


def add_limits(bench, row, result):
    """Lower bound of the time of the case for each measured number of threads."""
    case = dict(bench.cases[row.name])
    case["neurons"] = case.get("rows", 0) * case.get("columns", 0)
    case["counted_steps"] = counted_steps(row, case)
    products = {entry["threads"]: entry["seconds"] for entry in result["others"]
                if entry["name"] == "BLAS product only" and "seconds" in entry}
    for entry in [result, *(other for other in result["others"] if other.get("is_ours"))]:
        threads = entry["threads"]
        known = {"product_seconds": products[threads]} if threads in products else {}
        entry["limit"] = limit(row.name, case | known, bench.machine(threads))


def measure_row(bench, row):
    """The entry of a row in results.json."""
    bench.say(f"{row.name}: ours")
    folder = write_case(bench, row.name) if bench.peers and row.name in PEERED else None
    result = {"name": row.name, "title": row.title, "threads": THREADS, "others": []}
    with ours(bench, row.name) as first:
        first.run()
        own = [first.run()["seconds"] for _ in range(bench.options.repeats or 5)]
        others = result["others"]
        others += [beside_variant(bench, first, row, variant) for variant in row.variants]
        for peer, settings in bench.chosen_peers(row.name):
            numbers = {THREADS, *(v.threads for v in row.variants)} if peer == "yardstick" else {THREADS}
            others += [beside_peer(bench, first, peer, settings, row.name, folder, threads)
                       for threads in sorted(numbers)]
        last = first.run()
        error = quantization_error(bench, first, folder) if folder and row.name != "winners" else None
    own += [seconds for other in others for seconds in other.get("own", [])]
    result |= {"times": own, "seconds": median(own), "peak_kib": last["peak_kib"],
               "set": last["set"], "quantization_error": error}
    add_limits(bench, row, result)
    return result


def measure_command(bench, command):
    """Seconds and peak memory of whole runs of the program."""
    result = {"name": command.name, "title": command.title, "threads": THREADS, "others": [],
              "limit": None, "quantization_error": None, "times": [], "peak_kib": 0}
    if command.bytes:
        result["title"] += f", {command.bytes >> 20} MiB"
    repeats = 1
    while len(result["times"]) < repeats:
        bench.say(f"{command.name}: run {len(result['times']) + 1}")
        done, errors = run_timed([PROGRAMS / "time_program", command.bytes, *words_of(command)])
        if done["status"] != 0:
            return result | {"left_out": last_line(errors)}
        result["times"].append(done["seconds"])
        result["peak_kib"] = max(result["peak_kib"], done["peak_kib"])
        if done["seconds"] < VERY_SLOW:
            repeats = command.repeats or bench.repeats(done["seconds"])
    chosen = [peer for peer in command.peers if peer in bench.peers
              and (not bench.options.peers or peer in bench.options.peers)]
    result["others"] = [beside_whole(bench, command, peer) for peer in chosen]
    return result | {"seconds": median(result["times"])}


def words_of(command):
    if command.python:
        return [PYTHON, WHOLE, "pysomato", *command.words]
    return [SOMATO, *command.words]


def beside_whole(bench, command, peer):
    """Whole runs of another program, alternately with those of the command."""
    result = {"name": bench.peers[peer].get("name", peer), "threads": THREADS, "instead": command.peers[peer],
              "own": [], "times": [], "peak_kib": 0}
    try:
        python = peer_environments.python_of(peer, bench.peers[peer], bench.say)
    except Failure as failure:
        return result | {"left_out": str(failure)}
    other = [python, WHOLE, peer, "search", bench.data / "searches", THREADS]
    for number in range(1 + bench.repeats(0.0)):
        bench.say(f"{command.name}: {result['name']}, run {number + 1}")
        for words, times in ((words_of(command), result["own"]), (other, result["times"])):
            done, errors = run_timed([PROGRAMS / "time_program", 0, *words])
            if done["status"] != 0:
                return result | {"left_out": last_line(errors)}
            if number > 0:  # the first run compiles and reads files
                times.append(done["seconds"])
        result["peak_kib"] = max(result["peak_kib"], done["peak_kib"])
    return result | {"seconds": median(result["times"]),
                     "ratio": median(result["times"]) / median(result["own"])}


def run_timed(command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, cwd=TREE,
                          env=environment(THREADS) | {"PYTHONPATH": str(PACKAGE)}, check=True)
    return json.loads(done.stdout), done.stderr


PEERED = {"dense_batch", "hexagonal_batch", "few_samples", "sparse_uniform_start",
          "sparse_sample_start", "sparse_streaming", "sparse_batch", "winners", "clustered_search",
          "layers_batch", "layers_online"}
