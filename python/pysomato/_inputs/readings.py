"""Readings in any form that users bring them, as arrays of numbers.

A value that is missing, in whatever form, is NaN. Texts, dates and other objects are refused by
their column and row, both counted from 0.
"""

import re
import types

import numpy as np
from scipy.sparse import issparse

from ..errors import DataError, DataTypeError

# Methods that compute the rows of an object that does not hold them yet, those that return a table of
# pandas first.
_COMPUTING = ("toPandas", "fetchdf", "execute", "collect", "compute")

# The name that pandas gives a column without one.
_UNNAMED = re.compile(r"\s*|Unnamed: \d+(_level_\d+)*")

# Above this, float64 does not represent all integers.
_EXACT_INTEGERS = 2**53


def is_frame(X):
    """Whether X is a table of columns: of pandas, polars, pyarrow, or like one of these."""
    return columns_of(X) is not None


def columns_of(X):
    """The names of the columns of a table, or None."""
    if isinstance(X, np.ndarray) or issparse(X) or not hasattr(X, "shape"):
        return None
    names = getattr(X, "column_names", None)  # pyarrow
    if names is None and (hasattr(X, "iloc") or hasattr(X, "get_column")):
        names = getattr(X, "columns", None)
    return None if names is None else list(names)


def selected(X, names, where):
    """The columns of a table that have these names, in this order.

    Raises:
        DataError: A column is missing, or several have its name.
    """
    there = columns_of(X)
    missing = [name for name in names if name not in there]
    if missing:
        raise DataError(f"the table lacks columns of fit: {', '.join(map(repr, missing))}", where,
                        "pass a table with all columns of fit; their order does not matter")
    twice = [name for name in names if there.count(name) > 1]
    if twice:
        raise DataError(f"the table has several columns with the name {twice[0]!r}", where,
                        "rename or remove all but one")
    return X.select(names) if hasattr(X, "select") else X[names]


def readings_of(X, where):
    """X as an array of float32 or float64 without a loss, as a sparse matrix, or as it is if
    scikit-learn describes better what is wrong with it.

    Raises:
        DataError: A column has no name or holds texts or dates, or rows differ in length.
        DataTypeError: X holds no numbers at all.
    """
    if issparse(X):
        return X
    _refuse_others(X, where)
    names = columns_of(X)
    if names is not None:
        return _of_frame(X, names, where)
    array = _array_of(X, where)
    if array.ndim == 0 and array.dtype.kind not in "biuf":
        raise DataTypeError(f"a {type(X).__name__} is not rows of numbers", where,
                            "pass an array of numbers")
    return numbers_of(array, where)


def numbers_of(array, where, name=lambda column: f"column {column}"):
    """An array of any type as float32 or float64 without a loss; masked values are NaN.

    Args:
        array: The array.
        where: The place in messages.
        name: The name of a column in messages.
    """
    mask = np.ma.getmaskarray(array) if isinstance(array, np.ma.MaskedArray) else None
    values = np.asarray(array if mask is None else array.data)
    if values.dtype.kind == "O":
        values = _of_objects(values, mask, where, name)
    elif values.dtype.kind == "V":
        raise DataTypeError("an array of records is not rows of numbers", where,
                            "pass numpy.lib.recfunctions.structured_to_unstructured(X)")
    elif values.dtype.kind in "US":
        _refuse_text(values, mask, where, name)
    elif values.dtype.kind in "mM":
        raise _dates(name(0), where)
    if values.dtype.kind not in "biuf":
        return values  # complex numbers
    exact = _exact(values, mask, where, name)
    if mask is None or not mask.any():
        return exact
    return np.where(mask, exact.dtype.type(np.nan), exact)


def _refuse_others(X, where):
    kind = type(X).__name__
    if hasattr(X, "__dask_graph__") or (not hasattr(X, "__array__") and columns_of(X) is None):
        for method in _COMPUTING:
            if hasattr(X, method):
                raise DataTypeError(f"a {kind} has not computed its rows yet", where,
                                    f"pass what its method {method}() returns")
    if isinstance(X, (str, bytes)):
        raise DataTypeError("a text is not rows of numbers", where,
                            "pass an array, or read a recording with pysomato.read")
    if isinstance(X, dict):
        raise DataTypeError("a dict is not rows of numbers", where, "pass pandas.DataFrame(X)")
    if isinstance(X, types.GeneratorType) or (hasattr(X, "__next__") and not hasattr(X, "shape")):
        raise DataTypeError(f"a {kind} gives its rows only once", where, "pass list(X)")
    if kind == "Recording":
        raise DataTypeError("a recording is not rows of numbers", where,
                            "pass one row for each exploration, such as [frames[-1] for frames in "
                            "recording['joints']]")


def _array_of(X, where):
    """X as an array, with the masks of its rows and without numbers that become texts."""
    if isinstance(X, np.ndarray):
        return X
    rows = list(X) if isinstance(X, (list, tuple)) else None
    try:
        if rows and _holds_masked(rows):
            return np.asarray([[None if value is np.ma.masked else value for value in row]
                               for row in rows], dtype=object)
        if rows and any(isinstance(row, np.ma.MaskedArray) for row in rows):
            return np.ma.stack(rows)
        array = np.asarray(X)
        if rows and array.dtype.kind in "US":
            array = np.asarray(X, dtype=object)
    except ValueError as error:
        raise DataError("the rows differ in length", where,
                        "pass rows with the same number of columns") from error
    except (TypeError, RuntimeError) as error:
        raise DataTypeError(f"a {type(X).__name__} is not rows of numbers: {error}", where,
                            "pass an array of numbers") from error
    return array


