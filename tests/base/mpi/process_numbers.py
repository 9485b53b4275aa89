"""Compares the maps that several processes of MPI train with those of one process, byte for byte.

Also with a process that is stopped for a while, and with one that is killed, after which another
number of processes continues from the checkpoint.

usage: process_numbers.py --program SOMATO [--mpiexec MPIEXEC...] [--all]
"""

import argparse
import itertools
import os
import random
import shlex
import signal
import struct
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path

COLUMNS = 8
ROWS = 240
EPOCHS = 4
MANY_EPOCHS = 60  # of a training that is killed, so that it is not over by then
ATTEMPTS = 5  # to kill it in time
LOGGED = 30  # seconds after which progress is reported
PATIENCE = 120  # seconds
# Reports its number and process before it becomes the program.
STARTED = 'echo $$ > process.${PMI_RANK:-$OMPI_COMM_WORLD_RANK}.new && ' \
          'mv process.${PMI_RANK:-$OMPI_COMM_WORLD_RANK}.new process.${PMI_RANK:-$OMPI_COMM_WORLD_RANK} && exec "$@"'


def array(kind, shape, numbers):
    """The bytes of an NPY file."""
    header = f"{{'descr': '<{kind}', 'fortran_order': False, 'shape': {shape}, }}".encode()
    header += b" " * (-(len(header) + 11) % 64) + b"\n"
    code = {"f4": "f", "f8": "d", "i4": "i"}[kind]
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + struct.pack(f"<{len(numbers)}{code}", *numbers)


def dense_rows():
    """Columns of different sizes, so that sums of doubles would depend on their order."""
    draw = random.Random(6)
    return [[draw.gauss(0, 1) * 1e-3 * 20**d for d in range(COLUMNS)] for _ in range(ROWS)]


def write_dense(folder):
    rows = dense_rows()
    (folder / "rows.npy").write_bytes(array("f4", (ROWS, COLUMNS), sum(rows, [])))
    return ["rows.npy"]


def write_text(folder):
    """A list of files, of which the last has names with line ends."""
    rows = [",".join(f"{value:.6g}" for value in row) + "\n" for row in dense_rows()]
    (folder / "some.csv").write_text("".join(rows[:70]), encoding="utf-8")
    (folder / "one.csv").write_text(rows[70], encoding="utf-8")
    quoted = ['"' + row.replace(",", '","').replace("\n", '"\n') for row in rows[71:]]
    (folder / "rest.csv").write_text("".join(quoted), encoding="utf-8")
    return ["some.csv", "one.csv", "rest.csv", "--header", "no"]


