"""Self-organizing maps for haptic perception, and for any other data (docs/python.md)."""

from .codes import OneHot, Spectrum, TensorProduct
from .drawing import Drawing
from .errors import (ConversionWarning, DataError, Error, LeftOutWarning, OperatingSystemError,
                     UsageError)
from .recording import Recording, read
from .som import SOM
from .studies import Live, Study, TrainedSystem, load, study, systems
from .t_mpsom import TMPSOM

__all__ = ["SOM", "TMPSOM", "ConversionWarning", "DataError", "Drawing", "Error", "LeftOutWarning",
           "Live", "OneHot", "OperatingSystemError", "Recording", "Spectrum", "Study", "TensorProduct",
           "TrainedSystem", "UsageError", "load", "read", "study", "systems"]
