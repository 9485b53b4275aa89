#!/usr/bin/env python3
"""Explores with emulated devices in real time, which no test does: a busy machine may fail here.

Prints a line for each device with the latency of its answers, and the number of devices that stopped.
"""

import re
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

SOMATO = Path(__file__).resolve().parent.parent / "build/bench/somato"
PATIENCE = 600  # seconds for a command
DEVICES = [("lucs3", "sts", 1), ("lucs3", "sts", 10), ("lucs2", "ssc32", 4), ("hardness", "dynamixel", 4),
           ("texture", "sts", 1), ("texture", "sts", 4)]


class Emulation:
    """The program that emulates a device, from the file that it writes until the end of the block."""

    def __init__(self, folder, body, bus, clock):
        self.words = [SOMATO, "emulate", "--body", body, "--bus", bus, "--clock", str(clock), "-o", "device.toml"]
        self.folder = folder

    def __enter__(self):
        self.process = subprocess.Popen(self.words, cwd=self.folder, stdout=subprocess.PIPE, text=True)
        self.process.stdout.readline()  # The file is whole before it is announced.
        return self

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGINT)
        self.process.communicate(timeout=PATIENCE)


def somato(folder, *words):
    return subprocess.run([SOMATO, *words], cwd=folder, capture_output=True, text=True, timeout=PATIENCE,
                          stdin=subprocess.DEVNULL, check=False)


def measure(body, bus, clock):
    """What the device says of itself, and the reason why it stopped (empty: it did not)."""
    with tempfile.TemporaryDirectory() as folder, Emulation(folder, body, bus, clock):
        checked = somato(folder, "device", "check", "device.toml")
        if checked.returncode != 0:
            return "", checked.stderr.strip()
        answers = re.search(r"^answers: (.*)$", checked.stdout, re.MULTILINE)
        explored = somato(folder, "explore", "--device", "device.toml", "--explorations", "1", "-o", "felt.mcap")
        said = answers[1] if answers else "no answers"
        return said, "" if explored.returncode == 0 else explored.stderr.strip()


def main():
    stopped = 0
    for body, bus, clock in DEVICES:
        said, reason = measure(body, bus, clock)
        stopped += reason != ""
        print(f"{body} on {bus}, {clock} s per second: {said or 'not checked'}; {reason or 'explored'}", flush=True)
    print(f"{stopped} of {len(DEVICES)} devices stopped")
    return 1 if stopped else 0


if __name__ == "__main__":
    sys.exit(main())
