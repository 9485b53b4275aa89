"""Self-organizing maps for haptic perception, and for any other data (docs/python.md)."""

from ._somato import __version__
from .codes import OneHot, Spectrum, TensorProduct
from .drawing import Drawing, Page
from .errors import (ConversionWarning, DataError, DataTypeError, Error, LabelWarning,
                     LeftOutWarning, MissingChannelError, NotFittedError, OperatingSystemError, UsageError)
from .exploring import explore, object_tables
from .recording import Recording, read
from .som import SOM
from .studies import Live, Study, System, TrainedSystem, load, study, systems
from .sweeps import Sweep, sweep
from .t_mpsom import TMPSOM

__all__ = ["SOM", "TMPSOM", "ConversionWarning", "DataError", "DataTypeError", "Drawing", "Error",
           "LabelWarning", "LeftOutWarning", "Live", "MissingChannelError", "NotFittedError", "OneHot",
           "OperatingSystemError", "Page", "Recording", "Spectrum", "Study", "Sweep", "System",
           "TensorProduct", "TrainedSystem", "UsageError", "__version__", "explore", "load",
           "object_tables", "read", "study", "sweep", "systems"]
