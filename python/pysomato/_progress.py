"""Shows the progress of long work: a bar of tqdm, or lines without it."""

import contextlib
import sys
import time
import warnings


@contextlib.contextmanager
def shown(what, progress):
    """A function of (done, total) that shows the progress of ``what``, or None.

    Args:
        what: A few words before the bar.
        progress: Whether it is shown; None: if tqdm is installed, and the process has a terminal or
            is a notebook's.
    """
    wanted = progress or (progress is None and _is_seen())
    bars = _bars() if wanted else None
    if bars is None:
        yield _lines(what) if progress else None
        return
    with bars(desc=what, total=None, leave=False) as bar:

        def show(done, total):
            bar.total, bar.n = total, done
            bar.refresh()

        yield show


def _bars():
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # a notebook without widgets shows a line of text
            from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm


def _lines(what):
    """A function that writes a line for each further tenth of the work, with the time that is left."""
    began = time.monotonic()
    written = 0

    def show(done, total):
        nonlocal written
        tenth = 10 * done // total if total else 0
        if tenth <= written:
            return
        written = tenth
        left = (time.monotonic() - began) * (total - done) / done
        print(f"{what}: {100 * done // total} %, about {left:.0f} s left", file=sys.stderr, flush=True)

    return show


def _is_seen():
    return sys.stderr.isatty() or "ipykernel" in sys.modules
