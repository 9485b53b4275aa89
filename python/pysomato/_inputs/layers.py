"""Layers of a map, as Python passes them."""

import numpy as np

from ..errors import UsageError

_DEFAULTS = ("euclidean", 1.0, None)  # distance, weight, scale


def layers_of(layers, names):
    """A list of (name, columns, distance, weight, scale) for the library."""
    try:
        items = list(layers.items())
    except AttributeError:
        raise UsageError(f"layers are a dictionary, not {type(layers).__name__}", "SOM(layers)",
                         'such as {"shape": 3, "kind": (2, "manhattan")}') from None
    if not items:
        raise UsageError("there is no layer", "SOM(layers)",
                         'pass a dictionary such as {"shape": 3, "kind": 2}, or None')
    found = []
    for name, how in items:
        columns, *others = how if isinstance(how, tuple) else (how,)
        if len(others) > len(_DEFAULTS):
            raise UsageError(f"layer '{name}' has {len(others) + 1} values", "SOM(layers)",
                             "pass columns, distance, weight and scale")
        count = _count_of(str(name), columns, sum(layer[1] for layer in found), names)
        given = (*others, *_DEFAULTS[len(others):])
        distance, weight, scale = (default if one is None else one
                                   for one, default in zip(given, _DEFAULTS))
        try:
            found.append((str(name), count, str(distance), float(weight),
                          None if scale is None else float(scale)))
        except (TypeError, ValueError):
            raise UsageError(f"layer '{name}' has a weight or scale that is no number",
                             "SOM(layers)", "pass columns, distance, weight and scale") from None
    return found


def _count_of(name, columns, first, names):
    """The number of columns, which are a number or the names of those that come next."""
    if isinstance(columns, (int, np.integer)) and not isinstance(columns, bool):
        if columns > 0:
            return int(columns)
    elif isinstance(columns, (list, np.ndarray)) and len(columns) > 0:
        listed = [str(column) for column in columns]
        known = [] if names is None else [str(column) for column in names[first:first + len(listed)]]
        if known == listed:
            return len(listed)
        raise UsageError(f"layer '{name}' begins with the column '{listed[0]}', but its columns are "
                         f"{', '.join(known) or 'not named'}", "SOM(layers)",
                         "list the columns of all layers in the order of the table")
    raise UsageError(f"the columns of layer '{name}' are neither a number above 0 nor names",
                     "SOM(layers)", "pass their number, or a list of names")


def with_columns(X, first, values, size, names):
    """X with values for the columns of a layer, which are those from ``first`` on."""
    if hasattr(X, "columns") and hasattr(X, "assign") and names is not None:
        X = X.assign(**dict(zip(names[first:first + len(values)], values)))
        return X[list(names)] if set(names) <= set(X.columns) else X
    shape = np.shape(X)
    if len(shape) != 2 or hasattr(X, "tocsr") or shape[1] not in (size, size - len(values)):
        return X
    others = np.asarray(X)
    if shape[1] == size:
        others = np.delete(others, np.s_[first:first + len(values)], axis=1)
    return np.insert(others, [first] * len(values), values, axis=1)
