"""Explorations with simulated bodies."""

import os
import warnings

from . import _somato
from ._inputs.numbers import at_least_one, number_of_threads
from ._progress import shown
from .errors import SettingsWarning, UsageError
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


def sense(recording, *, settings=None, seed=None, objects=(), explorations=None, threads=None,
          **sensors) -> Recording:
    """Plays the sensors of a simulated body, as ``somato sense`` does: the explorations of a recording with the
    readings of other sensors.

    The recording has true values if ``explore`` made it with ``true_values=True``. The parameters and
    the seed of the exploration give its readings, bit by bit. What the body did remains as it was.

    Args:
        recording: A recording with true values, which ``explore`` or ``read`` gave.
        settings: A TOML file with tables of parameters, as for ``explore``; those of the sensors count,
            except ``true_values``, which is an argument. None: the default sensors.
        seed: Seed of the noise and of the differences between sensors; None: that of the recording.
        objects: Names of objects, or of materials in a recording without objects, whose explorations
            are taken in this order; empty: all.
        explorations: Number of explorations of each, the first ones; None: all.
        threads: Threads that play; None: as many as the machine runs at once. Does not affect the
            result.
        sensors: Parameters of the sensors, such as ``sensor_noise=0.0`` or ``potentiometer_bits=8``.

    Raises:
        UsageError: The recording has no true values, there is no such object, or an argument is wrong.
        DataError: Another program has changed the true values.

    Warns:
        SettingsWarning: Settings are not given, and the recording was made with other sensors than the
            default ones: parameters that are not given are those of the default sensors.
    """
    if isinstance(objects, str):
        raise UsageError("sense(objects): a list of names is required, not a text")
    if explorations is not None:
        explorations = at_least_one(explorations, "sense(explorations)")
    threads = number_of_threads(threads, "sense")
    chosen = _somato.selected(recording._inner, list(objects), explorations)
    settings = None if settings is None else os.fspath(settings)
    played, note = _somato.sensed(chosen, settings, sensors, seed, threads)
    if note:
        warnings.warn(f"sense(settings): {note}", SettingsWarning, stacklevel=2)
    return Recording(played)


def object_tables() -> list[str]:
    """The names of the tables of objects that the package contains."""
    return _somato.own_object_tables()
