"""Numbers and choices that arguments give."""

import difflib

import numpy as np
from sklearn.utils import check_random_state

from .. import _somato
from ..errors import UsageError

# The default of random_state, with which the program trains as well.
_DEFAULT_SEED = 1

# No machine has more threads, and no recording more explorations.
_LARGEST_NUMBER = 2**31 - 1

# Above this, a seed is refused by the library.
_LARGEST_SEED = 10**15

# Seeds are drawn below this, as in scikit-learn.
_DRAWN_SEEDS = 2**31 - 1


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
    if number > _LARGEST_NUMBER:
        raise UsageError(f"{number} is too large", where, f"use at most {_LARGEST_NUMBER}")
    return int(number)


def one_of(value, choices, where) -> str:
    """A text that is one of the choices of the argument ``where``.

    Raises:
        UsageError: It is not.
    """
    if not isinstance(value, str) or value not in choices:
        near = difflib.get_close_matches(str(value), choices, n=1)
        raise UsageError(f"{value!r} is not one of {', '.join(choices)}", where,
                         f"did you mean '{near[0]}'?" if near else "")
    return value


def number(value, where) -> float:
    """A number.

    Raises:
        UsageError: It is none; the message names ``where``.
    """
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise UsageError(f"{value!r} is not a number", where, "use a number") from error


def seed_of(random_state, seed, where) -> int:
    """The seed that the arguments ``random_state`` and ``seed`` of ``where`` give, which are the same
    but for the name; a source of random numbers gives another seed each time.

    Raises:
        UsageError: Both are given, or one gives no seed.
    """
    name, given = ("random_state", random_state) if seed is None else ("seed", seed)
    if seed is not None and random_state != _DEFAULT_SEED:
        raise UsageError("'seed' and 'random_state' are the same", where, "pass one of them")
    if isinstance(given, np.random.Generator):
        return int(given.integers(_DRAWN_SEEDS))
    if given is None or given is np.random or isinstance(given, np.random.RandomState):
        return int(check_random_state(given).randint(_DRAWN_SEEDS))
    if isinstance(given, (int, np.integer)) and not isinstance(given, bool) and 0 <= given <= _LARGEST_SEED:
        return int(given)
    raise UsageError(f"{given!r} gives no seed", f"{where}({name})", "use a whole number from 0 to 10^15, "
                     "None, or a RandomState or Generator of numpy")
