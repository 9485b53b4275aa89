"""Studies of systems, and trained systems for control loops."""

import json
import os

import numpy as np

from . import _somato
from .drawing import Drawing
from .recording import Recording
from .som import SOM


class TrainedSystem:
    """A trained system, as ``study`` returns it or a file contains it. Immutable."""

    def __init__(self, inner):
        self._inner = inner

    def live(self) -> "Live":
        """The system for a control loop: a new one for each call."""
        return Live(self._inner.live())

    def save(self, path) -> None:
        """Writes the system to a file, which ``load``, ``somato live`` and ``somato view`` read."""
        self._inner.save(os.fspath(path))

    @property
    def toml(self) -> str:
        """The description of the system."""
        return self._inner.toml()


class Live:
    """A trained system that processes one frame after the other.

    After each frame its map has the winner of the exploration so far, as in a study.
    """

    def __init__(self, inner):
        self._inner = inner

    @property
    def channels(self) -> list[str]:
        """The channels of a frame."""
        return self._inner.channels()

    def start(self, frame_rate=0.0) -> None:
        """Begins an exploration with so many frames per second; 0 if unknown."""
        self._inner.start(float(frame_rate))

    def step(self, frame) -> None:
        """Processes a frame.

        Args:
            frame: Maps the name of each channel to its numbers.

        Raises:
            DataError: A module cannot process the frame; ``start`` is then required.
            KeyError: A channel is missing.
            ValueError: A channel has another number of elements.
        """
        self._inner.step([np.ascontiguousarray(frame[name], np.float32).ravel()
                          for name in self.channels])

    def winner(self) -> int:
        """The number of the map's winner for the exploration so far."""
        return self._inner.winner()

    def label(self) -> str | None:
        """The label of this neuron, or None if no training exploration named it."""
        return self._inner.label()


class Study:
    """The outcome of a study: a notebook shows its map, labelled by the training explorations.

    Attributes:
        results: The content of results.json (docs/reference/results.md), without the names of files.
        system: The system, trained on all explorations with the first seed.
        som: The map of this system, with the winners and the labels of all explorations. Its inputs
            are those of the map in the system, after all codes.
    """

    def __init__(self, outcome):
        self.results = json.loads(outcome.results)
        self.system = TrainedSystem(outcome.trained)
        self.som = SOM._of_samples(outcome.map, outcome.winners, outcome.class_names, outcome.classes)
        self._picture = outcome.picture

    @property
    def values(self):
        """Every metric as a DataFrame: protocol, group, metric, seed, value; a row for each seed."""
        return _frame(["protocol", "group", "metric", "seed", "value"], [
            (protocol["protocol"], protocol.get("group", ""), name, run["seed"], value)
            for protocol in self._protocols() for name, metric in protocol["metrics"].items()
            for run, value in zip(protocol["runs"], metric["values"])])

    @property
    def metrics(self):
        """Mean and standard deviation of every metric over the seeds, as a DataFrame."""
        return _frame(["protocol", "group", "metric", "mean", "sd"], [
            (protocol["protocol"], protocol.get("group", ""), name, metric["mean"], metric["sd"])
            for protocol in self._protocols() for name, metric in protocol["metrics"].items()])

    @property
    def predictions(self):
        """Every test as a DataFrame: protocol, group, seed, number of the sample, label, prediction
        and winner."""
        return _frame(["protocol", "group", "seed", "sample", "label", "prediction", "winner"], [
            (protocol["protocol"], protocol.get("group", ""), run["seed"], number, *row)
            for protocol in self._protocols() for run in protocol["runs"]
            for number, row in enumerate(zip(run["labels"], run["predictions"], run["winners"]))])

    def draw(self) -> Drawing:
        """The winners of all explorations on the map, as ``somato run`` draws them."""
        return Drawing(self._picture)

    def _protocols(self):
        return self.results["parts"][0]["protocols"]

    def _repr_svg_(self):
        return self._picture


def study(recording: Recording, system, *, threads=None, **settings) -> Study:
    """Trains and tests a system on a recording, as ``somato run`` does.

    The same study, recording and seeds give the same results as the program. Ctrl-C stops it.

    Args:
        recording: The explorations.
        system: A TOML file (docs/your-system.md), or the name of one that ``systems`` lists.
        threads: Threads that compute; None: as many as the machine runs at once.
        settings: Parameters of the table ``[study]``, such as ``seeds=20``, instead of those of the
            file.

    Raises:
        UsageError: The file or a parameter is wrong, or the recording lacks a channel or a label.
        DataError: The recording cannot be used for this study.
    """
    threads = _somato.available_threads() if threads is None else threads
    return Study(_somato.study(recording._inner, os.fspath(system), settings, threads))


def load(path) -> TrainedSystem:
    """The trained system in a file that ``somato run``, ``study`` or ``TrainedSystem.save`` wrote."""
    return TrainedSystem(_somato.load_system(os.fspath(path)))


def systems() -> list[str]:
    """The names of the systems and studies that the package contains."""
    return _somato.own_files()


def _frame(columns, rows):
    import pandas  # only here, because the package works without it

    return pandas.DataFrame(rows, columns=columns)
