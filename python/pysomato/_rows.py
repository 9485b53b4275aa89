"""Rows of numbers as the C++ library takes them, and labels as it counts them."""

import os
import sys
import warnings

import numpy as np
import sklearn
from scipy.sparse import issparse
from sklearn.utils import check_consistent_length, column_or_1d
from sklearn.utils.validation import validate_data

from . import _somato
from .errors import ConversionWarning

# Bytes of converted rows from which on the conversion is reported: smaller ones cost next to nothing.
_WORTH_A_REPORT = 2**24

_reported = set()


def rows_of(estimator, X, *, reset, least=1):
    """X as float32 in C order, without a copy if it is that already, and checked by scikit-learn."""
    rows = validate_data(estimator, X, reset=reset, dtype=np.float32, order="C",
                         ensure_min_samples=least)
    _report_conversion(X, rows)
    return rows


def sample_rows_of(estimator, X, *, reset, least=1):
    """X for a map of the library: as for rows_of, or sparse in any format of scipy."""
    rows = validate_data(estimator, X, reset=reset, dtype=np.float32, order="C", accept_sparse="csr",
                         ensure_min_samples=least)
    _report_conversion(X, rows)
    return _sparse(rows) if issparse(rows) else _somato.SampleRows(rows)


def numbered(y, X):
    """The distinct labels in the order of first appearance, and the number of each sample's label."""
    labels = column_or_1d(y)
    check_consistent_length(X, labels)
    values, first, inverse = np.unique(labels, return_index=True, return_inverse=True)
    order = np.argsort(first)
    number = np.empty(len(order), np.int64)
    number[order] = np.arange(len(order))
    return values[order], number[inverse]


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
                  ConversionWarning, stacklevel=_level_of_user())


def _level_of_user():
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
