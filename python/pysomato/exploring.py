"""Explorations with simulated bodies."""

import os
import warnings

from . import _somato
from ._inputs.numbers import at_least_one, number_of_threads
from ._progress import shown
from .recording import Recording


def explore(body, *, objects=None, explorations=5, seed=1, settings=None, longest=600, threads=None,
            progress=None, **simulation) -> Recording:
    """Explores objects or materials with a simulated body, as ``somato explore`` does.

    The same arguments give the same recording as the program, bit by bit. Ctrl-C stops it. A warning
    names explorations that failed; the recording does not contain them.

    Args:
        body: ``lucs2``, ``lucs3``, ``texture``, ``hardness``, ``probes`` or ``all_senses``.
        objects: A TOML file (docs/objects.md), or the name of one that ``object_tables`` lists; None:
            the body's own objects or materials.
        explorations: Number of explorations of each object or material.
        seed: Seed of placement and noise.
        settings: A TOML file with tables of parameters, such as ``[simulation]`` and ``[grasp]``.
        longest: Maximum duration of an exploration, in seconds of the body's time.
        threads: Threads that explore; None: as many as the machine runs at once. Does not affect the
            recording.
        progress: Whether tqdm shows the progress; None: on a terminal and in a notebook, if tqdm is
            installed.
        simulation: Parameters of the table ``[simulation]`` (docs/reference/flags-and-keys.md), such
            as ``placement_noise=0.0``.

    Raises:
        UsageError: An argument is wrong, or an object does not fit the hand.
        DataError: Every exploration failed.
    """
    objects, settings = (None if path is None else os.fspath(path) for path in (objects, settings))
    explorer = _somato.Explorer.build(body, objects, settings, simulation, seed)
    explorations = at_least_one(explorations, "explore(explorations)")
    longest = at_least_one(longest, "explore(longest)")
    threads = number_of_threads(threads, "explore")
    with shown("exploring", progress) as show:
        recording, failures = explorer.explore(explorations, longest, threads, show)
    for failure in failures:
        warnings.warn(f"an exploration failed: {failure}", stacklevel=2)
    return Recording(recording)


def object_tables() -> list[str]:
    """The names of the tables of objects that the package contains."""
    return _somato.own_object_tables()
