"""Recordings of touch: explorations with labels and channels."""

import os
import warnings

import numpy as np

from . import _somato
from ._data_sets import lerobot, open_x_tactile
from ._data_sets.channels import flat, rounded
from ._inputs.labels import has_none
from ._inputs.readings import columns_of, readings_of, refuse_unnamed
from ._inputs.tables import arrays_of_table
from .drawing import Drawing, skin
from .errors import DataError, LeftOutWarning, UsageError


class Recording:
    """Explorations of objects, each with labels and the frames of its channels. Immutable.

    ``recording["touch"]`` is a list of arrays, one per exploration: float32 of (frames, elements), or
    of (frames,) and the channel's shape. They are views of the recording's memory, which exists as
    long as one of them, and cannot be written to. Missing values are 0; see ``valid``.

    Attributes:
        left_out: What ``read`` did not read, such as pictures: maps the name to the reason.
    """

    def __init__(self, inner):
        self._inner = inner
        self.left_out = {}

    @classmethod
    def from_arrays(cls, labels, channels, *, units=None, rates=None, times=None, element_names=None,
                    valid=None, sources=None):
        """A recording from copies of arrays.

        Args:
            labels: Maps the name of a label to its values, one per exploration; or a DataFrame.
            channels: Maps the name of a channel to its arrays, one per exploration: numbers of
                (frames, elements), or (frames,) and further axes.
            units: Maps names of channels to units, such as "deg".
            rates: Maps names of channels to frames per second.
            times: Maps names of channels to arrays of seconds, one per exploration, one per frame.
            element_names: Maps names of channels to names of their elements.
            valid: Maps names of channels to arrays of the same shapes, one per exploration, with 0
                for a missing value, whose number is not used; or None for an exploration without
                missing values. Masked values of a masked array of numpy are missing, too.
            sources: The file or another origin of each exploration.

        Raises:
            UsageError: The numbers of explorations differ, or a name is not that of a channel.
            DataError: A value is not finite, float32 does not hold what differs in a channel, a label
                is missing, or channels, times or labels contradict each other.
        """
        columns = {str(name): _label_texts(str(name), labels[name]) for name in _names_of(labels)}
        given = {"units": units, "rates": rates, "times": times, "element_names": element_names,
                 "valid": valid}
        given = {name: value or {} for name, value in given.items()}
        _check_names(channels, given)
        explorations = _number_of_explorations(columns, channels)
        _check_lengths(explorations, {**given, "sources": {"": sources} if sources is not None else {}})
        frames = {name: _frames_of(name, arrays, given) for name, arrays in channels.items()}
        maker = _somato.RecordingMaker()
        for exploration in range(explorations):
            maker.begin([(name, values[exploration]) for name, values in columns.items()],
                        "" if sources is None else str(sources[exploration]))
            for name in channels:
                values, marks = frames[name][exploration]
                description = {"name": name, "unit": given["units"].get(name, ""),
                               "rate": float(given["rates"].get(name, 0.0)),
                               "element_names": list(given["element_names"].get(name, [])),
                               "shape": list(values.shape[1:]) if values.ndim > 2 else []}
                seconds = given["times"].get(name)
                place = f"from_arrays(times): channel '{name}', exploration {exploration}"
                maker.add(description, np.ascontiguousarray(flat(values)),
                          [] if seconds is None else _seconds_of(seconds[exploration], place),
                          marks)
        return cls(maker.finish())

    @classmethod
    def from_table(cls, table, label_column=None, *, labels=None, skip=(), missing="refuse"):
        """A recording whose explorations are the rows of a table, as the program reads one.

        Each exploration has one frame of the channel ``columns``, and the labels ``label_column`` (or
        ``label``) and ``row``, which counts from 1.

        Args:
            table: A DataFrame, or an array of (rows, columns).
            label_column: The column with the labels, by name.
            labels: The labels of the rows instead.
            skip: Names of columns to leave out.
            missing: Treatment of missing values: ``refuse``, or ``mask``, which marks them, so that
                ``suggest`` fills them with the means of their columns.

        Raises:
            UsageError: There is no such column, or labels are given twice.
            DataError: As for ``from_arrays``; a column of text is neither the labels nor left out.
        """
        return cls.from_arrays(**arrays_of_table(table, label_column, labels, skip, missing))

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

    def draw(self, channel, exploration=0, frames=-1, *, limits=None, layout=None) -> Drawing:
        """Frames of a channel at the places of its elements: those of a layout file, an unfolded
        hand if the names of the elements are those of fingers (``finger1_proximal_3``), otherwise a
        grid by their shape or by two indices of their names (``t00``).

        Args:
            channel: The name of the channel.
            exploration: The number of the exploration, from 0.
            frames: The number of a frame, or a list; negative ones count from the end.
            limits: The values with the first and the last colour; None: the least and the greatest
                measured value of the exploration.
            layout: The path of a layout file with a table for the channel.

        Raises:
            UsageError: There is no such channel, exploration or frame, the limits are wrong, or the
                layout does not fit the channel.
        """
        all_frames = self[channel]
        place = _place(exploration, len(all_frames), "exploration")
        values, valid = all_frames[place], self.valid(channel)[place]
        numbers = [_place(frame, len(values), "frame") for frame in np.atleast_1d(frames).tolist()]
        if not numbers:
            raise UsageError("a picture needs a frame", "Recording.draw", "name at least one")
        if limits is None:
            measured = values if valid is None else values[valid != 0]
            limits = (measured.min(), measured.max()) if measured.size else (0.0, 0.0)
        times = self.times(channel)[place]
        shown = [(_frame_title(number, times), values[number],
                  None if valid is None else valid[number]) for number in numbers]
        labels = ", ".join(f"{name} {value}" for name, value in self._inner.labels()[place].items())
        description = next(one for one in self.channels if one["name"] == channel)
        return skin(f"{channel}: {labels}" if labels else channel, description, shown, limits,
                    "Recording.draw(limits)", layout)

    def write(self, path) -> None:
        """Writes an MCAP file (docs/formats/recording.md); an earlier one is replaced when all is
        written."""
        self._inner.write(os.fspath(path))

    def __repr__(self):
        names = ", ".join(channel["name"] for channel in self.channels)
        return f"<Recording of {len(self)} explorations: {names}>"


