#!/usr/bin/env python3
"""Compares the speed of Somato with the machine's limits and with other programs; see docs/performance.md.

Writes out/bench/results.json after each row, so that nothing measured is lost, and prints a table.
"""

import argparse
import datetime
import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import cases
import report
from driven import Failure
from live import measure_live
from measuring import PROGRAMS, PYTHON, SOMATO, TREE, WHOLE, Bench, measure_command, measure_row, run, run_timed

OUT = TREE / "out/bench"
BUSY = 0.3  # load average above which other programs are running


def say_to(stream):
    """Progress on one line of a terminal; nothing if the stream is not a terminal."""
    if not stream.isatty():
        return lambda _: None
    return lambda text: print(f"\r\033[K{text}", end="", file=stream, flush=True)


def read_options():
    parser = argparse.ArgumentParser(prog="./dev bench", description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help="rows to measure; default: all")
    parser.add_argument("--quick", action="store_true", help="sizes divided by 20: tests the procedure; times are not valid")
    parser.add_argument("--long", action="store_true", help="include rows that take minutes or hours")
    parser.add_argument("--no-peers", action="store_true", help="measure only Somato")
    parser.add_argument("--peers", type=lambda text: text.split(","), help="only these other programs, separated by commas")
    parser.add_argument("--repeats", type=int, help="number of repetitions; default: 5, or 3 for slow rows")
    parser.add_argument("--markdown", action="store_true", help="print tables in Markdown")
    parser.add_argument("--show", action="store_true", help="print the last results without measuring")
    return parser.parse_args()


def save(results):
    """Atomic: the file is written completely or not at all."""
    OUT.mkdir(parents=True, exist_ok=True)
    part = OUT / "results.json.part"
    part.write_text(json.dumps(results, indent=1), encoding="utf-8")
    os.replace(part, OUT / "results.json")


def processor():
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return "unknown processor"


def warnings(options):
    found = []
    if os.getloadavg()[0] > BUSY:
        found.append(f"the machine was busy at the start: load average {os.getloadavg()[0]:.1f}")
    if options.quick:
        found.append("quick: sizes are divided by 20, so these times are not valid")
    return found


def version():
    described = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=TREE, check=False,
                               capture_output=True, text=True).stdout.strip()
    return described or run([SOMATO, "--version"]).strip()


def write_study(system, to):
    """Writes the system's file with only the papers' protocol: one training per seed."""
    lines = system.read_text(encoding="utf-8").splitlines()
    kept = [line for line in lines if not line.startswith("groups = ")]
    protocols = [i for i, line in enumerate(kept) if line.startswith("protocols = ")]
    kept[protocols[0]] = 'protocols = ["train_is_test"]'
    to.write_text("\n".join(without_claims(kept)) + "\n", encoding="utf-8")


def without_claims(lines):
    return lines[:lines.index("[[claim]]")]


def prepare_files(bench, chosen):
    """Creates the files that the commands read, if they do not exist."""
    bench.data.mkdir(parents=True, exist_ok=True)
    recording, large = bench.data / "lucs2.mcap", bench.data / "large.npy"
    chains = [command.study for command in chosen if command.study]
    if chains and not recording.exists():
        bench.say("exploring for the chains")
        run([SOMATO, "explore", "--body", "lucs2", "--seed", 7, "--output", recording])
    for name in chains:
        # Otherwise, an interrupted run would be resumed.
        (OUT / name / "unfinished.journal").unlink(missing_ok=True)
        write_study(TREE / "systems" / f"{name}.toml", bench.data / f"{name}.toml")
    if any(command.name == "apply" for command in chosen):
        run([SOMATO, "run", bench.data / "tensor_chain.toml", "--data", recording, "--out", bench.data / "chain",
             "--seeds", 1])
    if any("searches" in word for command in chosen for word in command.words):
        prepare_searches(bench)
    if any(command.name == "large_file" for command in chosen) and not large.exists():
        bench.say("writing a large file")
        run([PROGRAMS / "workloads", "write-large", large, cases.LARGE_ROWS // bench.scale,
             cases.LARGE_COLUMNS])


def prepare_searches(bench):
    """Samples, and a map with labels."""
    folder = bench.data / "searches"
    if (folder / "weights.npy").exists():
        return
    bench.say("training a map for searches")
    folder.mkdir(parents=True, exist_ok=True)
    run([PROGRAMS / "workloads", "write", "winners", folder, "--scale", bench.scale])
    run_timed([PROGRAMS / "time_program", 0, PYTHON, WHOLE, "pysomato", "prepare", folder, cases.THREADS])


def refuse_unknown(what, names, known):
    for name in names:
        if name not in known:
            print(f"bench: unknown {what} '{name}'; known: {' '.join(known)}", file=sys.stderr)
            sys.exit(2)


def choose(options, rows, commands):
    """The rows and commands to measure; exits on an unknown name."""
    known = [row.name for row in rows] + [command.name for command in commands] + ["live_frame"]
    refuse_unknown("row", options.names, known)
    wanted = options.names or [name for name in known if options.long or name != "reproduce_all"]
    return ([row for row in rows if row.name in wanted],
            [command for command in commands if command.name in wanted], "live_frame" in wanted)


def measurements(bench, rows, commands, live):
    """Yields the results one by one."""
    for row in rows:
        yield measure_row(bench, row)
    prepare_files(bench, commands)
    for command in commands:
        yield measure_command(bench, command)
    if live:
        yield from measure_live(bench, PROGRAMS / "live_bench")


def measure(options, say):
    bench = Bench(options, say)
    rows, commands, live = choose(options, cases.rows(bench.sets),
                                  cases.commands(bench.data, OUT, options.quick))
    refuse_unknown("other program", options.peers or [], bench.peers)
    minutes = sum(item.minutes for item in [*rows, *commands])
    say(f"about {max(1, round(minutes / bench.scale))} min on an idle machine\n")
    results = {"date": datetime.date.today().isoformat(), "version": version(), "quick": options.quick,
               "processor": processor(), "cores": os.cpu_count(), "warnings": warnings(options),
               "complete": False, "machine": bench.machines, "rows": []}
    for result in measurements(bench, rows, commands, live):
        results["rows"].append(result)
        save(results)
    results["complete"] = True
    save(results)
    return results


def main():
    options = read_options()
    say = say_to(sys.stderr)
    try:
        if options.show:
            results = json.loads((OUT / "results.json").read_text(encoding="utf-8"))
        else:
            results = measure(options, say)
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)
    except (Failure, FileNotFoundError) as failure:
        sys.exit(f"bench: {failure}")
    say("")
    print(report.as_text(results, options.markdown))
    return 0


if __name__ == "__main__":
    sys.exit(main())
