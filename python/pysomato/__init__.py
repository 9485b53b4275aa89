"""Self-organizing maps for haptic perception, and for any other data (docs/python.md)."""

from .errors import DataError, Error, IncompleteError, OperatingSystemError, UsageError
from .recording import Recording, read
from .som import SOM
from .studies import Live, Study, TrainedSystem, load, study, systems

__all__ = ["SOM", "DataError", "Error", "IncompleteError", "Live", "OperatingSystemError", "Recording",
           "Study", "TrainedSystem", "UsageError", "load", "read", "study", "systems"]
