"""Self-organizing maps for haptic perception, and for any other data (docs/python.md)."""

from .codes import OneHot, Spectrum, TensorProduct
from .drawing import Drawing, Page
from .errors import (ConversionWarning, DataError, Error, LeftOutWarning, OperatingSystemError,
                     UsageError)
from .exploring import explore, object_tables
from .recording import Recording, read
from .som import SOM
from .studies import Live, Study, System, TrainedSystem, load, study, systems
from .sweeps import Sweep, sweep
from .t_mpsom import TMPSOM

__all__ = ["SOM", "TMPSOM", "ConversionWarning", "DataError", "Drawing", "Error", "LeftOutWarning",
           "Live", "OneHot", "OperatingSystemError", "Page", "Recording", "Spectrum", "Study", "Sweep",
           "System", "TensorProduct", "TrainedSystem", "UsageError", "explore", "load",
           "object_tables", "read", "study", "sweep", "systems"]
