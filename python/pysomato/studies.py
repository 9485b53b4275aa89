"""Systems, studies of them, and trained systems for control loops."""

import json
import math
import os
import tempfile
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from . import _somato
from ._data_sets.channels import frames_of
from ._frames import frame
from ._inputs.numbers import number_of_threads
from ._program import run_program
from ._progress import shown
from .drawing import Drawing, Page
from .errors import MissingChannelError, OperatingSystemError
from .figures import figure
from .recording import Recording
from .som import SOM


class System:
    """A system of modules and its study, as a TOML file describes them. Immutable.

    Args:
        source: The file (docs/your-system.md), or the name of one that ``systems`` lists.

    Raises:
        UsageError: A table or a key of the file is wrong.
        OperatingSystemError: The file cannot be read.
    """

    def __init__(self, source):
        self._inner = _somato.StudyDescription.read(os.fspath(source))

    @property
    def name(self) -> str:
        """The name of the study."""
        return self._inner.name

    @property
    def modules(self) -> list[dict]:
        """Name, type, inputs and parameters of each module, as the file gives them."""
        return self._inner.modules()

    @property
    def toml(self) -> str:
        """The description as TOML, without defaults."""
        return self._inner.toml()

    def fit(self, recording: Recording, *, seed=1, threads=None, progress=None,
            **settings) -> "TrainedSystem":
        """The system, trained on all explorations; their labels name the neurons of its map.

        It is the system that ``study`` returns for this seed. Parameters that only the protocols of
        the file read have no effect. ``threads``, ``progress``,
        ``settings`` and errors are those of ``study``.
        """
        return study(recording, self, threads=threads, progress=progress, protocols=["train_is_test"],
                     seeds=1, first_seed=seed, **settings).system

    def __repr__(self):
        names = ", ".join(module["name"] for module in self.modules)
        return f"<System {self.name}: {names}>"


