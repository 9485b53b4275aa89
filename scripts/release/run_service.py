#!/usr/bin/env python3
"""Runs the command of the unit somato-live@ as systemd would, with a simulated hand, in the place of a service manager.

usage: run_service.py UNIT

Passes if the program says that it is ready, responds to the watchdog, prints readings and ends at a request.
"""

import json
import os
import re
import shlex
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PATIENCE = 120  # seconds, for slow machines
MODEL = """[study]
name = 'service'
seeds = 1
[module.joints]
type = 'channel'
channel = 'joints'
[module.closed]
type = 'last'
input = 'joints'
[module.map]
type = 'som'
input = 'closed'
rows = 4
columns = 4
iterations = 100
"""


def command_of(unit, variables):
    """The words of ExecStart; $NAME is split into words, ${NAME} is not, as systemd does it."""
    line = re.search(r"^ExecStart=(.*)$", unit, re.MULTILINE)[1].replace("%i", "skin")
    words = []
    for word in line.split():
        if whole := re.fullmatch(r"\$(\w+)", word):
            words += shlex.split(variables[whole[1]])
        else:
            words.append(re.sub(r"\$\{(\w+)\}", lambda found: variables[found[1]], word))
    return words


def learn(folder):
    (folder / "study.toml").write_text(MODEL, encoding="utf-8")
    for words in (["explore", "--body", "lucs2", "--explorations", "1", "-o", "train.mcap"],
                  ["run", "study.toml", "--data", "train.mcap", "--out", "out"]):
        subprocess.run(["somato", *words], cwd=folder, check=True, stdout=subprocess.DEVNULL)


def serve(command, folder):
    """The messages and the readings of the service until it has responded three times, and its status after SIGTERM."""
    messages = []
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager, \
            open(folder / "journal", "w+", encoding="utf-8") as journal:
        manager.bind(str(folder / "notify"))
        manager.settimeout(PATIENCE)
        environment = dict(os.environ, NOTIFY_SOCKET=str(folder / "notify"), WATCHDOG_USEC="2000000")
        with subprocess.Popen(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=journal) as service:
            while messages.count("WATCHDOG=1") < 3:
                messages.append(manager.recv(4096).decode())
            end = time.monotonic() + PATIENCE
            while '"final"' not in (folder / "journal").read_text(encoding="utf-8") and time.monotonic() < end:
                time.sleep(0.1)
            service.send_signal(signal.SIGTERM)
            while messages[-1] != "STOPPING=1":
                messages.append(manager.recv(4096).decode())
            status = service.wait(PATIENCE)
        journal.seek(0)
        return messages, [json.loads(line) for line in journal], status


def main():
    unit = Path(sys.argv[1]).read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        learn(folder)
        command = command_of(unit, {"SOMATO_MODEL": "out/system.somato", "SOMATO_SOURCE": "--body lucs2 --object boule",
                                    "SOMATO_OPTIONS": "-o {time}.mcap --every 1h"})
        print("$", *command)
        messages, readings, status = serve(command, folder)
        print(messages, len(readings), "readings, status", status)
        permitted = re.search(r"^SuccessExitStatus=(.*)$", unit, re.MULTILINE)[1].split()
        if messages[0] != "READY=1" or not readings or str(status) not in permitted:
            sys.exit("run_service: the service does not behave as its unit says")


if __name__ == "__main__":
    main()
