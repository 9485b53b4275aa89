"""Systems that are selected for a recording."""

import json

from . import _somato
from ._inputs.numbers import number_of_threads
from ._progress import shown
from .drawing import write_text
from .recording import Recording
from .studies import System


class Suggestion(System):
    """The system that ``suggest`` has selected.

    Attributes:
        scores: All codes and combinations that were compared, as ``somato suggest --json`` prints them
            (docs/mathematics/suggest.md).
    """

    def __init__(self, inner, toml, scores):
        self._inner = inner
        self._toml = toml
        self.scores = json.loads(scores)

    @property
    def toml(self) -> str:
        """The study as TOML, with the reasons as comments."""
        return self._toml

    def save(self, path) -> None:
        """Writes the study to a TOML file, which ``System`` and ``somato run`` read.

        Raises:
            UsageError: The name of the file has the extension of another format.
            OperatingSystemError: The file cannot be written.
        """
        write_text(path, self._toml, ".toml")


def suggest(recording: Recording, *, threads=None, progress=None, **settings) -> Suggestion:
    """Selects codes, weights and a combination of the channels of a recording, as ``somato suggest`` does.

    Labels do not affect the selection; ``label`` is that of the study. Ctrl-C stops it.

    Args:
        recording: At least two explorations.
        threads: Threads that compute; None: as many as the machine runs at once. Does not affect the result.
        progress: As for ``study``.
        settings: Parameters of ``somato suggest`` (docs/reference/flags-and-keys.md), such as
            ``label="material"``.

    Raises:
        UsageError: A parameter is wrong.
        DataError: There is one exploration only, or no channel distinguishes explorations.
    """
    threads = number_of_threads(threads, "suggest")
    with shown("comparing codes", progress) as show:
        return Suggestion(*_somato.suggest(recording._inner, settings, threads, show))
