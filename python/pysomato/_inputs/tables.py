"""Tables whose rows are explorations."""

import numpy as np

from .readings import columns_of, readings_of, selected
from ..errors import DataError, UsageError

_WHERE = "from_table"


def arrays_of_table(table, label_column, labels, skip, missing):
    """The arguments of ``Recording.from_arrays`` for ``Recording.from_table``."""
    if missing not in ("refuse", "mask"):
        raise UsageError(f"'missing' is {missing!r}", _WHERE, "use 'refuse' or 'mask'")
    if label_column is not None and labels is not None:
        raise UsageError("labels are given by a column and by a list", _WHERE, "use one of them")
    names = columns_of(table)
    left_out = list(skip) + ([] if label_column is None else [label_column])
    _check_names(names, left_out)
    if label_column is not None:
        labels = list(table[label_column])
    features = None if names is None else [name for name in names if name not in left_out]
    values = _values(table if features is None else selected(table, features, _WHERE))
    if missing == "refuse":
        _refuse_missing(values, features)
    return {**_masked(values, missing),
            "labels": _labels(label_column or "label", labels, len(values)),
            "element_names": {} if features is None else {"columns": [str(name) for name in features]}}


def _check_names(names, wanted):
    if wanted and names is None:
        raise UsageError("the table has no names of columns", _WHERE,
                         "pass a DataFrame, or the labels as 'labels'")
    for name in wanted:
        if name not in names:
            raise UsageError(f"there is no column {name!r}", _WHERE,
                             f"columns are: {', '.join(map(str, names))}")


def _values(table):
    values = readings_of(table, _WHERE)
    values = values.toarray() if hasattr(values, "toarray") else np.asarray(values)
    if values.ndim != 2:
        raise UsageError(f"an array of {values.ndim} axes is not a table", _WHERE,
                         "pass an array of (rows, columns)")
    return values


def _refuse_missing(values, features):
    places = np.argwhere(np.isnan(values))
    if len(places):
        row, column = places[0]
        name = column if features is None else repr(features[column])
        raise DataError(f"the value of row {row}, column {name} is missing", _WHERE,
                        "pass missing='mask', or fill it before")


def _masked(values, missing):
    if missing == "refuse":
        return {"channels": {"columns": list(values[:, np.newaxis])}}
    known = ~np.isnan(values)
    return {"channels": {"columns": list(np.where(known, values, 0)[:, np.newaxis])},
            "valid": {"columns": list(known[:, np.newaxis])}}


def _labels(name, labels, count):
    rows = {"row": [str(row + 1) for row in range(count)]}
    if labels is None:
        return rows
    if len(labels) != count:
        raise UsageError(f"there are {len(labels)} labels for {count} rows", _WHERE,
                         "pass one for each row")
    return {name: list(labels), **rows}
