"""Sweeps of the settings that papers leave unspecified."""

import contextlib
import json
import os
import tempfile
from pathlib import Path

from ._frames import frame
from ._inputs.numbers import number_of_threads
from ._program import run_program
from .recording import Recording


class Sweep:
    """The results of a sweep: a notebook shows the shares of the pairs in which each claim holds.

    Attributes:
        results: The content of sweep.json (docs/reference/sweeps.md).
    """

    def __init__(self, folder):
        self.results = json.loads((folder / "sweep.json").read_text(encoding="utf-8"))
        self._picture = (folder / "sweep.svg").read_text(encoding="utf-8")

    @property
    def claims(self):
        """Every claim as a DataFrame: claim, points at which it can be judged, share of these at which
        it holds, mean share of the pairs."""
        return frame(["claim", "points", "holds", "mean_share"], [
            (name, claim["points"], claim["holds"], claim["mean_share"])
            for name, claim in self._claims()])

    @property
    def effects(self):
        """The effect of every unknown on every claim as a DataFrame: claim, unknown, change,
        first_order and first_order_by_chance (docs/reference/sweeps.md)."""
        return frame(["claim", "unknown", "change", "first_order", "first_order_by_chance"], [
            (name, unknown["name"], unknown["change"], unknown["first_order"],
             unknown["first_order_by_chance"])
            for name, claim in self._claims() for unknown in claim["unknowns"]])

    @property
    def points(self):
        """Every point as a DataFrame: a column for each unknown, and for each claim the share of the
        pairs in which it holds; missing values are those of the system, and claims that cannot be
        judged."""
        unknowns = [unknown["name"] for unknown in self.results["unknowns"]]
        claims = [name for name, _ in self._claims()]
        return frame([*unknowns, *claims], [
            [*(point["values"][name] for name in unknowns),
             *(claim and claim["share"] for claim in point["claims"])]
            for point in self.results["points"]])

    def _claims(self):
        """Name and content of each claim."""
        for claim in self.results["claims"]:
            variation = claim.get("variation", "")
            yield f"{variation}: {claim['text']}" if variation else claim["text"], claim

    def _repr_svg_(self):
        return self._picture


def sweep(system, over, out, *, data=None, test_data=None, threads=None) -> Sweep:
    """Runs a system over a design of its unknown settings with the program ``somato sweep``.

    Ctrl-C stops it; the same call resumes it.

    Args:
        system: A TOML file with claims, or a name that ``systems`` lists.
        over: The TOML file of the unknowns and the design (docs/reference/sweeps.md).
        out: The folder of sweep.json, sweep.svg and the results of single points.
        data: A recording, or the path of recordings or data sets; None: the explorations that the
            system's table ``[explore]`` describes.
        test_data: A separate test recording, or its path.
        threads: Threads that compute; None: as many as the machine runs at once.

    Raises:
        UsageError: A file is wrong, or an unknown has no effect.
        Error: A recording cannot be used, or a file cannot be read or written.
    """
    flags = ["--over", os.fspath(over), "--out", os.fspath(out), "--part", "1/1",
             "--threads", number_of_threads(threads, "sweep")]
    with _as_file(data) as data_path, _as_file(test_data) as test_path:
        for flag, path in (("--data", data_path), ("--test-data", test_path)):
            flags += [] if path is None else [flag, path]
        run_program("sweep", os.fspath(system), *flags)
    return Sweep(Path(out))


@contextlib.contextmanager
def _as_file(recording):
    """The path of a recording, which is written to a temporary file unless it is a path."""
    if not isinstance(recording, Recording):
        yield recording
        return
    with tempfile.TemporaryDirectory() as folder:
        # Equal recordings of equal names have equal results, which are not computed again.
        path = Path(folder) / "recording.mcap"
        recording.write(path)
        yield path
