"""What batch training costs with one and several processes of MPI, and what it would cost with more.

usage: processes.py measure FILE [--seconds N]   measures what FILE (JSON) does not contain yet
       processes.py report FILE                  fits the model, checks it, and predicts

A measurement is the wall time of an epoch: the difference between two runs of `somato som train`
with different numbers of epochs, divided by that number. The rows are uniformly distributed.
"""

import argparse
import array
import json
import math
import random
import struct
import subprocess
import time
from pathlib import Path
from statistics import median

TREE = Path(__file__).resolve().parent.parent
REPEATS = 5
LEAST_SECONDS = 0.4  # of the epochs that are measured
INTEGER = 8  # bytes of a sum
BLOCK = 8  # columns that are added at the same time

# Samples, dimensions, neurons.
FITTED = [(20000, 16, 100), (20000, 64, 100), (20000, 64, 400), (10000, 256, 100), (5000, 256, 900), (40000, 16, 400),
          (20000, 16, 900), (2000, 256, 2500), (1000, 64, 10000), (1000, 16, 2500), (60000, 8, 64)]
LEFT_OUT = [(25000, 40, 324), (12000, 150, 256), (6000, 80, 1600), (50000, 12, 144), (3000, 48, 6400)]
# For each process of two; the sums of the last take 80 MiB.
ALL_REDUCED = [(1000, 16, 100), (1000, 64, 2500), (1000, 64, 10000), (1000, 128, 10000), (500, 256, 40000)]
COMPARED = [(40000, 64, 400), (20000, 256, 900), (60000, 16, 2500), (200000, 64, 400), (100000, 256, 900), (200000, 16, 2500)]

# Assumptions of the prediction, not measured.
LATENCY = 10e-6  # seconds for a message
BANDWIDTH = 10e9  # bytes per second and process
SMALL_SUMS = 3  # agreements of an epoch, each of one integer per process
SAMPLES = 10**9
PREDICTED = [(16, 400), (64, 2500), (64, 10000), (256, 2500), (256, 40000), (1000, 10000)]


class Runs:
    """Runs of the program on rows that are written once."""

    def __init__(self, options, folder):
        self.options = options
        self.folder = folder

    def rows(self, samples, dimensions):
        path = self.folder / f"{samples}x{dimensions}.npy"
        if not path.exists():
            header = f"{{'descr': '<f4', 'fortran_order': False, 'shape': ({samples}, {dimensions}), }}".encode()
            header += b" " * (-(len(header) + 11) % 64) + b"\n"
            draw = random.Random(samples + dimensions)
            numbers = array.array("f", (draw.random() for _ in range(samples * dimensions)))
            path.write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + numbers.tobytes())
        return path

    def seconds(self, size, epochs, processes, threads):
        samples, dimensions, neurons = size
        side = math.isqrt(neurons)
        launcher = [*self.options.mpiexec.split(), "-n", str(processes)] if processes > 1 else []
        command = [*launcher, self.options.program, "som", "train", self.rows(samples, dimensions), "-o", self.folder / "map",
                   "--training", "batch", "--epochs", epochs, "--rows", side, "--columns", side, "--threads", threads]
        started = time.perf_counter()
        subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)
        return time.perf_counter() - started

    def epoch(self, size, processes=1, threads=1):
        samples, dimensions, neurons = size
        guess = samples * dimensions * neurons * 5e-11 + neurons * dimensions * 1e-7 + samples * 1e-7
        epochs = max(3, min(200, math.ceil(LEAST_SECONDS / guess)))
        few = self.seconds(size, 1, processes, threads)
        return (self.seconds(size, epochs + 1, processes, threads) - few) / epochs


def tasks():
    """Every measurement: its name and what it needs."""
    for size in [*FITTED, *LEFT_OUT, *ALL_REDUCED]:
        yield {"size": size, "processes": 1, "threads": 1}
    for samples, dimensions, neurons in ALL_REDUCED:
        yield {"size": (2 * samples, dimensions, neurons), "processes": 2, "threads": 1}
    for size in COMPARED:
        yield {"size": size, "processes": 1, "threads": 2}
        yield {"size": size, "processes": 2, "threads": 1}


def name_of(task):
    samples, dimensions, neurons = task["size"]
    return f"{samples} x {dimensions}, {neurons} neurons, {task['processes']} processes, {task['threads']} threads"


def measure(options):
    """Repetitions alternate, so that other load reaches all alike."""
    path = Path(options.file)
    measured = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    until = time.monotonic() + options.seconds
    folder = path.with_suffix(".rows")
    folder.mkdir(exist_ok=True)
    runs = Runs(options, folder)
    for repeat in range(REPEATS):
        for task in tasks():
            done = measured.setdefault(name_of(task), [])
            if len(done) > repeat:
                continue
            if time.monotonic() > until:
                return
            done.append(runs.epoch(**task))
            path.write_text(json.dumps(measured, indent=1), encoding="utf-8")
    print("complete")


def terms(size):
    """The parts of an epoch's time: distances; their comparison; sums by winner; samples; smoothing and new weights."""
    samples, dimensions, neurons = size
    return [samples * dimensions * neurons, samples * neurons, samples * dimensions, samples, neurons * columns_of_sums(dimensions)]


NAMES = ["sample, dimension and neuron", "sample and neuron", "sample and dimension", "sample", "neuron and column of sums"]


def columns_of_sums(dimensions):
    """The dimensions and the numbers of samples, in blocks."""
    return BLOCK * math.ceil((dimensions + 1) / BLOCK)


