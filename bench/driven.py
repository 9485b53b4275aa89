"""Programs that run a case for each line on their standard input (see workloads.cc)."""

import json
import os
import select
import statistics
import subprocess
import tempfile

# These variables make OpenBLAS assume another processor, which can halve its speed.
MISLEADING = ("OPENBLAS_CORETYPE", "OPENBLAS_L2_SIZE")
THREAD_VARIABLES = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS",
                    "NUMBA_NUM_THREADS", "LOKY_MAX_CPU_COUNT")


class Failure(Exception):
    """A program could not be measured; the message states the reason in one line."""


def environment(threads):
    """The environment variables for a program with the given number of threads."""
    kept = {name: value for name, value in os.environ.items() if name not in MISLEADING}
    return {**kept, **{name: str(threads) for name in THREAD_VARIABLES}}


def last_line(text):
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return lines[-1] if lines else "it said nothing"


class Driven:
    """A running program; use it in a `with` statement."""

    def __init__(self, command, threads, patience):
        self.patience = patience  # maximum seconds for an answer
        self.errors = tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace")
        self.process = subprocess.Popen(
            [str(word) for word in command], env=environment(threads), text=True,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.errors)
        self.answer()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.process.stdin.close()
        self.process.stdout.close()
        self.errors.close()

    def answer(self):
        ready, _, _ = select.select([self.process.stdout], [], [], self.patience)
        if not ready:
            self.__exit__()
            raise Failure(f"no answer within {self.patience} s")
        line = self.process.stdout.readline()
        if line:
            return json.loads(line)
        self.process.wait()
        self.errors.seek(0)
        reason = last_line(self.errors.read())
        self.__exit__()
        raise Failure(reason)

    def ask(self, line):
        try:
            self.process.stdin.write(line + "\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            pass  # the missing answer is reported below
        return self.answer()

    def run(self):
        return self.ask("run")


def median(values):
    return statistics.median(values)
