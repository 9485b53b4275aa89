#!/usr/bin/env python3
"""Measures the time from a frame at a serial line to the answer of 'somato live'.

  scripts/latency.py [--frames N] [--rows ROW...] [--programs FOLDER]

An emulated board with 45 taxels sends frames at 1 kHz into a pseudo-terminal; 'somato live' reads them with a map of 100
neurons and prints its answers (bench/latency.cc). Each row is one state of the machine: `idle`, or `stress` under stress-ng
with four workers; with `page`, a client also reads the events of the page, of which it acknowledges up to 60 a second as a
page does; with `realtime`, the program has --realtime. Prints a table of the latencies in milliseconds. A million frames
take 17 minutes a row; a person runs it, and no test. It needs bench/latency (SOMATO_BUILD_BENCHMARKS), stress-ng, and for
exact figures the permission of real-time priorities.
"""

import argparse
import contextlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request
from pathlib import Path

TREE = Path(__file__).resolve().parent.parent
TAXELS = 45
ROWS = ["stress", "stress,page", "stress,realtime", "stress,page,realtime", "idle", "idle,page", "idle,realtime",
        "idle,page,realtime"]
WORDS = {"idle", "stress", "page", "realtime"}
PICTURES = 60  # events of the page that are acknowledged a second

# Each taxel has its own neuron, and the distance from it is the difference of another touch: an answer determines the frame.
SYSTEM = """[study]
name = "latency"
label = "object"
seeds = 1

[recording]
label_column = "object"

[module.touch]
type = "channel"
channel = "columns"

[module.now]
type = "last"
input = "touch"

[module.map]
type = "som"
input = "now"
rows = 10
columns = 10
iterations = 20000
radius_end = 0.1
learning_rate_end = 0.3
"""

# The line is read once in a millisecond. A program that is held up by others continues: the delay is what is measured.
DEVICE = """name = "board"
explore = "holding"
period = 0.001
duration = 3600

[frames]
format = "frames"
port = "port"
elements = 45
rate = 1000

[sensor.columns]
unit = "N"
from = "frames"
gain = 0.001
elements = ["taxel0..44"]

[safety]
pause = 60
missed = 10000
"""

OBJECTS = """[object]
board = { shape = "sphere", diameter = 50, material = "plastic" }
"""


def write_files(trainer, folder):
    """The system, trained by a program with the command 'run', the device and its object."""
    rows = [",".join(["object", *(f"taxel{i}" for i in range(TAXELS))])]
    for taxel in range(TAXELS):
        rows += 2 * [",".join([f"taxel{taxel}", *("1" if i == taxel else "0" for i in range(TAXELS))])]
    texts = {"touch.csv": "\n".join(rows) + "\n", "system.toml": SYSTEM, "device.toml": DEVICE, "objects.toml": OBJECTS}
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    subprocess.run([trainer, "run", "system.toml", "--data", "touch.csv", "--out", "out", "--quiet"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)


def live_words(program):
    """The command that reads the board, in the folder of write_files()."""
    return [program, "live", "--model", "out/system.somato", "--device", "device.toml", "--objects", "objects.toml",
            "--explorations", "1"]


class Page:
    """A client that begins the exploration and reads the events of the page, in a thread of its own."""

    def __init__(self, address):
        self.host, self.token = re.fullmatch(r"(http://[^/]+)/\?token=(\w+)", address).groups()
        self.events = 0
        self.stream = urllib.request.urlopen(f"{self.host}/api/events?acknowledge=1&token={self.token}")
        threading.Thread(target=self.read, daemon=True).start()
        self.post("command", "", b'{"command":"explore"}')

    def post(self, what, more, body=b""):
        request = urllib.request.Request(f"{self.host}/api/{what}?token={self.token}{more}", data=body, method="POST",
                                         headers={"Origin": self.host, "Content-Type": "application/json"})
        with urllib.request.urlopen(request) as answer:
            answer.read()

    def read(self):
        with contextlib.suppress(OSError, ValueError):  # the program ends first
            for line in self.stream:
                if not line.startswith(b"data:"):
                    continue
                self.events += 1
                seen = json.loads(line[5:])
                if "viewer" in seen and "number" in seen:
                    time.sleep(1 / PICTURES)
                    self.post("seen", f"&viewer={seen['viewer']}&number={seen['number']}")


def address_in(errors):
    """The address of the page, from the standard error of the program; the rest is passed on."""
    for line in errors:
        found = re.match(rb"Open (\S+)", line)
        if found:
            return found[1].decode()
        sys.stderr.write(line.decode())
    raise SystemExit("latency.py: the program has ended before it served its page")


@contextlib.contextmanager
def stress(row):
    if "stress" not in row:
        yield
        return
    with subprocess.Popen(["stress-ng", "--cpu", "4", "--quiet"]) as process:
        try:
            yield
        finally:
            process.terminate()


def measured(options, folder, row):
    words = [options.programs / "bench/latency", str(options.frames), folder / "port", *live_words(options.programs / "somato")]
    words += ["--realtime"] if "realtime" in row else []
    words += ["--view"] if "page" in row else []
    with stress(row), subprocess.Popen(words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        page = Page(address_in(process.stderr)) if "page" in row else None
        rest = threading.Thread(target=lambda: sys.stderr.buffer.write(process.stderr.read()))
        rest.start()
        answer = process.stdout.read()
        rest.join()
    if process.returncode != 0:
        raise SystemExit(f"latency.py: bench/latency ended with status {process.returncode}")
    return json.loads(answer) | ({"events": page.events} if page else {})


def row_text(row, found):
    texts = [", ".join(row), f"{found['frames']:,}"]
    texts += [f"{found[name] / 1000:.2f}" for name in ("median", "p99_9", "worst")]
    return f"| {' | '.join(texts)} | {found['lost']} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--frames", type=int, default=1_000_000)
    parser.add_argument("--rows", nargs="+", default=ROWS, help=f"of these words, with commas: {', '.join(sorted(WORDS))}")
    parser.add_argument("--programs", type=Path, default=TREE / "build/bench", help="folder of the built programs")
    parser.add_argument("--trainer", type=Path, help="program that trains the system; default: the measured one")
    options = parser.parse_args()
    options.programs = options.programs.resolve()
    options.trainer = options.trainer or options.programs / "somato"
    rows = [row.split(",") for row in options.rows]
    if not all(WORDS.issuperset(row) for row in rows):
        parser.error(f"a row consists of the words {', '.join(sorted(WORDS))}")
    if any("stress" in row for row in rows) and not shutil.which("stress-ng"):
        parser.error("stress-ng is missing: apt-get install stress-ng")
    print("| state | frames | median (ms) | 99.9 % (ms) | worst (ms) | frames lost |\n|---|---|---|---|---|---|", flush=True)
    for row in rows:
        with tempfile.TemporaryDirectory() as folder:
            write_files(options.trainer.resolve(), Path(folder))
            found = measured(options, Path(folder), row)
            print(row_text(row, found), flush=True)
            print(json.dumps({"row": row, "load": os.getloadavg()[0]} | found), file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
