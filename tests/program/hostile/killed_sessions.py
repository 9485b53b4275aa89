#!/usr/bin/env python3
"""Kills explore, view and live at random moments, and recovers what they recorded.

Each of them explores with a simulated body and with an emulated device. At a seeded moment its
process group is ended by SIGKILL. Every exploration whose end was shown before, and every name that
was confirmed, as well as its undo, must then be in the file, or be recovered from its partial file.

usage: killed_sessions.py --program FILE [--kills N] [--seed N] [--longest S]

The tests kill each of them few times; 100 times with the default values take half an hour.
"""

import argparse
import csv
import http.client
import json
import os
import pty
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request
from pathlib import Path

PATIENCE = 600.0  # seconds until a program must have started
THINGS = ("[material.bark]\nhardness = 'hard'\nstiffness = 40.0\n"
          "[material.moss]\nhardness = 'soft'\nstiffness = 3.0\n")
STUDY = ("[study]\nname = 'hardness'\nlabel = 'material'\nseeds = 1\n"
         "[module.stick]\ntype = 'channel'\nchannel = 'potentiometer'\n"
         "[module.end]\ntype = 'last'\ninput = 'stick'\n"
         "[module.map]\ntype = 'som'\ninput = 'end'\nrows = 1\ncolumns = 4\n"
         "normalize_input = false\niterations = 200\n")
EACH = 50  # explorations of each of two materials: one is a hundredth of the progress


class Session:
    """A program that explores, and what it has shown: the number of explorations, and names."""

    def __init__(self, program, folder, words):
        self.folder = folder
        self.shown = 0
        self.names = {}  # those that may be there, by the number of the exploration
        self.ours, theirs = pty.openpty()  # progress is for terminals
        self.process = subprocess.Popen([program, *words], cwd=folder, stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=theirs,
                                        start_new_session=True)
        os.close(theirs)

    def watch(self, work):
        """Runs `work` until the program is gone."""
        def until_the_end():
            try:
                work()
            except (OSError, ValueError, KeyError, http.client.HTTPException):
                pass  # it was killed meanwhile
        thread = threading.Thread(target=until_the_end, daemon=True)
        thread.start()
        return thread

    def kill_after(self, seconds, threads):
        """Waits that long, or until it has ended by itself."""
        try:
            self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            pass
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self.process.wait()
        for thread in threads:
            thread.join(PATIENCE)
        os.close(self.ours)

    def progress(self):
        """Follows the progress on standard error: 3 % are three of a hundred explorations."""
        text = ""
        while True:
            text = text[-200:] + os.read(self.ours, 4096).decode(errors="replace")
            for percent in re.findall(r"exploring: +(\d+) %", text):
                self.shown = max(self.shown, int(percent))

    def readings(self):
        """Follows the lines of live on standard output."""
        for line in self.process.stdout:
            said = json.loads(line)
            if said.get("final"):
                self.shown = said["exploration"]
            if "taught" in said:
                self.names[said["exploration"] - 1] = {said["taught"]}

    def viewing(self):
        """Has the view explore, and names what was explored."""
        line = self.process.stdout.readline().decode()
        if not line:
            return  # killed before it has printed its address
        address, token = re.search(r"(http://[^/]+)/\?token=(\w+)", line).groups()

        def ask(path, command=None):
            data = None if command is None else json.dumps(command).encode()
            headers = {"X-Somato-Token": token, "Origin": address,
                       "Content-Type": "application/json"}
            request = urllib.request.Request(f"{address}/api/{path}", data, headers)
            return json.load(urllib.request.urlopen(request, timeout=PATIENCE))

        ask("command", {"command": "speed", "speed": 100})
        while True:
            before = self.shown
            ask("command", {"command": "explore"})
            while self.shown == before:
                self.shown = len(ask("state")["explorations"])
            shown = ask("state")["explorations"][before]
            own = shown["labels"]["material"]
            name = f"thing {self.shown}"
            given = {"command": "name", "label": "material", "id": shown["id"]}
            undone = {**given, "value": "a name to be undone"}
            ask("command", undone)
            ask("command", {**undone, "command": "undo_name"})
            self.names[before] = {own, name}  # which is on its way
            ask("command", {**given, "value": name})
            self.names[before] = {name}