class TrainedSystem:
    """A trained system, as ``System.fit`` and ``study`` return it or a file contains it. Immutable.

    A notebook shows the U-matrix of its map.
    """

    def __init__(self, inner):
        self._inner = inner

    @property
    def modules(self) -> list[dict]:
        """Name, type, inputs, parameters and type of the output of each module. Parameters that were
        ``automatic`` and affect the shape of the output have the values that the training gave them.
        """
        return self._inner.modules()

    def evaluate(self, recording: Recording, module, *, threads=None) -> list[np.ndarray]:
        """The output of a module for each exploration: float32 of the module's shape, after an axis
        of the frames if it has an output for each frame.

        Raises:
            UsageError: There is no such module; the message names the nearest one.
            DataError: The recording does not fit the system, or a module cannot process it.
        """
        return self._inner.outputs(recording._inner, module, number_of_threads(threads, "evaluate"))

    def answers(self, recording: Recording, *, threads=None):
        """What the system reads from each exploration, as a DataFrame, like ``somato apply``.

        The columns are the winner of its map, the winner's distance, the ``answer``, which is
        ``"unknown"`` if the exploration is too far from all that the system has learned, the most
        similar class (``nearest``), and the ``novelty``, above 1 for an unknown exploration; NaN if
        the system was trained without ``unknown=True``.

        Raises:
            DataError: The recording does not fit the system, a module cannot process it, or the
                system has no map that answers.
        """
        rows = self._inner.answers(recording._inner, number_of_threads(threads, "answers"))
        return frame(["winner", "distance", "answer", "nearest", "novelty"],
                     [(*row[:4], math.nan if row[4] is None else row[4]) for row in rows])

    def contributions(self, recording: Recording, *, threads=None):
        """Which sensors separate the answer for each exploration from the next class, as a DataFrame,
        like ``somato apply --contributions``.

        It has a row for each exploration and element of a channel that the system reads: number of
        the exploration from 0, the most similar class (``nearest``), the nearest ``other`` class, the
        ``distance`` of the neuron of each, ``channel``, ``element`` and its ``contribution``. A
        positive one makes the exploration more similar to ``nearest``; those of an exploration sum to
        ``other_distance`` minus ``distance``, for a dot-product map, whose inner products these are,
        to the opposite. ``attrs["unit"]`` is their unit, empty without one. Where a code cannot be
        traced to a channel, such as that of a T-MPSOM, ``channel`` is the name of its module.

        Raises:
            DataError: Those of ``answers``; fewer than two classes have a neuron.
        """
        sources, unit, rows = self._inner.contributions(recording._inner,
                                                        number_of_threads(threads, "contributions"))
        found = frame(["exploration", "nearest", "other", "distance", "other_distance", "channel",
                       "element", "contribution"],
                      [(number, *of_both, name, element, value)
                       for number, (*of_both, values) in enumerate(rows)
                       for (name, _, elements), numbers in zip(sources, values)
                       for element, value in zip(elements, numbers.tolist())])
        found.attrs["unit"] = unit
        return found

    def teach(self, recording: Recording, exploration: int, name: str) -> "TrainedSystem":
        """A system that answers ``name`` for this exploration, too (docs/continual.md, Teaching).

        If the system does not answer it already, one neuron without a name, or a new one, receives
        the input of the exploration; all other neurons remain as they are. This system is not
        changed.

        Args:
            exploration: Its number in the recording, from 0; from -1 backwards.
            name: At most 255 bytes of UTF-8 without control characters.

        Raises:
            IndexError: There is no such exploration.
            TypeError: The name is not a ``str``.
            UsageError: The name is empty, "unknown" or too long, or has control characters; or all
                neurons have names.
            DataError: Those of ``answers``.
        """
        if not isinstance(name, str):
            raise TypeError(f"name must be a str, not {type(name).__name__}")
        number = range(len(recording))[exploration]
        return TrainedSystem(self._inner.taught(recording._inner, number, name))

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

    def _repr_svg_(self):
        return self._inner.picture()


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
            MissingChannelError: A channel is missing; it is a KeyError, too.
            ValueError: A channel has another number of elements.
        """
        self._inner.step([self._values_of(frame, name) for name in self.channels])

    def _values_of(self, frame, name):
        if name not in frame:
            raise MissingChannelError(f"the frame lacks the channel '{name}'", "Live.step(frame)",
                                      f"channels are: {', '.join(self.channels)}")
        return frames_of(np.ma.atleast_1d(frame[name]).reshape(1, -1), f"Live.step(frame): {name}")[0]

    def winner(self) -> int:
        """The number of the map's winner for the exploration so far."""
        return self._inner.winner()

    def label(self) -> str | None:
        """The label of the most similar neuron that a training exploration named, as ``somato live``
        and ``TrainedSystem.answers`` (``nearest``) give it; None if the system was trained without labels.
        """
        return self._inner.label()


