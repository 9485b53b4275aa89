"""The codes of sensor readings as transformers of scikit-learn."""

import numpy as np
from sklearn.base import BaseEstimator, ClassNamePrefixFeaturesOutMixin, TransformerMixin

from . import _somato
from ._data_sets.channels import frames_of
from ._inputs.numbers import at_least_one, number
from ._inputs.rows import check_fitted, rows_of
from .errors import DataError, UsageError


class _Code(ClassNamePrefixFeaturesOutMixin, TransformerMixin, BaseEstimator):
    """A transformer of rows, float32, whose ``_code`` gives the coded rows."""

    _least = 1

    def fit(self, X, y=None):
        """Learns the number of columns, and ranges where they are not given.

        Args:
            X: Numbers of (samples, columns).
            y: Ignored.
        """
        X = rows_of(self, X, reset=True, least=self._least)
        self._learn(X)
        self._n_features_out = self._code(X[:1]).shape[1]
        return self

    def transform(self, X) -> np.ndarray:
        """The coded rows; float32 of (samples, elements)."""
        check_fitted(self, "_n_features_out")
        return self._code(rows_of(self, X, reset=False))

    def __sklearn_tags__(self):
        tags = super().__sklearn_tags__()
        tags.transformer_tags.preserves_dtype = ["float32"]
        return tags

    def _learn(self, X):
        pass


class OneHot(_Code):
    """Codes each column by the one of ``elements`` equal bins over its range that contains the value.

    A bin includes its lower edge, the last bin both; see docs/mathematics/codes.md.

    Args:
        low: Lower end of the range: a number, or one for each column; None: the smallest value that
            ``fit`` finds.
        high: Upper end, as for ``low``.
        elements: Bins of each column.
        outside: A value outside the range is an error ("refuse"), or belongs to the nearest bin
            ("clamp").

    Attributes:
        low_, high_: The ends of the ranges, one for each column.

    Raises:
        DataError: ``fit`` finds one value only in a column whose range is not given, or with
            "refuse" a value is outside the range.
    """

    _least = 2

    def __init__(self, low=None, high=None, elements=10, outside="refuse"):
        self.low = low
        self.high = high
        self.elements = elements
        self.outside = outside

    def _learn(self, X):
        self.low_ = self._ends("low", self.low, X.min(axis=0))
        self.high_ = self._ends("high", self.high, X.max(axis=0))
        for column in np.flatnonzero(self.low_ >= self.high_):
            raise DataError(f"column {column} has the range {self.low_[column]} to "
                            f"{self.high_[column]}", "OneHot", "set 'low' below 'high', or leave "
                            "the column out")

    def _ends(self, name, given, found):
        if given is None:
            return found.astype(np.float64)
        ends = self._numbers(given, f"OneHot({name})")
        if len(ends) not in (1, len(found)):
            raise UsageError(f"there are {len(ends)} numbers for {len(found)} columns", f"OneHot({name})",
                             "use one number for all columns, or one for each")
        return np.broadcast_to(ends, found.shape).copy()

    @staticmethod
    def _numbers(given, where):
        items = np.asarray(given, object).ravel()
        return np.array([number(item, where) for item in items], np.float64)

    def _code(self, X):
        columns = [{"low": low, "high": high, "elements": self.elements, "outside": self.outside}
                   for low, high in zip(self.low_.tolist(), self.high_.tolist())]
        return _somato.one_hot(columns, X)


class Spectrum(_Code):
    """The magnitude spectrum of each row, whose columns are frames in order of time.

    Its parameters are those of the module ``spectrum`` (docs/reference/modules.md); ``None`` is
    ``automatic``.

    Args:
        rate: Frames per second of the rows; None: unknown, which only ``bands=0`` permits.

    Raises:
        UsageError: Parameters contradict each other or are out of range.
        DataError: There are fewer columns than a segment, bands are above half the rate, or frames
            have another rate than the estimator whose frequencies depend on it.
    """

    def __init__(self, rate=None, *, window="hann", segment_length=None, overlap=0.5,
                 transform_length=None, remove_mean=True, quantity="magnitude", bands=32,
                 band_spacing="linear", low=0.0, high=None, scale="linear", floor=1e-6):
        self.rate = rate
        self.window = window
        self.segment_length = segment_length
        self.overlap = overlap
        self.transform_length = transform_length
        self.remove_mean = remove_mean
        self.quantity = quantity
        self.bands = bands
        self.band_spacing = band_spacing
        self.low = low
        self.high = high
        self.scale = scale
        self.floor = floor

    def of(self, frames, rate=None) -> np.ndarray:
        """The spectra of an exploration, without ``fit``.

        Args:
            frames: Numbers of (frames, elements), such as ``recording["sound"][0]``.
            rate: Frames per second; None: that of the estimator. Bands of several rates are the
                same frequencies only with ``high``, or with a ``rate`` of the estimator, the lowest
                of them.

        Returns:
            float32 of (elements, bands), or with ``bands=0`` of (elements, bins).
        """
        frames = frames_of(frames, "Spectrum.of(frames)")
        return _somato.spectrum_of(self._parameters(), frames, number(rate or self.rate or 0.0, "Spectrum(rate)"))

    def _code(self, X):
        return _somato.spectra(self._parameters(), X, number(self.rate or 0.0, "Spectrum(rate)"))

    def _parameters(self):
        values = self.get_params(deep=False)
        depends_on_rate = self.bands == 0 or self.high is None
        return {**values, "rate": (self.rate or None) if depends_on_rate else None}


class TensorProduct(_Code):
    """The tensor product of parts of each row: with parts x and y the elements x_i y_j, row by row.

    Args:
        input_sizes: Columns of each part, in order; None: one part, which is its own product.

    Raises:
        UsageError: The sizes do not add up to the number of columns.
    """

    def __init__(self, input_sizes=None):
        self.input_sizes = input_sizes

    def _learn(self, X):
        sizes = [X.shape[1]] if self.input_sizes is None else self._sizes()
        if sum(sizes) != X.shape[1]:
            raise UsageError(f"the sizes are {sizes}, but the data have {X.shape[1]} columns",
                             "TensorProduct(input_sizes)", "use sizes above 0 that add up to it")
        self.input_sizes_ = sizes

    def _sizes(self):
        sizes = np.atleast_1d(np.asarray(self.input_sizes, object)).tolist()
        return [at_least_one(size, "TensorProduct(input_sizes)") for size in sizes]

    def _code(self, X):
        return _somato.tensor_products(self.input_sizes_, X)
