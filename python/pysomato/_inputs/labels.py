"""Labels in any form that users bring them, as the C++ library counts them."""

import warnings
from dataclasses import dataclass

import numpy as np
from sklearn.utils import check_consistent_length, column_or_1d

from .readings import is_missing
from ..errors import DataError, DataTypeError, LabelWarning, errors_of_sklearn

# What Python and its packages write for a missing value, in lower case.
_TEXTS_OF_MISSING = {"", "nan", "<na>", "nat"}

# What other programs write for one, but what may also be a name.
_DOUBTFUL_TEXTS = {"na", "n/a", "none", "null", "?"}


@dataclass(frozen=True)
class Labels:
    """The labels of samples.

    Attributes:
        names: The distinct labels in the order of first appearance, an array.
        numbers: The place of each sample's label in ``names``, or -1 if it has none; int64.
    """

    names: np.ndarray
    numbers: np.ndarray

    @property
    def known(self):
        """Which samples have a label."""
        return self.numbers >= 0


def labels_of(y, samples, unlabelled, where):
    """The labels in y.

    Args:
        y: A label for each sample; None, NA, NaN, NaT, masked elements, empty texts and the texts
            that Python writes for these mean that a sample has none.
        samples: The number of samples.
        unlabelled: A further value with this meaning, or None.
        where: The place in messages.

    Raises:
        DataError: The numbers of labels and samples differ, or two labels are written alike.
        DataTypeError: A label cannot be compared with others.
    """
    values, missing = _flat(y, where)
    with errors_of_sklearn(where, "pass one label for each sample"):
        check_consistent_length(np.empty(samples), values)
    if unlabelled is not None:
        missing = missing | np.fromiter((_are_equal(value, unlabelled) for value in values), bool,
                                        len(values))
    known = _tidy(values[~missing])
    names, numbers = _numbered(known, where)
    all_numbers = np.full(len(values), -1, np.int64)
    all_numbers[~missing] = numbers
    return Labels(names, all_numbers)


def warn_of_doubtful(names, stacklevel):
    """Warns of labels that are learned, but may mean that a label is missing."""
    texts = [str(name) for name in names if str(name).lower() in _DOUBTFUL_TEXTS]
    if texts:
        warnings.warn(f"y: the label '{texts[0]}' names neurons like any other; pass None for samples "
                      f"without a label, or SOM(unlabelled='{texts[0]}')", LabelWarning,
                      stacklevel=stacklevel)
    numbers = [name for name in names if isinstance(name, (int, np.integer, float, np.floating))]
    # The two labels -1 and 1 are a common pair of classes.
    if -1 in numbers and {int(number) for number in numbers} != {-1, 1} and len(numbers) > 1:
        warnings.warn("y: the label -1 names neurons like any other; pass SOM(unlabelled=-1) if it "
                      "marks samples without a label, as in sklearn.semi_supervised", LabelWarning,
                      stacklevel=stacklevel)


def places_of(names, known):
    """The place of each of ``names`` in ``known``, or -1: of an equal label, or of one that is
    written alike, because model files keep labels as texts."""
    places = {str(name): place for place, name in enumerate(known)}
    places.update({_key(name): place for place, name in enumerate(known)})
    return np.array([places.get(_key(name), places.get(str(name), -1)) for name in names], np.int64)


def _flat(y, where):
    """The labels as an array of one axis, and which are missing."""
    with errors_of_sklearn(where, "pass one label for each sample, in an array of one axis"):
        y = _of_list(y) if isinstance(y, (list, tuple)) else y
        mask = np.ma.getmaskarray(y).ravel() if isinstance(y, np.ma.MaskedArray) else None
        values = column_or_1d(np.ma.getdata(y) if mask is not None else np.asarray(y), warn=True)
    if values.dtype.kind == "f":
        missing = np.isnan(values)
    elif values.dtype.kind in "mM":
        missing = np.isnat(values)
    elif values.dtype.kind in "biu":
        missing = np.zeros(len(values), bool)
    else:
        missing = np.fromiter((has_none(value) for value in values.tolist()), bool, len(values))
    return values, missing if mask is None else missing | mask


def _of_list(y):
    """A list as an array in which its elements keep their types."""
    kinds = {type(value) for value in y}
    if len(kinds) <= 1:
        return np.asarray(y)
    values = np.empty(len(y), object)
    for place, value in enumerate(y):
        values[place] = value
    return values


def has_none(value):
    """Whether a value of a label means that there is none."""
    return is_missing(value) or (isinstance(value, str)
                                 and value.strip().lower() in _TEXTS_OF_MISSING)


def _tidy(values):
    """Objects that are all numbers as an array of numbers."""
    if values.dtype.kind == "O" and len(values) and all(
            isinstance(value, (int, float, np.number, np.bool_)) for value in values):
        return np.asarray(values.tolist())
    return values


def _key(label):
    return label.item() if isinstance(label, np.generic) else label


def _are_equal(label, other):
    try:
        return bool(label == other)
    except (TypeError, ValueError):
        return False


def _numbered(labels, where):
    """The distinct labels in the order of first appearance, and the number of each label."""
    places, first = {}, []
    numbers = np.empty(len(labels), np.int64)
    for sample, label in enumerate(labels):
        try:
            place = places.setdefault(_key(label), len(places))
        except TypeError as error:
            raise DataTypeError(f"a {type(label).__name__} is not a label", where,
                                "use texts or numbers") from error
        if place == len(first):
            first.append(sample)
        numbers[sample] = place
    names = labels[first]
    _refuse_alike(names, where)
    return names, numbers


def _refuse_alike(names, where):
    written = {}
    for name in names:
        other = written.setdefault(str(name), name)
        if other is not name:
            raise DataError(f"the labels {_key(other)!r} and {_key(name)!r} differ, but are written "
                            "alike in a model file", where, "use labels of one type")
