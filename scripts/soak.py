#!/usr/bin/env python3
"""Measures the memory, file handles and threads of a session of 'somato live' that reads very many frames.

  scripts/soak.py [recording] [device] [--frames N] [--programs FOLDER] [--write FOLDER]

`recording`: a recording of a million frames at --speed max, by the program itself. `device`: a hundred thousand frames of
an emulated device, whose clock the session moves, by bench/soak. Prints a line for each twentieth of the frames, and fails if
the memory after the first tenth grows by more than 5 %, or if a file handle or a thread more remains at the end. --write
puts the curves as SVG into a folder. It takes minutes: a person runs it, and no test.
"""

import argparse
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

TREE = Path(__file__).resolve().parent.parent
POINTS = 20  # lines of a curve
FLAT = 0.05  # greatest growth of the memory
TAXELS = 8
FRAMES_EACH = 1000  # frames of an exploration of the recording
SYSTEM = """[study]
name = "soak"
label = "object"
seeds = 1

[module.touch]
type = "channel"
channel = "touch"

[module.felt]
type = "accumulate"
input = "touch"

[module.unit]
type = "normalization"
input = "felt"

[module.map]
type = "som"
input = "unit"
rows = 5
columns = 5
iterations = 100
"""


def write_trials(folder, explorations, frames):
    """CSV files of numbers drawn at random, one for each exploration."""
    folder.mkdir()
    draw = random.Random(1)
    rows = [",".join(str(draw.randrange(100)) for _ in range(TAXELS)) for _ in range(1000)]
    head = ",".join(["time", *(f"t{i + 1}" for i in range(TAXELS))])
    for i in range(explorations):
        lines = [head] + [f"{row / 10},{rows[(i + row * 7) % 1000]}" for row in range(frames)]
        (folder / f"{'ab'[i % 2]}_{i + 1}.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


def make_recording(program, folder, name, explorations, frames):
    write_trials(folder / name, explorations, frames)
    subprocess.run([program, "import", "csv", name, "-o", f"{name}.mcap", "--files", "{object}_{trial:number}.csv",
                    "--time", "time", "--channels", f"touch:counts=t1..t{TAXELS}", "--quiet"], cwd=folder, check=True)


def train(program, folder):
    make_recording(program, folder, "few", 6, 50)
    (folder / "soak.toml").write_text(SYSTEM, encoding="utf-8")
    subprocess.run([program, "run", "soak.toml", "--data", "few.mcap", "--out", "out", "--quiet"], cwd=folder, check=True)
    return folder / "out" / "system.somato"


def measured(pid):
    """Memory in MiB, open files and threads of a process."""
    status = Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
    fields = dict(line.split(":", 1) for line in status.splitlines())
    return int(fields["VmRSS"].split()[0]) / 1024, len(os.listdir(f"/proc/{pid}/fd")), int(fields["Threads"])


def watch(process, frames, frames_a_line):
    """The points of a curve: frames, memory, files and threads."""
    points = []
    lines = 0
    for line in process.stdout:
        if line == b"end\n":
            break  # the program waits until it was measured
        if b'"final":true' in line:
            continue
        lines += 1
        read = lines * frames_a_line
        if read % (frames // POINTS) == 0:
            points.append((read, *measured(process.pid)))
            print(row_text(points[-1]), flush=True)
    return points


def row_text(point):
    frames, memory, files, threads = point
    return f"{frames:9} frames  {memory:7.1f} MiB  {files:3} files  {threads:3} threads"


def soak_recording(program, folder, frames):
    make_recording(program, folder, "many", frames // FRAMES_EACH, FRAMES_EACH)
    words = [program, "live", "--model", train(program, folder), "--recording", folder / "many.mcap", "--speed", "max"]
    with subprocess.Popen(words, stdout=subprocess.PIPE) as process:
        points = watch(process, frames, 1)
    return points, process.returncode


def soak_device(program, folder, frames):
    words = [program.parent / "bench" / "soak", train(program, folder), str(frames)]
    with subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        points = watch(process, frames, 1000)
        process.stdin.close()
    return points, process.returncode


def problems_of(points, status):
    """Why the soak has failed, one text each."""
    if status != 0:
        return [f"the program ended with status {status}"]
    if len(points) < POINTS:
        return [f"only {len(points)} of {POINTS} points were reached"]
    steady = points[POINTS // 10 - 1:]
    grown = max(memory for _, memory, _, _ in steady) / steady[0][1] - 1
    found = [f"the memory grew by {100 * grown:.1f} %"] if grown > FLAT else []
    for place, name in ((2, "file handles"), (3, "threads")):
        if points[-1][place] > steady[0][place]:
            found.append(f"{points[-1][place] - steady[0][place]} more {name}")
    return found


def svg(points):
    """The curve of the memory, from 0."""
    width, height, left, top = 560, 180, 70, 20
    most = 1.25 * max(memory for _, memory, _, _ in points)
    last = points[-1][0]
    at = [(left + width * frames / last, top + height * (1 - memory / most)) for frames, memory, _, _ in points]
    line = " ".join(f"{x:.1f},{y:.1f}" for x, y in at)
    base = top + height
    return f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {left + width + 20} {base + 40}" font-family="sans-serif" font-size="12">
<rect width="100%" height="100%" fill="white"/>
<path d="M{left} {top}V{base}H{left + width}" fill="none" stroke="black"/>
<polyline points="{line}" fill="none" stroke="#0072b2" stroke-width="2"/>
<text x="{left - 6}" y="{at[-1][1] + 4:.1f}" text-anchor="end">{points[-1][1]:.0f} MiB</text>
<text x="{left - 6}" y="{base + 4}" text-anchor="end">0</text>
<text x="{left + width}" y="{base + 18}" text-anchor="end">{last:,} frames</text>
<text x="{left}" y="{base + 34}">memory (resident), {points[-1][2]} open files and {points[-1][3]} threads at the end</text>
</svg>
"""


SOAKS = {"recording": (soak_recording, 1_000_000), "device": (soak_device, 100_000)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("soaks", nargs="*", choices=[*SOAKS, []], default=list(SOAKS))
    parser.add_argument("--frames", type=int, help="instead of a million, and a hundred thousand; a multiple of 20,000")
    parser.add_argument("--programs", type=Path, default=TREE / "build/bench", help="folder of the built programs")
    parser.add_argument("--write", type=Path, help="folder for soak_recording.svg and soak_device.svg")
    options = parser.parse_args()
    failed = False
    for name in options.soaks:
        soak, frames = SOAKS[name]
        print(f"{name}:")
        with tempfile.TemporaryDirectory() as folder:
            points, status = soak(options.programs.resolve() / "somato", Path(folder), options.frames or frames)
        problems = problems_of(points, status)
        print("\n".join(problems) or "flat")
        failed = failed or bool(problems)
        if options.write and points:
            (options.write / f"soak_{name}.svg").write_text(svg(points), encoding="utf-8")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
