#!/usr/bin/env python3
"""Builds the program with -DSOMATO_PROFILE=robot and checks what docs/embedding.md promises.

  scripts/robot_profile.py [--program FILE] [--trainer FILE]

The program has at most 4 MB stripped; a command of a part that it lacks is refused with the part and with the build that
has it; its help lists no such command; it starts in at most 20 ms; 'somato live' of 45 taxels at a serial line stays within
12 MB of resident memory. Prints a table; the status is 1 if one fails. --program: one that is built already; --trainer:
the whole program, which trains the system that is read (default: build/release/somato). Times are medians of 51 starts, with
a real-time priority where that is permitted, so that other programs do not count. A person or './dev release' runs it, and no test: a build takes minutes.
"""

import argparse
import os
import re
import statistics
import struct
import subprocess
import sys
import tempfile
import threading
import time
import tty
import zlib
from pathlib import Path

import latency

TREE = latency.TREE
MOST_BYTES = 4_000_000
MOST_RESIDENT = 12_000_000
MOST_START = 0.020  # s
STARTS = 51
ANSWERS = 2000  # after which the memory is read
LEFT_OUT = ["sense", "reproduce", "sweep", "merge", "emulate", "report", "figure", "view", "som plot", "run", "information",
            "suggest", "touch-order", "systems", "som train", "som map", "som quality", "som cluster", "som features",
            "som predict", "import", "convert", "som import", "som export"]


def build():
    folder = TREE / "build/robot"
    subprocess.run(["cmake", "-S", TREE, "-B", folder, "-G", "Ninja", "-DSOMATO_PROFILE=robot"], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "somato_program"], check=True)
    return folder / "somato"


def stuffed(body):
    """COBS: `body` without zeros, between two zeros (docs/formats/sensor-frames.md). Shorter than 254 bytes between zeros."""
    blocks = body.split(b"\0")
    return b"\0" + b"".join(bytes([len(block) + 1]) + block for block in blocks) + b"\0"


def frame(number):
    counts = [1000 if taxel == number % latency.TAXELS else 0 for taxel in range(latency.TAXELS)]
    body = struct.pack(f"<BHI{latency.TAXELS}h", 1, number % 65536, number * 1000 % 2**32, *counts)
    return stuffed(body + struct.pack("<I", zlib.crc32(body)))


class Board:
    """A board that sends frames at 1 kHz into a pseudo-terminal, in a thread of its own."""

    def __init__(self, port):
        self.line, host = os.openpty()
        tty.setraw(host)
        os.set_blocking(self.line, False)
        port.unlink(missing_ok=True)
        port.symlink_to(os.ttyname(host))
        self.host = host  # stays open: the board outlives a program
        self.is_on = True
        self.thread = threading.Thread(target=self.send)
        self.thread.start()

    def send(self):
        number = 0
        while self.is_on:
            try:
                os.write(self.line, frame(number))
            except BlockingIOError:  # no program reads
                pass
            number += 1
            time.sleep(0.001)

    def end(self):
        self.is_on = False
        self.thread.join()


def undisturbed():
    """The words before a command that is measured."""
    words = ["chrt", "-f", "50"]
    return words if subprocess.run([*words, "true"], stderr=subprocess.DEVNULL, check=False).returncode == 0 else []


def live(program, folder, before=()):
    process = subprocess.Popen([*before, *latency.live_words(program)], cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL)
    process.stdin.write(b"\n")  # the thing is placed
    process.stdin.flush()
    return process


def end(process):
    process.terminate()
    process.stdout.read()
    process.wait()


def resident(process):
    """The present and the greatest memory in bytes."""
    lines = Path(f"/proc/{process.pid}/status").read_text(encoding="utf-8").splitlines()
    sizes = {line.split(":")[0]: line.split()[1] for line in lines if line.startswith("Vm")}
    return [1024 * int(sizes[name]) for name in ("VmRSS", "VmHWM")]


def memory_of_live(program, folder):
    process = live(program, folder)
    answers = sum(1 for _, line in zip(range(ANSWERS), process.stdout) if line.startswith(b"{"))
    sizes = resident(process)
    end(process)
    if answers < ANSWERS:
        raise SystemExit(f"robot_profile.py: live gave only {answers} answers")
    return sizes


def time_of(start):
    begin = time.monotonic()
    start()
    return time.monotonic() - begin


def start_of_live(program, folder, before):
    """Seconds from the start of the process to its first answer; frames arrive all the time."""
    begin = time.monotonic()
    process = live(program, folder, before)
    process.stdout.readline()
    seconds = time.monotonic() - begin
    end(process)
    return seconds


def refusals(program):
    """The commands that are not refused as they must be, and those in the help that this build lacks."""
    wrong = []
    for command in LEFT_OUT:
        done = subprocess.run([program, *command.split()], capture_output=True, text=True, check=False)
        if done.returncode != 2 or "SOMATO_PROFILE=robot" not in done.stderr:
            wrong.append(command)
    text = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
    listed = {line.split()[0] for line in text.splitlines() if re.match(r"  \w", line)}
    return wrong + sorted(listed.intersection({name.split()[0] for name in LEFT_OUT}))


def stripped_size(program, folder):
    subprocess.run(["strip", "-o", folder / "stripped", program], check=True)
    return (folder / "stripped").stat().st_size


def measured(program, trainer, folder):
    """Rows of the table: what, value, most, unit."""
    latency.write_files(trainer, folder)
    before = undisturbed()
    board = Board(folder / "port")
    try:
        now, most = memory_of_live(program, folder)
        live_start = statistics.median(start_of_live(program, folder, before) for _ in range(STARTS))
    finally:
        board.end()
    version = [*before, program, "--version"]
    start = statistics.median(time_of(lambda: subprocess.run(version, stdout=subprocess.DEVNULL, check=True))
                              for _ in range(STARTS))
    return [("program, stripped", stripped_size(program, folder) / 1e6, MOST_BYTES / 1e6, "MB"),
            ("live, resident", now / 1e6, MOST_RESIDENT / 1e6, "MB"),
            ("live, resident at most", most / 1e6, MOST_RESIDENT / 1e6, "MB"),
            ("start of --version", 1e3 * start, 1e3 * MOST_START, "ms"),
            ("start of live, to its first answer", 1e3 * live_start, 1e3 * MOST_START, "ms")]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path)
    parser.add_argument("--trainer", type=Path, default=TREE / "build/release/somato")
    options = parser.parse_args()
    program = (options.program or build()).resolve()
    with tempfile.TemporaryDirectory() as folder:
        rows = measured(program, options.trainer.resolve(), Path(folder))
    print("| | measured | at most |\n|---|---|---|")
    for what, value, most, unit in rows:
        print(f"| {what} | {value:.2f} {unit} | {most:.0f} {unit} |")
    wrong = refusals(program)
    for command in wrong:
        print(f"not refused, or in the help: {command}")
    return 1 if wrong or any(value > most for _, value, most, _ in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
