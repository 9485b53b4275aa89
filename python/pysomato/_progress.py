"""Shows the progress of long work with tqdm."""

import contextlib
import sys
import warnings

from .errors import UsageError


@contextlib.contextmanager
def shown(what, progress):
    """A function of (done, total) that shows the progress of ``what``, or None.

    Args:
        what: A few words before the bar.
        progress: Whether it is shown; None: if tqdm is installed, and the process has a terminal or
            is a notebook's.

    Raises:
        UsageError: It is wanted, but tqdm is not installed.
    """
    bars = _bars(required=bool(progress)) if progress or (progress is None and _is_seen()) else None
    if bars is None:
        yield None
        return
    with bars(desc=what, total=None, leave=False) as bar:

        def show(done, total):
            bar.total, bar.n = total, done
            bar.refresh()

        yield show


def _bars(required):
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # a notebook without widgets shows a line of text
            from tqdm.auto import tqdm
    except ImportError:
        if required:
            raise UsageError("progress is shown by tqdm, which is not installed", "progress",
                             "install it, or omit progress=True") from None
        return None
    return tqdm


def _is_seen():
    return sys.stderr.isatty() or "ipykernel" in sys.modules