def read(path, format="automatic", **table) -> Recording:  # noqa: A002: as in the program
    """The recording in an MCAP file, in a folder of a data set that ``somato import`` knows, in a
    LeRobotDataset or in a zarr archive of the Open-X-Tactile layout; or the rows of a table of numbers
    (CSV, NPY, NPZ, MAT), as ``Recording.from_table`` has them.

    Args:
        path: File or folder.
        format: The format of a folder, as in ``somato import``, or ``lerobot`` or
            ``open_x_tactile``; automatic: recognized by the names of its files.
        table: How a table is read, by the keys of ``[recording]`` (docs/reference/flags-and-keys.md), such
            as ``label_column="object", skip=["date"], missing="mask"``.

    Warns:
        LeftOutWarning: A part cannot be a channel, such as pictures; ``Recording.left_out`` names it.

    Raises:
        DataError: The content is damaged, or not a recording.
        ImportError: The package that reads the format is not installed; the message names it.
        OperatingSystemError: The file cannot be read.
        UsageError: The format or a key is unknown, or a key of tables is given for other data.
    """
    path = os.fspath(path)
    for name, reader in (("lerobot", lerobot), ("open_x_tactile", open_x_tactile)):
        if format == name or (format == "automatic" and reader.recognizes(path)):
            arrays, left_out = reader.read(path)
            return _with_left_out(Recording.from_arrays(**arrays), left_out, path)
    return Recording(_somato.read(path, {"format": format, **table}))


def _with_left_out(recording, left_out, path):
    recording.left_out = left_out
    if left_out:
        reasons = ", ".join(f"{name} ({reason})" for name, reason in left_out.items())
        warnings.warn(f"{path}: left out: {reasons}", LeftOutWarning, stacklevel=3)
    return recording


def _frames_of(name, arrays, given):
    """The frames of a channel and the marks of its values, for each exploration."""
    places = [f"from_arrays: channel '{name}', exploration {i}" for i in range(len(arrays))]
    marks = given["valid"].get(name)
    masked = [_masked(frames, None if marks is None else marks[i], places[i])
              for i, frames in enumerate(arrays)]
    frames = rounded([(values, known) for values, known, _ in masked], name,
                     list(given["element_names"].get(name, [])), places)
    return [(values, np.ascontiguousarray(flat(known), np.uint8) if is_marked
             else np.ones((0, 0), np.uint8))
            for (values, known), (_, _, is_marked) in zip(frames, masked)]


def _masked(frames, marks, place):
    """Numbers of (frames, ...), which of them are known, and whether that is given."""
    values = readings_of(frames, place)
    mask = np.ma.getmaskarray(frames) if isinstance(frames, np.ma.MaskedArray) else None
    values = values.toarray() if hasattr(values, "toarray") else values
    if values.ndim == 0:
        raise DataError("a number is not frames", place, "pass an array of (frames, elements)")
    known = np.ones(values.shape, bool) if mask is None else ~mask
    if marks is not None:
        given = np.asarray(marks)
        if given.size != values.size or len(given) != len(values):
            raise DataError(f"there are {given.size} validity marks for {values.size} values", place,
                            "pass one for each value")
        known = known & (given.reshape(values.shape) != 0)
    return values, known, marks is not None or mask is not None


def _names_of(labels):
    refuse_unnamed(columns_of(labels) or list(labels), "from_arrays(labels)")
    return labels


def _label_texts(name, values):
    """The values of a label as texts."""
    values = list(values)
    for exploration, value in enumerate(values):
        if has_none(value):
            raise DataError(f"the label '{name}' of exploration {exploration} is missing",
                            "from_arrays(labels)", "leave the exploration out, or give it a label "
                            "such as 'none'")
    return [str(value) for value in values]


def _place(number, count, kind):
    """The number of one of ``count`` things, counted from the end if it is negative."""
    if isinstance(number, (int, np.integer)) and -count <= number < count:
        return int(number) % count
    raise UsageError(f"there is no {kind} {number!r}", f"Recording.draw({kind})",
                     f"there are {count}, counted from 0")


def _frame_title(number, times):
    return f"frame {number}" if times is None else f"frame {number}, {times[number]:.3g} s"


def _number_of_explorations(columns, channels):
    numbers = {len(values) for values in [*columns.values(), *channels.values()]}
    if len(numbers) != 1 or not channels:
        raise UsageError("labels and channels need one value for each exploration",
                         "Recording.from_arrays",
                         "give lists of the same length, and at least one channel")
    return numbers.pop()


def _check_lengths(explorations, given):
    for argument in ("times", "valid", "sources"):
        for values in given[argument].values():
            if len(values) != explorations:
                raise UsageError(f"there are {len(values)} for {explorations} explorations",
                                 f"from_arrays({argument})", "give one for each exploration")


def _seconds_of(times, place):
    return np.asarray(readings_of(times, place), np.float64).ravel().tolist()


def _check_names(channels, given):
    for argument, values in given.items():
        for name in values:
            if name not in channels:
                raise UsageError(f"there is no channel '{name}'", f"from_arrays({argument})",
                                 f"channels are: {', '.join(channels)}")
