"""Results as DataFrames."""


def frame(columns, rows):
    """A DataFrame of pandas."""
    import pandas  # only here, because the package works without it

    return pandas.DataFrame(rows, columns=columns)
