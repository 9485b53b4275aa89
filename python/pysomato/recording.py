"""Recordings of touch: explorations with labels and channels."""

import os

import numpy as np

from . import _somato
from .errors import UsageError


class Recording:
    """Explorations of objects, each with labels and the frames of its channels. Immutable.

    ``recording["touch"]`` is a list of arrays, one per exploration: float32 of (frames, elements), or
    of (frames,) and the channel's shape. They are views of the recording's memory, which exists as
    long as one of them, and cannot be written to. Missing values are 0; see ``valid``.
    """

    def __init__(self, inner):
        self._inner = inner

    @classmethod
    def from_arrays(cls, labels, channels, *, units=None, rates=None, times=None, element_names=None):
        """A recording from copies of arrays.

        Args:
            labels: Maps the name of a label to its values, one per exploration; or a DataFrame.
            channels: Maps the name of a channel to its arrays, one per exploration: numbers of
                (frames, elements), or (frames,) and further axes.
            units: Maps names of channels to units, such as "deg".
            rates: Maps names of channels to frames per second.
            times: Maps names of channels to arrays of seconds, one per exploration, one per frame.
            element_names: Maps names of channels to names of their elements.

        Raises:
            UsageError: The numbers of explorations differ, or a name is not that of a channel.
            DataError: A value is not finite, or channels, times or labels contradict each other.
        """
        columns = {str(name): [str(value) for value in labels[name]] for name in labels}
        given = {"units": units, "rates": rates, "times": times, "element_names": element_names}
        given = {name: value or {} for name, value in given.items()}
        _check_names(channels, given)
        maker = _somato.RecordingMaker()
        for exploration in range(_number_of_explorations(columns, channels)):
            maker.begin([(name, values[exploration]) for name, values in columns.items()])
            for name, arrays in channels.items():
                frames = np.asarray(arrays[exploration], dtype=np.float32)
                description = {"name": name, "unit": given["units"].get(name, ""),
                               "rate": float(given["rates"].get(name, 0.0)),
                               "element_names": list(given["element_names"].get(name, [])),
                               "shape": list(frames.shape[1:]) if frames.ndim > 2 else []}
                seconds = given["times"].get(name)
                maker.add(description, np.ascontiguousarray(frames.reshape(len(frames), -1)),
                          [] if seconds is None else [float(time) for time in seconds[exploration]])
        return cls(maker.finish())

    def __len__(self):
        """The number of explorations."""
        return len(self._inner)

    def __eq__(self, other):
        return isinstance(other, Recording) and self._inner == other._inner

    __hash__ = None

    def __getitem__(self, channel) -> list[np.ndarray]:
        """The frames of a channel in each exploration.

        Raises:
            UsageError: There is no such channel; the message names the nearest one.
        """
        return _somato.frames(self._inner, channel)

    @property
    def channels(self) -> list[dict]:
        """Name, unit, element names and shape of a frame of each channel."""
        return self._inner.channels()

    @property
    def labels(self):
        """The labels as a DataFrame of pandas: a row for each exploration, all values texts."""
        import pandas  # only here, because the package works without it

        return pandas.DataFrame(self._inner.labels())

    def label(self, name) -> np.ndarray:
        """The value of a label for each exploration.

        Raises:
            UsageError: There is no such label.
        """
        rows = self._inner.labels()
        if name not in rows[0]:
            raise UsageError(f"there is no label '{name}'", "Recording.label",
                             f"labels are: {', '.join(rows[0])}")
        return np.array([row[name] for row in rows])

    @property
    def sources(self) -> list[str]:
        """The file or another origin of each exploration."""
        return self._inner.sources()

    def times(self, channel) -> list:
        """Seconds of the frames in each exploration: float64 of (frames,), or None if unknown."""
        return _somato.times(self._inner, channel)

    def rates(self, channel) -> list[float]:
        """Frames per second in each exploration; 0 if unknown."""
        return self._inner.rates(channel)

    def valid(self, channel) -> list:
        """Which values were measured: uint8 like the frames, or None if all were."""
        return _somato.valid(self._inner, channel)

    def write(self, path) -> None:
        """Writes an MCAP file (docs/formats/recording.md); an earlier one is replaced when all is
        written."""
        self._inner.write(os.fspath(path))

    def __repr__(self):
        names = ", ".join(channel["name"] for channel in self.channels)
        return f"<Recording of {len(self)} explorations: {names}>"


def read(path, format="automatic") -> Recording:  # noqa: A002: as in the program
    """The recording in an MCAP file, or in a folder of a data set that ``somato import`` knows.

    Args:
        path: File or folder.
        format: The format of a folder; automatic: recognized by the names of its files.

    Raises:
        DataError: The content is damaged, or not a recording.
        OperatingSystemError: The file cannot be read.
        UsageError: The format is unknown.
    """
    return Recording(_somato.read(os.fspath(path), format))


def _number_of_explorations(columns, channels):
    numbers = {len(values) for values in [*columns.values(), *channels.values()]}
    if len(numbers) != 1 or not channels:
        raise UsageError("labels and channels need one value for each exploration",
                         "Recording.from_arrays",
                         "give lists of the same length, and at least one channel")
    return numbers.pop()


def _check_names(channels, given):
    for argument, values in given.items():
        for name in values:
            if name not in channels:
                raise UsageError(f"there is no channel '{name}'", f"from_arrays({argument})",
                                 f"channels are: {', '.join(channels)}")
