"""Results in one JSON file for each cell of the study, computed in parallel and not twice."""

import json
import os
import sys
import time
import traceback
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path
from typing import Any, Callable


@dataclass(frozen=True)
class Cell:
    """A result of one set and one method.

    `identity` contains all that the result depends on. A stored cell with another identity is
    computed again. `compute(*arguments)` returns a dictionary for JSON and runs in another process, so
    that it must be a function of a module.
    """
    path: Path
    identity: dict
    compute: Callable
    arguments: tuple[Any, ...] = ()

    def stored(self):
        """The stored result, or None if there is none, or one of another identity."""
        try:
            content = json.loads(self.path.read_text(encoding="utf-8"))
        except (FileNotFoundError, ValueError):
            return None
        return content if content.get("identity") == self.identity else None

    def store(self, result):
        """Replaces the file at once, so that an interruption leaves a whole file."""
        self.path.parent.mkdir(parents=True, exist_ok=True)
        part = self.path.with_suffix(f".{os.getpid()}.part")
        part.write_text(json.dumps({"identity": self.identity, **result}, indent=1) + "\n", encoding="utf-8")
        part.replace(self.path)


def name_of(cell):
    return f"{cell.path.parent.name} {cell.path.stem}"


def _compute_and_store(cell):
    """Returns the error, or nothing."""
    try:
        cell.store(cell.compute(*cell.arguments))
    except Exception:  # noqa: BLE001: another cell may succeed; the report contains the error
        return traceback.format_exc().strip()
    return None


def _outcomes(missing, jobs):
    """Yields each cell when it is computed, with its error."""
    if jobs == 1:
        for cell in missing:
            yield cell, _compute_and_store(cell)
        return
    with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:  # threads do not survive a fork
        running = {pool.submit(_compute_and_store, cell): cell for cell in missing}
        try:
            for future in as_completed(running):
                yield running[future], future.result()
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def run(cells, jobs, out=sys.stderr):
    """Computes the cells that are not stored, `jobs` at once, and reports each one.

    Returns:
        The errors of cells that failed, by their names; the others are stored nevertheless.
    """
    missing = [cell for cell in cells if cell.stored() is None]
    print(f"{len(cells) - len(missing)} of {len(cells)} cells are stored", file=out, flush=True)
    failed, begin = {}, time.monotonic()
    for done, (cell, error) in enumerate(_outcomes(missing, jobs), 1):
        if error:
            failed[name_of(cell)] = error
        seconds = time.monotonic() - begin
        left = seconds / done * (len(missing) - done)
        print(f"{done} of {len(missing)}: {name_of(cell)}{' failed' if error else ''}; {seconds:.0f} s, "
              f"about {left:.0f} s left", file=out, flush=True)
    return failed
