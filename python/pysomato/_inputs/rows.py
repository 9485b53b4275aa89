"""Rows of numbers as the C++ library takes them."""

import copy
import os
import sys
import warnings

import numpy as np
import sklearn
from scipy.sparse import issparse
from sklearn.utils import check_array
from sklearn.utils.validation import check_is_fitted, validate_data

from .. import _somato
from .numbers import one_of
from .readings import columns_of, is_frame, readings_of, selected
from ..errors import (ConversionWarning, DataError, NotFittedError, PrecisionWarning,
                     errors_of_sklearn)

# Bytes of converted rows from which on the conversion is reported: smaller ones cost next to nothing.
_WORTH_A_REPORT = 2**24

# The place in messages about rows.
_WHERE = "X"

# Rows from which on their deviation is known.
_FEW_ROWS = 10

_reported = set()


def check_fitted(estimator, attribute):
    """Raises NotFittedError unless the estimator is trained."""
    try:
        check_is_fitted(estimator, attribute)
    except sklearn.exceptions.NotFittedError as error:
        raise NotFittedError("the estimator is not trained yet", type(estimator).__name__,
                             "call fit before") from error


def rows_of(estimator, X, *, reset, further=False, least=1):
    """X as float32 in C order, without a copy if it is that already.

    Args:
        estimator: Knows the columns afterwards, and what differs in them.
        X: Numbers of (samples, columns), of any type and in any form.
        reset: Whether the training begins.
        further: Whether a training continues.
        least: The number of samples that are needed.

    Raises:
        DataError: A value is missing, infinite or no number, a column has no name, or float32 does
            not hold what differs in a column.
    """
    known = None if reset or further else getattr(estimator, "_rounding", None)
    rows, _ = _rounded(estimator, X, reset, further, least, "refuse",
                       lambda: ([], [] if known is None else known.deviations()))
    return rows


def sample_rows_of(estimator, X, *, reset, further=False, least=1, missing="refuse",
                   extra_columns="refuse"):
    """X for a map of the library: as for rows_of, or sparse in any format of scipy; missing values
    are kept as NaN unless they are refused. With extra_columns="ignore", the columns of fit are selected
    by their names."""
    one_of(missing, ("refuse", "mean", "nearest", "leave_out"), f"{type(estimator).__name__}(missing)")
    X = _known_columns(estimator, X, reset, extra_columns)
    trained = None if reset else estimator.map_
    rows, moved = _rounded(estimator, X, reset, further, least, missing,
                           lambda: (([], []) if trained is None
                                    else (trained.offsets(), _deviations_of(estimator))),
                           accept_sparse="csr")
    if issparse(rows):
        return _sparse(rows)
    # A trained map fills values only if there are missing ones.
    if trained is not None and not further and missing != "refuse" and not np.isnan(rows).any():
        missing = "refuse"
    return _somato.SampleRows(rows, missing, moved)


def _deviations_of(estimator):
    """The deviations of columns by the map, or by the training data where these are known."""
    of_map = estimator.map_.deviations()
    learned = getattr(estimator, "_rounding", None)
    of_data = [] if learned is None else learned.deviations()
    return list(np.maximum(of_map, of_data)) if len(of_data) == len(of_map) else of_map


def _known_columns(estimator, X, reset, extra_columns):
    """X, or the columns of a table that an estimator knows by their names."""
    one_of(extra_columns, ("refuse", "ignore"), f"{type(estimator).__name__}(extra_columns)")
    known = getattr(estimator, "feature_names_in_", None)
    if reset or extra_columns == "refuse" or known is None or not is_frame(X):
        return X
    return selected(X, list(known), _WHERE)


def _rounded(estimator, X, reset, further, least, missing, scales, **options):
    """The rows as float32, and whether offsets were subtracted from them; ``scales`` gives the offsets
    and the deviations that are known of the columns."""
    array = readings_of(X, _WHERE)
    if is_frame(X) and issparse(array) and "accept_sparse" not in options:
        array = array.toarray()
    with errors_of_sklearn(_WHERE, "pass an array of (samples, columns) with the columns of fit"):
        exact = check_array(array, dtype=(np.float64, np.float32), ensure_min_samples=least,
                            ensure_all_finite=False, input_name=_WHERE, estimator=estimator, **options)
        validate_data(estimator, X if is_frame(X) else exact, reset=reset, skip_check_array=True)
    names = columns_of(X)
    _check_known(exact, missing, names, reset)
    # Zeros of sparse rows cannot be moved, and what was float32 has lost nothing here.
    is_moved = exact.dtype == np.float64 and not issparse(exact)
    offsets, deviations = scales() if is_moved else ([], [])
    rounding = _somato.Rounding()
    rounding.know(offsets, deviations)
    rows = _round(exact, rounding, names)
    # A few rows of a stream may be alike.
    are_few = further and not reset and getattr(estimator, "samples_seen_", _FEW_ROWS) < _FEW_ROWS
    if not are_few:
        _check(rounding, names)
    if reset or further:
        _warn_of_rounded(rounding, names)
        estimator._rounding = (rounding if reset
                               else _of_all_calls(estimator, exact, offsets, names, not are_few))
    _report_conversion(X, rows)
    return rows, len(offsets) > 0


