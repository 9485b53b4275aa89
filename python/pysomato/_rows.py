"""Rows of numbers as the C++ library takes them, and labels as it counts them."""

import numpy as np
from sklearn.utils import check_consistent_length, column_or_1d
from sklearn.utils.validation import validate_data


def rows_of(estimator, X, *, reset, least=1):
    """X as float32 in C order, without a copy if it is that already, and checked by scikit-learn."""
    return validate_data(estimator, X, reset=reset, dtype=np.float32, order="C",
                         ensure_min_samples=least)


def numbered(y, X):
    """The distinct labels in the order of first appearance, and the number of each sample's label."""
    labels = column_or_1d(y)
    check_consistent_length(X, labels)
    values, first, inverse = np.unique(labels, return_index=True, return_inverse=True)
    order = np.argsort(first)
    number = np.empty(len(order), np.int64)
    number[order] = np.arange(len(order))
    return values[order], number[inverse]