def refuse_unnamed(names, where):
    """Raises DataError for a column that a table has without a name."""
    for number, name in enumerate(names):
        if isinstance(name, str) and _UNNAMED.fullmatch(name):
            raise DataError(f"column {number} has no name ('{name}'): it is nearly always the index "
                            "that pandas has written", where, "read the file with index_col=0, or "
                            "drop the column; rename it to learn it")


def _holds_masked(rows):
    """Whether rows are lists with masked elements, which numpy would report once more."""
    return any(isinstance(row, (list, tuple)) and any(value is np.ma.masked for value in row)
               for row in rows)


def _of_frame(X, names, where):
    refuse_unnamed(names, where)
    sparse = _sparse_of_frame(X)
    if sparse is not None:
        return sparse
    columns = []
    for number, name in enumerate(names):
        text = f"column '{name}'"
        try:
            column = _column_of(X, number)
        except (TypeError, ValueError) as error:
            raise DataTypeError(f"{text} cannot be read: {error}", where,
                                "leave the column out, or pass an array of numpy") from error
        values = numbers_of(column, where, lambda _, text=text: text)
        if values.dtype.kind not in "f" or values.ndim != 1:
            raise DataTypeError(f"{text} holds no real numbers", where, "leave the column out")
        columns.append(values)
    if not columns:
        return np.empty((len(X), 0))
    return np.stack(columns, axis=1)


def _sparse_of_frame(X):
    """A frame of pandas whose columns are all sparse, as a sparse matrix; otherwise None."""
    try:
        return X.sparse.to_coo()
    except (AttributeError, TypeError, ValueError):
        return None


def _column_of(X, number):
    """A column of a table as an array."""
    if hasattr(X, "iloc"):
        column = X.iloc[:, number]
    elif hasattr(X, "get_column"):
        column = X.get_column(X.columns[number])
    else:
        column = X.column(number)
    kind = getattr(column, "dtype", None)
    if getattr(kind, "kind", "") in "biuf" and not isinstance(kind, np.dtype):
        try:  # numbers of pandas with NA
            return column.to_numpy(dtype=np.float64, na_value=np.nan)
        except (TypeError, ValueError):
            pass
    return np.asarray(column)


def is_missing(value):
    """Whether an object means that a value is missing: None, NA, NaN, NaT, or a masked element."""
    if value is None or value is np.ma.masked:
        return True
    try:
        return bool(value != value)
    except (TypeError, ValueError):  # NA of pandas has no truth; arrays have none either
        return type(value).__name__ == "NAType"


def _of_objects(values, mask, where, name):
    numbers = np.empty(values.shape, np.float64)
    for place, value in np.ndenumerate(values):
        if (mask is not None and mask[place]) or is_missing(value):
            numbers[place] = np.nan
        elif isinstance(value, (str, bytes)):
            raise _text(value, place, where, name)
        elif (hasattr(value, "isoformat") or hasattr(value, "total_seconds")
              or isinstance(value, (np.datetime64, np.timedelta64))):
            raise _dates(name(place[-1]), where)
        else:
            numbers[place] = _number(value, place, where, name)
    return numbers


def _number(value, place, where, name):
    try:
        return float(value)
    except (TypeError, ValueError) as error:
        if isinstance(value, (list, tuple, np.ndarray)):
            raise DataError("the rows differ in length, or their values are lists", where,
                            "pass rows with the same number of columns") from error
        raise DataTypeError(f"row {place[0]}, {name(place[-1])}: {error}", where,
                            "use numbers") from error


def _refuse_text(values, mask, where, name):
    for place, value in np.ndenumerate(values):
        if mask is None or not mask[place]:
            raise _text(value, place, where, name)


def _text(value, place, where, name):
    text = value.decode(errors="replace") if isinstance(value, bytes) else str(value)
    return DataError(f"{name(place[-1])} contains text: '{text}' in row {place[0]}", where,
                     "leave the column out, pass it to fit as y if it holds labels, or convert it to "
                     "numbers")


def _dates(column, where):
    return DataError(f"{column} contains dates or durations", where,
                     "leave the column out, or convert it to seconds since a time near it, as "
                     "(column - column.min()).dt.total_seconds() does")


def _exact(values, mask, where, name):
    """Numbers as float32 if it holds all of their type, otherwise as float64, which must hold what
    differs in a column."""
    if np.can_cast(values.dtype, np.float32):
        return values.astype(np.float32, copy=False)
    exact = values.astype(np.float64, copy=False)
    if values.dtype.itemsize < 8 or values.dtype == np.float64 or values.size == 0:
        return exact
    known = exact if mask is None else exact[~mask]
    if known.size == 0 or np.abs(known).max() <= _EXACT_INTEGERS:
        return exact
    rows = values.reshape(len(values), -1)
    for column in range(rows.shape[1]):
        of = slice(None) if mask is None else ~mask.reshape(rows.shape)[:, column]
        before, after = rows[of, column], exact.reshape(rows.shape)[of, column]
        if before.size and before.min() != before.max() and after.min() == after.max():
            raise DataError(f"{name(column)} loses precision: its numbers differ only beyond 64-bit "
                            "floating point", where, "subtract an offset from it, or leave it out")
    return exact
