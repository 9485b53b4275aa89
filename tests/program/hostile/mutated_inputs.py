#!/usr/bin/env python3
"""Gives damaged inputs to every command that reads them, and judges what comes of it.

For any damaged input: no signal, no memory above four times the input and 100 MB more than the whole
input takes, no time above 20 s, no success with a number in the output that is not finite. The same
seed damages alike.

usage: mutated_inputs.py --program FILE --source DIR [--count N] [--seed S]
"""

import argparse
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from small_inputs import ROWS, STUDY

LONGEST = 20  # seconds of processor time, which other work on the machine does not change
ENDLESS = 1200  # seconds after which a run is killed
ROOM = 100 * 2**20  # bytes beyond four times the input and what the whole input takes
MODELS = ("a.map", "out/system.somato")
NUMBER = re.compile(r"(?<![\w.\"'])-?\d+(?:\.\d+)?(?:e-?\d+)?(?![\w.\"'])")
NOT_FINITE = re.compile(rb"(?<![\w.])[-+]?(?:inf|nan)(?![\w.])", re.IGNORECASE)
OTHERS = ["0", "1", "2", "0.5", "7.25", "100", "-1", "1e300", "1e-300", "1e18", "nan", "inf", "-inf", '"x"', "true", "[]", "{}", "",
          "9" * 400, "[" * 300]

OBJECTS = """[object]
tube = { shape = "cylinder", diameter = 60.0, height = 130.0, material = "wood" }
[material.wax]
density = 900.0
"""
SETTINGS = """[simulation]
sensor_noise = 0.0
joint_noise = 0.1
[closing]
iteration = 0.05
longest = 20.0
settle = 0.3
"""


def other_text(text, draw):
    """`text` with a number replaced, a line lost, doubled or moved, or some characters lost."""
    numbers = list(NUMBER.finditer(text))
    lines = text.splitlines(keepends=True)
    kind = draw.randrange(6)
    if kind <= 2 and numbers:
        number = draw.choice(numbers)
        return text[:number.start()] + draw.choice(OTHERS) + text[number.end():]
    if kind == 3:
        lines.insert(draw.randrange(len(lines)), lines.pop(draw.randrange(len(lines))))
        return "".join(lines)
    if kind == 4:
        at = draw.randrange(len(lines))
        return "".join(lines[:at] + lines[at:at + 1] * draw.choice([0, 2]) + lines[at + 1:])
    at = draw.randrange(len(text))
    return text[:at] + text[at + draw.randrange(1, 20):]


def other_bytes(content, draw):
    """`content` with bits turned, cut, or with a part that stands twice."""
    kind = draw.randrange(4)
    at = draw.randrange(len(content))
    if kind == 0:
        return content[:at]
    if kind == 1:
        length = draw.randrange(1, 200)
        return content[:at] + content[at:at + length] * 2 + content[at + length:]
    turned = bytearray(content)
    for _ in range(draw.choice([1, 2, 20])):
        turned[draw.randrange(len(turned))] ^= 1 << draw.randrange(8)
    return bytes(turned)


def damaged(content, draw):
    for _ in range(draw.choice([1, 1, 1, 2])):
        try:
            content = other_text(content.decode(), draw).encode() if content else b""
        except UnicodeDecodeError:
            content = other_bytes(content, draw)
    return content


def crc_32c(content):
    """The checksum of model files, bit by bit from its polynomial."""
    crc = 0xFFFFFFFF
    for byte in content:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x82F63B78 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF


def with_right_checksum(model):
    """A model file whose length and checksum fit again, so that what lies behind them is read."""
    if len(model) < 28:
        return model
    whole = model[:16] + len(model).to_bytes(8, "little") + model[24:-4]
    return whole + crc_32c(whole).to_bytes(4, "little")


def without_checksums(recording):
    """An MCAP file whose checksums are 0, which means that there are none."""
    places = {0x06: 24, 0x0F: 0, 0x02: 16}  # in a chunk, the end of the data, the footer
    open_file = bytearray(recording)
    at = 8
    while at + 9 <= len(recording) - 8:
        if recording[at] in places:
            place = at + 9 + places[recording[at]]
            open_file[place:place + 4] = bytes(4)
        at += 9 + int.from_bytes(recording[at + 1:at + 9], "little")
    return bytes(open_file)


def run(words, folder):
    """(exit code, negative for a signal; seconds of processor time; bytes of memory; the output)."""
    started = time.monotonic()
    with tempfile.TemporaryFile() as printed:
        process = subprocess.Popen(words, cwd=folder, stdin=subprocess.DEVNULL, stdout=printed,
                                   stderr=subprocess.DEVNULL)
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() - started > ENDLESS:
                process.kill()
            time.sleep(0.002)
        process.returncode = 0  # it has been waited for
        printed.seek(0)
        return (os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime,
                usage.ru_maxrss * 1024, printed.read())


