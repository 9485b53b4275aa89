"""Self-organizing maps for haptic perception, and for any other data (docs/python.md)."""

from importlib import import_module
from typing import TYPE_CHECKING

from ._somato import __version__

if TYPE_CHECKING:
    from ._maps.drawing import MapDrawing
    from ._maps.files import MapFiles
    from ._maps.labels import MapLabels
    from .analysis import *
    from .codes import *
    from .drawing import *
    from .errors import *
    from .exploring import *
    from .figures import *
    from .recording import *
    from .som import *
    from .som_classifier import *
    from .som_clusterer import *
    from .studies import *
    from .suggestions import *
    from .sweeps import *
    from .t_mpsom import *

_NAMES_OF = {
    "_maps.drawing": ["MapDrawing"],
    "_maps.files": ["MapFiles"],
    "_maps.labels": ["MapLabels"],
    "analysis": ["MapAnalysis", "MapClusters", "MapMeasures"],
    "codes": ["OneHot", "Spectrum", "TensorProduct"],
    "drawing": ["Drawing", "Page"],
    "errors": ["ConversionWarning", "DataError", "DataTypeError", "Error", "LabelWarning", "LeftOutWarning",
               "MissingChannelError", "NotFittedError", "OperatingSystemError", "PrecisionWarning",
               "SettingsWarning", "UsageError"],
    "exploring": ["explore", "object_tables", "sense"],
    "figures": ["figure"],
    "recording": ["Recording", "read"],
    "som": ["SOM"],
    "som_classifier": ["SOMClassifier"],
    "som_clusterer": ["SOMClusterer"],
    "studies": ["Live", "Study", "System", "TrainedSystem", "load", "study", "systems"],
    "suggestions": ["Suggestion", "suggest"],
    "sweeps": ["Sweep", "sweep"],
    "t_mpsom": ["TMPSOM"],
}
_MODULE_OF = {name: module for module, names in _NAMES_OF.items() for name in names}

__all__ = ["__version__", *_MODULE_OF]


def __getattr__(name):
    """Imports a module when its first name is used, because importing scikit-learn takes seconds."""
    if name in _NAMES_OF:
        return import_module(f".{name}", __name__)
    if name not in _MODULE_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f".{_MODULE_OF[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__():
    return __all__