def write_sparse(folder):
    """A compressed matrix of scipy.sparse.save_npz with a quarter of the elements."""
    draw = random.Random(7)
    starts, places, values = [0], [], []
    for _ in range(ROWS):
        places += sorted(draw.sample(range(COLUMNS), 2))
        values += [draw.gauss(0, 1), draw.uniform(1, 50)]
        starts.append(len(places))
    header = b"{'descr': '|S3', 'fortran_order': False, 'shape': (), }"
    header += b" " * (-(len(header) + 11) % 64) + b"\n"
    with zipfile.ZipFile(folder / "rows.npz", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("indices.npy", array("i4", (len(places),), places))
        archive.writestr("indptr.npy", array("i4", (len(starts),), starts))
        archive.writestr("shape.npy", array("i4", (2,), [ROWS, COLUMNS]))
        archive.writestr("data.npy", array("f8", (len(values),), values))
        archive.writestr("format.npy", b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + b"csr")
    return ["rows.npz"]


SOURCES = {"dense": write_dense, "text": write_text, "sparse": write_sparse}


class Case:
    """A source of rows and flags of training, in a folder."""

    def __init__(self, options, folder, source, flags):
        self.options = options
        self.folder = folder
        self.words = ["som", "train", *SOURCES[source](folder), *flags, "--training", "batch",
                      "--rows", "4", "--columns", "6", "--threads", "1", "--memory", "20KiB"]
        self.name = " ".join([source, *flags])
        self.faults = []
        self.done(self.start(1, "one.map"))

    def start(self, processes, output, *more, epochs=EPOCHS):
        for old in self.folder.glob("process.*"):
            old.unlink()
        launcher = [*self.options.mpiexec, "-n", str(processes)] if processes > 1 else []
        return subprocess.Popen([*launcher, "sh", "-c", STARTED, "sh", self.options.program, *self.words, "-o", output,
                                 "--epochs", str(epochs), *more],
                                cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                env={"PMI_RANK": "0", **os.environ} if processes == 1 else None)

    def done(self, run):
        _, said = run.communicate(timeout=PATIENCE)
        if run.returncode != 0:
            self.faults.append(f"{self.name}: exit code {run.returncode}: {said}")
        return said

    def compare(self, output, what, expected="one.map"):
        one, other = self.folder / expected, self.folder / output
        if not other.exists() or one.read_bytes() != other.read_bytes():
            self.faults.append(f"{self.name}: another map from {what}")

    def check(self, processes):
        self.done(self.start(processes, "several.map"))
        self.compare("several.map", f"{processes} processes")

    def process(self, number):
        until = time.monotonic() + PATIENCE
        place = self.folder / f"process.{number}"
        while not place.exists():
            if time.monotonic() > until:
                raise SystemExit(f"{self.name}: process {number} has not started")
            time.sleep(0.01)
        return int(place.read_text(encoding="utf-8"))

    def signal_in_training(self, processes, output, number):
        """Starts a training, sends a signal to one process after the first checkpoint, and returns both.

        Before the checkpoint, a process may still be connecting to the others.
        """
        checkpoint = self.folder / "checkpoint"
        run = self.start(processes, output, "--checkpoint", "checkpoint", epochs=MANY_EPOCHS)
        process = self.process(processes - 1)
        until = time.monotonic() + PATIENCE
        while not checkpoint.exists() and run.poll() is None and time.monotonic() < until:
            time.sleep(0.001)
        if run.poll() is None:
            os.kill(process, number)
        return run, process

    def need_many(self):
        if not (self.folder / "many.map").exists():
            self.done(self.start(1, "many.map", epochs=MANY_EPOCHS))

    def check_stopped(self, processes, seconds):
        """The others wait for a process that is stopped. Progress is reported every half minute."""
        self.need_many()
        for _ in range(ATTEMPTS):
            run, process = self.signal_in_training(processes, "stopped.map", signal.SIGSTOP)
            time.sleep(seconds if run.poll() is None else 0)
            if run.poll() is None:
                break
            self.done(run)
        else:
            self.faults.append(f"{self.name}: no training has waited for a process that was stopped")
            return
        os.kill(process, signal.SIGCONT)
        said = self.done(run)
        if seconds > LOGGED and " left" not in said:
            self.faults.append(f"{self.name}: no progress is reported: {said}")
        self.compare("stopped.map", "a process that was stopped", "many.map")

    def kill_one(self, processes, output):
        """Whether a process was killed before the end of the training, and after a checkpoint."""
        run, _ = self.signal_in_training(processes, output, signal.SIGKILL)
        run.communicate(timeout=PATIENCE)
        return run.returncode != 0 and (self.folder / "checkpoint").exists() and not (self.folder / output).exists()

    def check_killed(self, processes, then):
        """Nothing but the current epoch is lost when a process is killed."""
        self.need_many()
        output = f"{processes}-{then}.map"
        for _ in range(ATTEMPTS):
            if self.kill_one(processes, output):
                break
            (self.folder / output).unlink(missing_ok=True)
        else:
            self.faults.append(f"{self.name}: no checkpoint after a process was killed")
        self.done(self.start(then, output, "--checkpoint", "checkpoint", epochs=MANY_EPOCHS))
        self.compare(output, f"{then} processes that continue from the checkpoint of {processes}", "many.map")
        if (self.folder / "checkpoint").exists():
            self.faults.append(f"{self.name}: the checkpoint remains")


def check_few(cases):
    """One of each kind, in the normal tests."""
    case = cases("dense", [])
    case.check(2)
    case.check_killed(3, 2)
    yield case
    case = cases("sparse", ["--similarity", "dot_product", "--topology", "torus"])
    case.check(3)
    yield case
    case = cases("text", ["--topology", "torus", "--initial-weights", "samples"])
    case.check_stopped(3, 0.5)
    yield case


def check_all(cases):
    kinds = [*itertools.product(["dense", "sparse"], ["euclidean", "dot_product"], ["plane", "torus"]),
             ("text", "euclidean", "torus"), ("text", "dot_product", "plane")]
    resumed = [(2, 3), (4, 1), (3, 7), (7, 2), (2, 4), (3, 1), (4, 2), (2, 1), (3, 2), (4, 3)]
    # Each source and each similarity with all of these numbers.
    numbers = itertools.cycle([(2, 7), (3, 4)])
    for (source, similarity, topology), together, (processes, then) in zip(kinds, numbers, resumed):
        case = cases(source, ["--similarity", similarity, "--topology", topology])
        for number in together:
            case.check(number)
        case.check_killed(processes, then)
        yield case
    case = cases("dense", [])
    case.check_stopped(2, LOGGED + 1)
    yield case


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True, type=os.path.abspath)
    parser.add_argument("--mpiexec", type=shlex.split, default=["mpiexec"], help="the launcher, with its flags")
    parser.add_argument("--all", action="store_true")
    options = parser.parse_args()
    faults = []
    with tempfile.TemporaryDirectory() as top:
        def cases(source, flags):
            folder = Path(tempfile.mkdtemp(dir=top))
            return Case(options, folder, source, flags)
        for case in (check_all if options.all else check_few)(cases):
            faults += case.faults
    print("\n".join(faults) or "all maps are the same")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
