"""What the estimators do to their process: memory, threads, signals."""

import os
import resource
import signal
import threading
import tracemalloc
import warnings
from pathlib import Path

import numpy as np
import pytest

from pysomato import SOM, ConversionWarning
from pysomato._inputs.rows import rows_of

MEGABYTE = 2**20
LONG = "SOMATO_LONG_TESTS" in os.environ


def memory():
    """Resident memory in bytes."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()


def peak_during(work):
    """The growth of the resident memory during work() at its peak, in bytes."""
    Path("/proc/self/clear_refs").write_text("5")  # resets the peak
    before = memory()
    work()
    lines = Path("/proc/self/status").read_text().splitlines()
    peak = next(line for line in lines if line.startswith("VmHWM"))
    return int(peak.split()[1]) * 1024 - before


def test_rows_are_not_copied():
    rows = np.random.default_rng(1).random((200_000, 32), np.float32)  # 24 MB
    som = SOM(3, 3, iterations=1000)
    assert peak_during(lambda: som.fit(rows)) < 12 * MEGABYTE
    assert peak_during(lambda: som.predict(rows)) < 12 * MEGABYTE
    assert peak_during(lambda: som.score(rows)) < 12 * MEGABYTE
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ConversionWarning)
        assert peak_during(lambda: som.predict(rows.astype(np.float64))) > 24 * MEGABYTE


def test_rows_in_c_order_are_taken_as_they_are(X):
    assert np.shares_memory(rows_of(SOM(), X, reset=True), X)
    assert not np.shares_memory(rows_of(SOM(), np.asfortranarray(X), reset=True), X)
    som = SOM(3, 3, iterations=10).fit(X)
    rows = np.tile(X, (1000, 1))  # 1.7 MB
    tracemalloc.start()
    som.predict(rows)  # 0.5 MB of winners
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < MEGABYTE


def test_memory_does_not_grow(X):
    som = SOM(4, 4, iterations=10, threads=1)

    def work(times):
        for _ in range(times):
            som.fit(X).predict(X)
            som.transform(X)

    work(50)
    before = memory()
    work(10_000 if LONG else 1000)
    assert memory() - before < 5 * MEGABYTE


class Stopped(Exception):
    pass


@pytest.fixture
def stopping():
    """SIGALRM raises Stopped, as Ctrl-C raises KeyboardInterrupt."""

    def stop(*_):
        raise Stopped

    previous = signal.signal(signal.SIGALRM, stop)
    yield
    signal.signal(signal.SIGALRM, previous)


def stop_soon():
    signal.setitimer(signal.ITIMER_REAL, 0.2)


@pytest.mark.usefixtures("stopping")
def test_trainings_of_two_threads_overlap(X):
    # The training without end ends only because another thread trains a map in the meantime.
    def train_and_stop():
        SOM(4, 4, iterations=100, threads=1).fit(X)
        signal.raise_signal(signal.SIGALRM)

    other = threading.Timer(0.1, train_and_stop)
    with pytest.raises(Stopped):
        other.start()
        SOM(iterations=10**12, threads=1).fit(X)
    other.join()


@pytest.mark.parametrize("settings", [
    {"iterations": 10**12}, {"training": "batch", "epochs": 10**9},
    {"iterations": 10**12, "arithmetic": "inner_products"}])
@pytest.mark.usefixtures("stopping")
def test_signals_stop_a_training(X, settings):
    som = SOM(threads=2, **settings)
    with pytest.raises(Stopped):
        stop_soon()
        som.fit(X)
    assert not hasattr(som, "map_")


@pytest.mark.usefixtures("stopping")
def test_signals_stop_a_search_of_winners(X):
    som = SOM(150, 150, iterations=1, threads=1).fit(X)
    rows = np.tile(X, (20_000, 1))
    with pytest.raises(Stopped):
        stop_soon()
        som.score(rows)