def solve(rows, goals):
    """Least squares by normal equations and elimination."""
    count = len(rows[0])
    system = [[sum(row[i] * row[j] for row in rows) for j in range(count)] + [sum(row[i] * goal for row, goal in zip(rows, goals))]
              for i in range(count)]
    for i in range(count):
        best = max(range(i, count), key=lambda k: abs(system[k][i]))
        system[i], system[best] = system[best], system[i]
        for k in range(count):
            if k != i:
                factor = system[k][i] / system[i][i]
                system[k] = [a - factor * b for a, b in zip(system[k], system[i])]
    return [system[i][count] / system[i][i] for i in range(count)]


def fit(rows, seconds, noise):
    """Coefficients that are not negative and have the least squares of errors relative to the noise."""
    used = list(range(len(rows[0])))
    while True:
        found = solve([[row[i] / unit for i in used] for row, unit in zip(rows, noise)],
                      [goal / unit for goal, unit in zip(seconds, noise)])
        if min(found) >= 0:
            return [found[used.index(i)] if i in used else 0.0 for i in range(len(rows[0]))]
        used.pop(found.index(min(found)))


def value(coefficients, parts):
    return sum(a * b for a, b in zip(coefficients, parts))


def sum_bytes(dimensions, neurons):
    return INTEGER * neurons * columns_of_sums(dimensions)


class Model:
    """The time of an epoch, from measurements."""

    def __init__(self, measured):
        self.measured = measured
        single = [self.of(size) for size in FITTED]
        self.compute = fit([terms(size) for size in FITTED], single, single)
        single = [self.of(size) for size in ALL_REDUCED]
        self.more = [self.of((2 * s, d, n), 2) - seconds for (s, d, n), seconds in zip(ALL_REDUCED, single)]
        self.reduce = fit([[1.0, sum_bytes(d, n)] for _, d, n in ALL_REDUCED], self.more, single)

    def of(self, size, processes=1, threads=1):
        return median(self.measured[name_of({"size": size, "processes": processes, "threads": threads})])

    def computing(self, samples, dimensions, neurons):
        return value(self.compute, terms((samples, dimensions, neurons)))

    def communication(self, processes, dimensions, neurons):
        """Halving and doubling: each byte is sent and received twice, and added as on this machine."""
        if processes == 1:
            return 0.0
        steps = 2 * math.ceil(math.log2(processes))
        size = sum_bytes(dimensions, neurons)
        small = SMALL_SUMS * steps * (LATENCY + INTEGER * processes / BANDWIDTH)
        return small + steps * LATENCY + 2 * size / BANDWIDTH + self.reduce[1] * size

    def epoch(self, processes, dimensions, neurons):
        own = self.computing(SAMPLES / processes, dimensions, neurons)
        return own + self.communication(processes, dimensions, neurons)

    def limit(self, dimensions, neurons):
        """The processes with which one needs for its samples as long as for all else."""
        processes = 1
        while processes < 2**40:
            samples = SAMPLES / processes
            own = self.computing(samples, dimensions, neurons)
            smoothing = self.computing(0, dimensions, neurons)
            if own - smoothing <= smoothing + self.communication(processes, dimensions, neurons):
                return processes
            processes = math.ceil(processes * 1.01)
        return processes


def report(options):
    model = Model(json.loads(Path(options.file).read_text(encoding="utf-8")))
    print("Nanoseconds for each")
    for name, seconds in zip(NAMES, model.compute):
        print(f"  {name}: {1e9 * seconds:.3g}")
    print(f"All-reduce between two processes here: {1e6 * model.reduce[0]:.0f} us and {1e9 * model.reduce[1]:.2f} ns per byte")
    for (_, dimensions, neurons), seconds in zip(ALL_REDUCED, model.more):
        print(f"  {sum_bytes(dimensions, neurons)} bytes: {1e3 * seconds:.2f} ms")
    for title, sizes in (("Fitted", FITTED), ("Left out", LEFT_OUT)):
        print(title)
        for size in sizes:
            predicted, seconds = model.computing(*size), model.of(size)
            print(f"  {size[0]} x {size[1]}, {size[2]} neurons: {1e3 * seconds:.2f} ms, model {100 * (predicted / seconds - 1):+.0f} %")
    print("Two processes against two threads")
    for size in COMPARED:
        threads, processes = model.of(size, 1, 2), model.of(size, 2, 1)
        print(f"  {size[0]} x {size[1]}, {size[2]} neurons: {1e3 * threads:.1f} and {1e3 * processes:.1f} ms, "
              f"{100 * (processes / threads - 1):+.1f} %")
    print(f"Epoch with {SAMPLES:.0e} samples: 1 process, 1000 processes, efficiency, processes at which scaling stops")
    for dimensions, neurons in PREDICTED:
        one, many = model.epoch(1, dimensions, neurons), model.epoch(1000, dimensions, neurons)
        print(f"  {dimensions} dimensions, {neurons} neurons: {one:.0f} s, {many:.2f} s, {100 * one / many / 1000:.0f} %, "
              f"{model.limit(dimensions, neurons)}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("task", choices=["measure", "report"])
    parser.add_argument("file")
    parser.add_argument("--seconds", type=float, default=math.inf, help="begin no measurement later")
    parser.add_argument("--program", default=TREE / "build/bench/somato")
    parser.add_argument("--mpiexec", default="mpiexec", help="the launcher, with its flags")
    options = parser.parse_args()
    {"measure": measure, "report": report}[options.task](options)


if __name__ == "__main__":
    main()
