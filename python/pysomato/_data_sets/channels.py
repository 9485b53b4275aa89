"""What the readers of data sets share: values as channels, and reasons to leave a part out."""

from importlib import import_module

import numpy as np

from .. import _somato
from .._inputs.readings import numbers_of, readings_of
from ..errors import DataError

# Differences within an exploration below this share of a channel's deviation are those of a hand at
# rest, and may be lost.
_FINEST = 1e-4

# The greatest number up to which float32 represents all integers.
_GREATEST_INTEGER = 2**24


def imported(name, extra):
    """The module of an optional dependency.

    Raises:
        ImportError: It is not installed; the message says how to install it.
    """
    try:
        return import_module(name)
    except ImportError as error:
        raise ImportError(f"reading this data set needs {name.split('.')[0]}: "
                          f"pip install 'pysomato[{extra}]'") from error


def channels_of(arrays, left_out, path, sources):
    """Arrays as arguments of Recording.from_arrays.

    Args:
        arrays: Maps names to arrays of (frames, ...), one per episode.
        left_out: Receives the reason why an array is no channel, by its name.
        path: The place in messages.
        sources: The origin of each episode.

    Raises:
        DataError: No array can be a channel, or a value is beyond single precision.
    """
    channels, valid = {}, {}
    for name, episodes in arrays.items():
        reason = next(filter(None, map(_reason_to_leave_out, episodes)), None)
        if reason is not None:
            left_out[name] = reason
            continue
        places = [f"{source}, {name}" for source in sources]
        marked = [_with_marks(values) for values in episodes]
        try:
            frames = rounded(marked, name, [], places)
        except PrecisionError as error:
            left_out[name] = error.what
            continue
        both = [(values, marks if (marks == 0).any() else None) for values, marks in frames]
        channels[name] = [values for values, _ in both]
        if any(marks is not None for _, marks in both):
            valid[name] = [marks for _, marks in both]
    if not channels:
        raise DataError("nothing in it can be a channel", path,
                        f"it contains: {', '.join(left_out) or 'no arrays'}")
    return {"channels": channels, "valid": valid, "sources": sources}


def are_pictures(array):
    """Whether an array of (frames, ...) contains pictures, by its type and its number of axes."""
    return array.dtype == np.uint8 and array.ndim >= 4


def _reason_to_leave_out(values):
    """Why an array of (frames, ...) cannot be a channel, or None."""
    if values.dtype.kind not in "buif":
        return "no numbers"
    if are_pictures(values):
        return "pictures"
    if values.size == 0:
        return "no elements"
    if values.dtype.kind in "ui" and (int(values.max()) > _GREATEST_INTEGER
                                      or int(values.min()) < -_GREATEST_INTEGER):
        return "integers beyond single precision"
    return None


def _with_marks(values):
    """Values, and whether each is known: not NaN."""
    return values, ~np.isnan(values) if values.dtype.kind == "f" else np.ones(values.shape, bool)


class PrecisionError(DataError):
    """float32 does not hold what differs in the frames of a channel."""


def rounded(marked, name, elements, places):
    """The frames of a channel as float32, with 0 where a value is not known, and the marks.

    Args:
        marked: The numbers of each exploration, (frames, ...), and whether each is known.
        name: The name of the channel.
        elements: The names of its elements, or none.
        places: The name of each exploration in messages.

    Raises:
        PrecisionError: See there.
        DataError: A known value is missing, infinite or beyond single precision.
    """
    def text(element):
        return f"element {elements[element]!r}" if element < len(elements) else f"element {element}"

    rows = [_rows(numbers_of(values, place), known, place)
            for (values, known), place in zip(marked, places)]
    whole = _somato.Rounding()
    frames = [_round(one, whole) for one in rows]
    _check(whole, text, name)
    finest = [_FINEST * deviation for deviation in whole.deviations()]
    for one, place in zip(rows, places):
        part = _somato.Rounding()
        part.know([], finest)
        _round(one, part)
        _check(part, text, place)
    done = []
    for (values, known), one, place in zip(marked, frames, places):
        _check_finite(one, known, place)
        whole_marks = np.broadcast_to(known, values.shape)
        done.append((np.nan_to_num(one, copy=False).reshape(values.shape), whole_marks))
    return done


def frames_of(frames, where):
    """Frames of any form as float32 of (frames, elements), without missing values."""
    values = readings_of(frames, where)
    (done, _), = rounded([(values, np.ones(values.shape, bool))], where, [], [where])
    return np.ascontiguousarray(flat(done))


def _rows(values, known, place):
    """(frames, elements), NaN where a value is not known."""
    if values.dtype.kind != "f":
        raise DataError("the values are not real numbers", place, "pass real numbers")
    rows = np.where(known, values, values.dtype.type(np.nan))
    return flat(rows)


def flat(values):
    """(frames, ...) as (frames, elements)."""
    return values.reshape(len(values), int(np.prod(values.shape[1:])))


def _round(rows, rounding):
    return rounding.rows(rows) if rows.dtype == np.float64 else rows.copy()


def _check(rounding, text, where):
    try:
        rounding.check(text, where)
    except DataError as error:
        raise PrecisionError(*error.args) from error


def _check_finite(rows, known, place):
    known = flat(known)
    for wrong, what, advice in ((np.isinf, "is infinite or beyond single precision",
                                 "correct the value, or remove the channel"),
                                (np.isnan, "is missing (NaN), which a recording marks",
                                 "pass valid, or numpy.ma.masked_invalid(frames)")):
        found = np.argwhere(wrong(rows) & known)
        if len(found):
            frame, element = (int(index) for index in found[0])
            raise DataError(f"the value of frame {frame}, element {element} {what}", place, advice)