def _check(rounding, names):
    rounding.check(lambda column: _column(names, column), _WHERE)


def _warn_of_rounded(rounding, names):
    """Warns of columns of which rounding to float32 loses something."""
    for note in rounding.notes(lambda column: _column(names, column)):
        warnings.warn(f"{note}; subtract its mean before fit, as StandardScaler does in a pipeline",
                      PrecisionWarning, stacklevel=level_of_user())


def _of_all_calls(estimator, exact, offsets, names, checks):
    """What is lost in the columns of all calls together: each may be a single row."""
    learned = getattr(estimator, "_rounding", None)
    rounding = _somato.Rounding() if learned is None else copy.copy(learned)
    rounding.know(offsets, [])
    _round(exact, rounding, names)
    if checks:
        _check(rounding, names)
    return rounding


def _round(exact, rounding, names):
    if exact.dtype == np.float32:
        return exact if issparse(exact) else np.ascontiguousarray(exact)
    if not issparse(exact):
        rows = rounding.rows(exact)
        _check_finite(rows, names, "is beyond single precision", "scale its column")
        return rows
    values = rounding.sparse(exact.indices.astype(np.int64), exact.data, *exact.shape)
    rows = type(exact)((values, exact.indices, exact.indptr), shape=exact.shape)
    _check_finite(rows, names, "is beyond single precision", "scale its column")
    return rows


def _column(names, column):
    return f"column {column}" if names is None else f"column {column} ('{names[column]}')"


def _check_finite(rows, names, what, advice):
    """Raises DataError with the place of the first infinite value."""
    values = rows.data if issparse(rows) else rows
    if np.isfinite(np.sum(values, dtype=np.float64)) or not np.isinf(values).any():
        return
    row, column = _first(rows, np.isinf)
    raise DataError(f"the value in row {row}, {_column(names, column)} {what}", _WHERE, advice)


def _first(rows, condition):
    """Row and column of the first value that meets a condition."""
    if not issparse(rows):
        return tuple(int(index) for index in np.argwhere(condition(rows))[0])
    place = int(np.flatnonzero(condition(rows.data))[0])
    row = int(np.searchsorted(rows.indptr, place, side="right")) - 1
    return row, int(rows.indices[place])


def _check_known(exact, missing, names, reset):
    """Raises DataError for infinite values, and for missing ones that are refused or that nothing
    could fill."""
    values = exact.data if issparse(exact) else exact
    if np.isfinite(np.sum(values, dtype=np.float64)):
        return
    _check_finite(exact, names, "is infinite (inf)", "leave the row out")
    if not np.isnan(values).any():
        return
    if missing == "refuse" or issparse(exact):
        row, column = _first(exact, np.isnan)
        raise DataError(f"the value in row {row}, {_column(names, column)} is missing (NaN)", _WHERE,
                        "leave the row out, fill it in, or pass dense rows to a map with "
                        "SOM(missing='mean'), 'nearest' or 'leave_out'")
    unknown = np.isnan(exact)
    if unknown.all(axis=1).any():
        raise DataError(f"row {int(unknown.all(axis=1).argmax())} has no known value", _WHERE,
                        "leave the row out")
    if reset and unknown.all(axis=0).any():
        column = int(unknown.all(axis=0).argmax())
        raise DataError(f"{_column(names, column)} has no known value", _WHERE,
                        "leave the column out")


def _sparse(rows):
    """Rows in the format CSR for the library, with ascending columns."""
    if not rows.has_canonical_format:
        rows = rows.copy()
        rows.sum_duplicates()
    return _somato.SampleRows(rows.shape[1], np.ascontiguousarray(rows.indptr, np.int64),
                              np.ascontiguousarray(rows.indices, np.uint32),
                              np.ascontiguousarray(rows.data))


def _report_conversion(X, rows):
    """Warns, once for each reason, if many rows were copied because they had another form."""
    size = rows.data.nbytes
    reason = None if size < _WORTH_A_REPORT else _reason_of_copy(X, rows)
    if reason is None or reason in _reported:
        return
    _reported.add(reason)
    warnings.warn(f"{size / 2**20:.0f} MiB of rows were copied: {reason}. Rows of float32 in C order, "
                  "as numpy.ascontiguousarray(X, numpy.float32) gives them, are not copied",
                  ConversionWarning, stacklevel=level_of_user())


def level_of_user():
    """The number of frames from the caller up to the first one outside of this package and sklearn."""
    inside = tuple(os.path.dirname(module.__file__) + os.sep for module in (_somato, sklearn))
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and frame.f_code.co_filename.startswith(inside):
        frame, level = frame.f_back, level + 1
    return level


def _reason_of_copy(X, rows):
    if rows is X or (isinstance(X, np.ndarray) and np.may_share_memory(X, rows)):
        return None
    if not hasattr(X, "dtype"):
        return f"{type(X).__name__} is not an array"
    if X.dtype != np.float32:
        return f"{X.dtype} was converted to float32"
    if issparse(X):
        return f"the format {X.format.upper()} was converted to CSR" if X.format != "csr" else None
    return "they were not in C order"
