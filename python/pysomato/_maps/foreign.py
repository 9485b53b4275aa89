"""Maps that were trained elsewhere: weights in an array, and objects of MiniSom."""

import numpy as np

from .. import _somato
from .._inputs.readings import columns_of, is_frame
from ..errors import DataError, DataTypeError, UsageError

_WHERE = "SOM.from_weights(weights)"

# The distances that MiniSom knows by name, from one input to all neurons; by our names.
_DISTANCES = {
    "euclidean": lambda x, w: np.linalg.norm(x - w, axis=-1),
    "cosine": lambda x, w: 1 - (w @ x) / (np.linalg.norm(w, axis=-1) * np.linalg.norm(x)),
    "manhattan": lambda x, w: np.abs(x - w).sum(axis=-1),
    "chebyshev": lambda x, w: np.abs(x - w).max(axis=-1),
}


def weights_of(weights):
    """Weights as float32 of (neurons, columns), the shape of their array, and names of columns.

    Raises:
        DataError: They are no array of two or three dimensions, or a weight is missing or infinite.
    """
    names = [] if not is_frame(weights) else [str(name) for name in columns_of(weights) or ()]
    if isinstance(weights, np.ma.MaskedArray) and np.ma.is_masked(weights):
        raise DataError("a weight is masked", _WHERE, "give all weights")
    try:
        array = np.asarray(weights)
        if array.dtype.kind not in "biufO":
            raise TypeError(f"{array.dtype}")
        exact = array.astype(np.float64)
    except (TypeError, ValueError) as error:
        raise DataTypeError("the weights are no array of numbers", _WHERE,
                            "pass numbers of (rows, columns, features)") from error
    if exact.ndim not in (2, 3) or exact.size == 0:
        raise DataError(f"the weights have the shape {exact.shape}", _WHERE,
                        "pass an array of (rows, columns, features), or of (neurons, features)")
    with np.errstate(over="ignore"):
        rounded = np.ascontiguousarray(exact.reshape(-1, exact.shape[-1]), dtype=np.float32)
    _check_finite(rounded.reshape(exact.shape), exact)
    _check_precision(exact.reshape(rounded.shape))
    return rounded, list(exact.shape), names


def _check_finite(rounded, exact):
    if np.isfinite(rounded).all():
        return
    place = tuple(int(index) for index in np.argwhere(~np.isfinite(rounded))[0])
    raise DataError(f"the weight at {place} is {exact[place]}, which is not a finite float32", _WHERE,
                    "give numbers that float32 can hold")


def _check_precision(exact):
    """Refuses columns of which float32 does not hold what differs."""
    rounding = _somato.Rounding()
    rounding.rows(exact)
    rounding.check(lambda column: f"feature {column}", _WHERE)


def parts_of_minisom(minisom, similarity):
    """The weights of a MiniSom in our order, its lattice and the similarity of its winners.

    Its first side becomes the rows of a rectangular map. On a hexagonal lattice, where lines of equal
    y are shifted, these become the rows; they are read backwards if that is needed for odd rows to be
    shifted to the right.

    Raises:
        UsageError: It has other methods than MiniSom, or another distance than those with a name.
    """
    try:
        weights = np.asarray(minisom.get_weights(), dtype=np.float64)
        lattice = {"rectangular": "rectangular", "hexagonal": "hexagonal"}[minisom.topology]
        similarity = similarity or _similarity_of(minisom, weights)
        if lattice == "hexagonal":
            weights = _in_rows(weights, minisom.get_euclidean_coordinates()[0])
    except (AttributeError, KeyError, TypeError) as error:
        raise UsageError(f"{type(minisom).__name__} has other methods than a MiniSom",
                         "SOM.from_minisom(minisom)",
                         "pass a minisom.MiniSom, or its weights to SOM.from_weights") from error
    if similarity not in _similarities():
        raise UsageError(f"the similarity '{similarity}' is unknown", "SOM.from_minisom(similarity)",
                         "use one of " + ", ".join(_similarities()))
    return weights, lattice, similarity


def _in_rows(weights, x):
    """Weights of (x, y, columns) with lines of equal y as rows; ``x`` has the positions of neurons."""
    by_lines = weights.transpose(1, 0, 2)
    is_shifted_first = by_lines.shape[0] > 1 and x[0][0] > x[0][1]
    return by_lines[::-1] if is_shifted_first else by_lines


def _similarity_of(minisom, weights):
    """The name of the distance by which ``activate`` compares an input with weights."""
    random = np.random.default_rng(1)
    spread = weights.std() or 1.0
    inputs = weights.mean(axis=(0, 1)) + spread * random.normal(size=(4, weights.shape[-1]))
    for name, distance in _DISTANCES.items():
        with np.errstate(all="ignore"):
            if all(np.allclose(minisom.activate(x), distance(x, weights), rtol=1e-5, atol=1e-7 * spread)
                   for x in inputs):
                return name
    raise UsageError("the distance of this MiniSom is none of " + ", ".join(_DISTANCES),
                     "SOM.from_minisom(minisom)",
                     "pass similarity= to find winners by another one, such as 'chebyshev' for the "
                     "signed maximum of MiniSom 2.3")


def _similarities():
    return next(info["choices"] for info in _somato.som_parameters() if info["name"] == "similarity")