class Inputs:
    """Whole inputs, the commands that read them, and what these need with the whole ones."""

    def __init__(self, program, source, folder):
        self.program = program
        self.folder = folder
        self.prepare(source)
        explore = ["explore", "--body", "lucs3", "--explorations", "1", "--longest", "60"]
        study = ["--data", "rec.mcap"]
        self.commands = {  # INPUT stands for the damaged file, OUT for a place to write to
            "out/results.json": [["report", "INPUT", "-o", "OUT"]],
            "study.toml": [["run", "INPUT", *study, "--out", "OUT"],
                           ["information", "INPUT", *study], ["run", "INPUT", "--explain", *study]],
            "objects.toml": [[*explore, "--objects", "INPUT", "-o", "OUT"]],
            "settings.toml": [[*explore, "--objects", "objects.toml", "--settings", "INPUT",
                               "-o", "OUT"]],
            "out/system.somato": [["apply", "INPUT", "rec.mcap"]],
            "a.map": [["som", "map", "INPUT", "data.csv"], ["som", "quality", "INPUT", "data.csv"],
                      ["som", "plot", "INPUT", "data.csv", "-o", "OUT"]],
            "data.csv": [["som", "train", "INPUT", "-o", "OUT", "--rows", "3", "--columns", "3"],
                         ["som", "train", "INPUT", "-o", "OUT", "--rows", "3", "--columns", "3",
                          "--skip", "2", "--missing", "mean", "--memory", "200B",
                          "--training", "batch"],
                         ["som", "train", "INPUT", "-o", "OUT", "--rows", "3", "--columns", "3",
                          "--missing", "nearest", "--keep-constant-columns"],
                         ["som", "map", "a.map", "INPUT", "--missing", "nearest"],
                         ["som", "map", "a.map", "INPUT"]],
            "rec.mcap": [["inspect", "INPUT"], ["recover", "INPUT", "-o", "OUT"],
                         ["run", "study.toml", "--data", "INPUT", "--out", "OUT"],
                         ["apply", "out/system.somato", "INPUT"]]}
        self.commands["open.mcap"] = self.commands["rec.mcap"]
        self.usual = {tuple(words): self.measure(words, name)
                      for name, all_words in self.commands.items() for words in all_words}

    def prepare(self, source):
        texts = {"study.toml": STUDY, "objects.toml": OBJECTS, "settings.toml": SETTINGS,
                 "data.csv": ROWS}
        for name, text in texts.items():
            (self.folder / name).write_text(text, encoding="utf-8")
        for words in (["import", "icub_grasp", str(source / "examples/synthetic_grasps/trials"),
                       "-o", "rec.mcap"],
                      ["run", "study.toml", "--data", "rec.mcap", "--out", "out"],
                      ["som", "train", "data.csv", "-o", "a.map", "--rows", "4", "--columns", "4",
                       "--standardize"],
                      ["recover", "rec.mcap", "-o", "open.mcap", "--compression", "none"]):
            subprocess.run([self.program, *words], cwd=self.folder, check=True,
                           stdout=subprocess.DEVNULL)
        for model in MODELS:
            content = (self.folder / model).read_bytes()
            if with_right_checksum(content) != content:
                sys.exit(f"{model} has another checksum than docs/formats/model-file.md says")
        recording = self.folder / "open.mcap"
        recording.write_bytes(without_checksums(recording.read_bytes()))

    def words_for(self, words, given, out):
        return [self.program, *[{"INPUT": given, "OUT": out}.get(word, word) for word in words]]

    def measure(self, words, name):
        out = str(self.folder / "usual")
        code, _, memory, _ = run(self.words_for(words, name, out), self.folder)
        if code != 0:
            sys.exit(f"{' '.join(words)} fails with the whole {name}")
        shutil.rmtree(out, ignore_errors=True)
        Path(out).unlink(missing_ok=True)
        return memory

    def judge(self, name, words, number, draw):
        """Describes the failure of a damaged input's run, or None."""
        content = damaged((self.folder / name).read_bytes(), draw)
        if name in MODELS and draw.random() < 0.75:
            content = with_right_checksum(content)
        with tempfile.TemporaryDirectory(dir=self.folder) as place:
            given = Path(place) / f"input{Path(name).suffix}"
            given.write_bytes(content)
            whole = self.words_for(words, str(given), str(Path(place) / "out"))
            code, seconds, memory, printed = run(whole, self.folder)
            if code < 0 or code not in (0, 1, 2, 3):
                wrong = f"it ended with {code}"
            elif seconds > LONGEST:
                wrong = f"it took {seconds:.0f} s"
            elif memory > self.usual[tuple(words)] + 4 * len(content) + ROOM:
                wrong = f"it took {memory >> 20} MiB"
            elif code == 0 and NOT_FINITE.search(printed):
                wrong = "it printed a number that is not finite"
            else:
                return None
            kept = self.folder.parent / f"damaged_{number}{given.suffix}"
            kept.write_bytes(content)
            return f"{number}: {' '.join(words)} with {kept}: {wrong}"


def main():
    parser = argparse.ArgumentParser(description="Gives damaged inputs to every command.")
    parser.add_argument("--program", required=True)
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    scratch = Path(tempfile.mkdtemp(prefix="somato-damaged-"))
    folder = scratch / "inputs"
    folder.mkdir()
    inputs = Inputs(str(Path(given.program).resolve()), given.source.resolve(), folder)
    tasks = [(name, words) for name, all_words in inputs.commands.items() for words in all_words]

    def one(number):
        name, words = tasks[number % len(tasks)]
        return inputs.judge(name, words, number, random.Random(f"{given.seed} {number}"))

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        wrong = [what for what in pool.map(one, range(given.count)) if what]
    for what in wrong:
        print(what, file=sys.stderr)
    print(f"{given.count} damaged inputs, {len(wrong)} judged wrong")
    shutil.rmtree(folder)
    if not wrong:
        scratch.rmdir()
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