class Study:
    """The outcome of a study: a notebook shows its map, labelled by the training explorations.

    Attributes:
        results: The content of results.json (docs/reference/results.md), without the names of files.
        system: The system, trained on all explorations with the first seed.
        som: The map of this system, with the winners and the labels of all explorations. Its inputs
            are those of the map in the system, after all codes.
    """

    def __init__(self, outcome, recording):
        self._outcome = outcome
        self._recording = recording
        self.results = json.loads(outcome.results)
        self.system = TrainedSystem(outcome.trained)
        self.som = SOM._of_samples(outcome.map, outcome.winners, outcome.class_names, outcome.classes)
        self._picture = outcome.picture

    @property
    def values(self):
        """Every metric as a DataFrame: protocol, group, metric, seed, value; a row for each seed."""
        return frame(["protocol", "group", "metric", "seed", "value"], [
            (protocol["protocol"], protocol.get("group", ""), name, run["seed"], value)
            for protocol in self._protocols() for name, metric in protocol["metrics"].items()
            for run, value in zip(protocol["runs"], metric["values"])])

    @property
    def metrics(self):
        """Mean and standard deviation of every metric over the seeds, as a DataFrame."""
        return frame(["protocol", "group", "metric", "mean", "sd"], [
            (protocol["protocol"], protocol.get("group", ""), name, metric["mean"], metric["sd"])
            for protocol in self._protocols() for name, metric in protocol["metrics"].items()])

    @property
    def predictions(self):
        """Every test as a DataFrame: protocol, group, seed, number of the sample, label, prediction
        and winner."""
        return frame(["protocol", "group", "seed", "sample", "label", "prediction", "winner"], [
            (protocol["protocol"], protocol.get("group", ""), run["seed"], number, *row)
            for protocol in self._protocols() for run in protocol["runs"]
            for number, row in enumerate(zip(run["labels"], run["predictions"], run["winners"]))])

    def draw(self) -> Drawing:
        """The winners of all explorations on the map, as ``somato run`` draws them."""
        return Drawing(self._picture)

    def save(self, folder) -> None:
        """Writes results.json, map.svg and system.somato to a folder, as ``somato run`` does.

        Raises:
            OperatingSystemError: The folder cannot be made, or a file cannot be written.
        """
        try:
            os.makedirs(folder, exist_ok=True)
        except OSError as error:
            raise OperatingSystemError(error.strerror or str(error), os.fspath(folder)) from error
        self._outcome.save(os.fspath(folder))

    def report(self, height=720) -> Page:
        """The report of ``somato report``: one page with the map, classes, readings and results.

        Args:
            height: The height of the page in a notebook, in pixels.
        """
        with self._files() as folder:
            run_program("report", "results.json", "--data", "recording.mcap", "--output",
                        "report.html", folder=folder)
            return Page(Path(folder, "report.html").read_text(encoding="utf-8"), height)

    def figure(self, name, path, *, width=None, caption=False, selection=None) -> None:
        """Saves a figure or a table of the report, or the methods, as ``pysomato.figure`` does."""
        with self._files() as folder:
            figure(os.path.join(folder, "results.json"), name, path, width=width, caption=caption,
                   selection=selection, data=os.path.join(folder, "recording.mcap"))

    @contextmanager
    def _files(self):
        """A folder with the files of the study and its recording, while it is used."""
        with tempfile.TemporaryDirectory() as folder:
            self.save(folder)
            self._recording.write(os.path.join(folder, "recording.mcap"))
            yield folder

    def _protocols(self):
        return self.results["parts"][0]["protocols"]

    def _repr_svg_(self):
        return self._picture


def study(recording: Recording, system, *, threads=None, progress=None, **settings) -> Study:
    """Trains and tests a system on a recording, as ``somato run`` does.

    The same study, recording and seeds give the same results as the program. Ctrl-C stops it.

    Args:
        recording: The explorations.
        system: A ``System``, or its file or name.
        threads: Threads that compute; None: as many as the machine runs at once.
        progress: Whether tqdm shows the progress; None: on a terminal and in a notebook, if tqdm is
            installed.
        settings: Parameters of the table ``[study]``, such as ``seeds=20``, instead of those of the
            file.

    Raises:
        UsageError: The file or a parameter is wrong, or the recording lacks a channel or a label.
        DataError: The recording cannot be used for this study.
    """
    system = system if isinstance(system, System) else System(system)
    threads = number_of_threads(threads, "study")
    with shown(system.name, progress) as show:
        outcome = _somato.study(recording._inner, system._inner, settings, threads, show)
    return Study(outcome, recording)


def load(path) -> TrainedSystem:
    """The trained system in a file that ``somato run``, ``study`` or ``TrainedSystem.save`` wrote."""
    return TrainedSystem(_somato.load_system(os.fspath(path)))


def systems() -> list[str]:
    """The names of the systems and studies that the package contains."""
    return _somato.own_files()