def run(program, folder, *words, codes=(0,)):
    done = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True,
                          timeout=PATIENCE, check=False)
    if done.returncode not in codes:
        raise AssertionError(f"{words}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done


def recovered(program, folder):
    """The explorations of the file or its partial file: [their labels]."""
    path = Path(folder, "a.mcap")
    partial = Path(folder, "a.mcap.partial")
    if partial.exists():
        again = run(program, folder, "explore", "--body", "hardness", "-o", "a.mcap", codes=(0, 2))
        if again.returncode == 0:
            return []  # nothing was in it
        command = "somato recover a.mcap.partial -o a.mcap"
        assert command in again.stderr, again.stderr
        run(program, folder, *command.split()[1:], codes=(0, 1, 3))
    if not path.exists():
        return []
    shutil.rmtree(Path(folder, "a_csv"), ignore_errors=True)
    run(program, folder, "convert", "a.mcap", "-o", "a_csv")
    frames = csv.DictReader(Path(folder, "a_csv", "potentiometer.csv").open(encoding="utf-8"))
    return list({frame["exploration"]: frame for frame in frames}.values())


def words_of(command, source):
    """The command line that explores with the source, which is `--body ...` or `--device ...`."""
    words = [command, *source, "--objects", "materials.toml", "-o", "a.mcap"]
    if command != "view":
        words += ["--explorations", str(EACH)]
    if command == "live":
        words += ["--model", "out/system.somato", "--teach", "taught.somato"]
        words += [] if "--device" in source else ["--speed", "max"]
    return words


def kill_once(program, folder, command, source, seconds):
    for name in ("a.mcap", "a.mcap.partial"):
        Path(folder, name).unlink(missing_ok=True)
    session = Session(program, folder, words_of(command, source))
    watched = [session.watch(session.progress)]
    if command == "live":
        session.process.stdin.write("".join(f"thing {i + 1}\n" for i in range(100)).encode())
        session.process.stdin.flush()
        watched.append(session.watch(session.readings))
    if command == "view":
        watched.append(session.watch(session.viewing))
    session.kill_after(seconds, watched)
    found = recovered(program, folder)
    problems = []
    if len(found) < session.shown:
        problems.append(f"{session.shown} explorations were shown, {len(found)} are there")
    lost = [names for number, names in session.names.items()
            if number >= len(found) or found[number].get("material") not in names]
    if lost:
        problems.append(f"{len(lost)} of {len(session.names)} names are not there: {lost[0]}")
    return session.shown, len(session.names), problems


class Emulation:
    """An emulated device, as long as this is used."""

    def __init__(self, program, folder):
        self.words = [program, "emulate", "--body", "hardness", "--bus", "ssc32", "--objects",
                      "materials.toml", "--clock", "host", "-o", "d.toml"]
        self.folder = folder

    def __enter__(self):
        self.process = subprocess.Popen(self.words, cwd=self.folder, stdout=subprocess.DEVNULL,
                                        stderr=subprocess.PIPE)
        self.process.stderr.readline()
        return ["--device", "d.toml"]

    def __exit__(self, *_):
        self.process.terminate()  # a shell's background job ignores SIGINT
        self.process.wait(PATIENCE)


class Simulation:
    """A simulated body."""

    def __init__(self, program, folder):
        del program, folder

    def __enter__(self):
        return ["--body", "hardness"]

    def __exit__(self, *_):
        pass


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--kills", type=int, default=100, help="of each command and body")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--longest", type=float, default=4.0, help="seconds until a kill")
    arguments = parser.parse_args()
    program = os.path.abspath(arguments.program)
    moments = random.Random(arguments.seed)
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "materials.toml").write_text(THINGS, encoding="utf-8")
        Path(folder, "study.toml").write_text(STUDY, encoding="utf-8")
        run(program, folder, "explore", "--body", "hardness", "--objects", "materials.toml", "-o",
            "train.mcap")
        run(program, folder, "run", "study.toml", "--data", "train.mcap", "--out", "out")
        for kind in (Simulation, Emulation):
            for command in ("explore", "view", "live"):
                shown = names = 0
                for _ in range(arguments.kills):
                    with kind(program, folder) as source:
                        seconds = moments.uniform(0.0, arguments.longest)
                        seen, given, problems = kill_once(program, folder, command, source, seconds)
                    shown, names = shown + seen, names + given
                    for problem in problems:
                        failed = True
                        print(f"{command} {source[0]}, killed after {seconds:.3f} s: {problem}")
                print(f"{command} {source[0]}: {arguments.kills} kills, {shown} explorations shown, "
                      f"{names} names")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
