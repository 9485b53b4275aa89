"""Numbers that arguments give."""

import numpy as np

from . import _somato
from .errors import UsageError


def number_of_threads(threads, where) -> int:
    """The threads that an argument ``threads`` of ``where`` gives; None: all that the machine runs."""
    if threads is None:
        return _somato.available_threads()
    return at_least_one(threads, f"{where}(threads)")


def at_least_one(number, where) -> int:
    """A whole number above 0.

    Raises:
        UsageError: It is not one; the message names ``where``.
    """
    if not isinstance(number, (int, np.integer)) or number < 1:
        raise UsageError(f"{number!r} is not a whole number above 0", where, "use at least 1")
    return int(number)
