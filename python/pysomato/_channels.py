"""What the readers of data sets share: values as channels, and reasons to leave a part out."""

from importlib import import_module

import numpy as np

from .errors import DataError

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
        both = [_frames_and_marks(values, f"{source}, {name}")
                for values, source in zip(episodes, sources)]
        channels[name] = [frames for frames, _ in both]
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


def _frames_and_marks(values, where):
    """Values as float32, and marks of missing values: False where a value is NaN; None if none is."""
    with np.errstate(over="ignore"):
        frames = np.asarray(values, dtype=np.float32)
    if np.isinf(frames).any():
        place = [int(index) for index in np.argwhere(np.isinf(frames))[0]]
        raise DataError(f"the value {values[tuple(place)]} at {place} is beyond single precision",
                        where, "correct the value, or remove the channel")
    missing = np.isnan(frames)
    return frames, ~missing if missing.any() else None
