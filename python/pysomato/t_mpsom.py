"""A T-MPSOM as an estimator of scikit-learn."""

import numpy as np
from sklearn.base import BaseEstimator, ClassNamePrefixFeaturesOutMixin, TransformerMixin

from . import _somato
from ._inputs.numbers import seed_of
from ._progress import shown
from ._inputs.rows import check_fitted, rows_of
from .errors import UsageError


class TMPSOM(ClassNamePrefixFeaturesOutMixin, TransformerMixin, BaseEstimator):
    """A tensor multiple peak self-organizing map (docs/mathematics/t-mpsom.md).

    The columns of a row are its inputs, one after the other. The parameters have the names, values
    and defaults of the module ``t_mpsom`` (docs/reference/modules.md); ``None`` is ``automatic``. The
    same rows and seed give the same map as in a system whose first learning module it is.

    Args:
        shape: Neurons along each axis of the grid.
        input_sizes: Columns of each input; None: one input for each axis, as equal as possible.
        input_axes: The axis of each input, from 0; None: input 0 has axis 0, and so on.
        random_state: As for ``SOM``.
        seed: As for ``SOM``.
        verbose: As for ``SOM``.

    Attributes:
        map_: The trained map. Immutable.
        samples_seen_: Samples that were learned since the map began.
    """

    def __init__(self, shape=(10, 10), *, input_sizes=None, input_axes=None, combination="multiplied",
                 arbor_sigma=1.0, neighbourhood_sigma=1.0, learning_rate_schedule="linear",
                 learning_rate_start=0.1, learning_rate_end=0.0, learning_rate_reached_at=None,
                 input_norm="l2", weight_norm="l2", iterations=5000, random_state=1, seed=None,
                 verbose=False):
        self.shape = shape
        self.input_sizes = input_sizes
        self.input_axes = input_axes
        self.combination = combination
        self.arbor_sigma = arbor_sigma
        self.neighbourhood_sigma = neighbourhood_sigma
        self.learning_rate_schedule = learning_rate_schedule
        self.learning_rate_start = learning_rate_start
        self.learning_rate_end = learning_rate_end
        self.learning_rate_reached_at = learning_rate_reached_at
        self.input_norm = input_norm
        self.weight_norm = weight_norm
        self.iterations = iterations
        self.random_state = random_state
        self.seed = seed
        self.verbose = verbose

    def fit(self, X, y=None) -> "TMPSOM":
        """Trains a new map on rows of X, drawn at random.

        Args:
            X: Numbers of (samples, columns).
            y: Ignored.

        Raises:
            UsageError: Parameters contradict each other or are out of range.
            DataError: The inputs have another number of columns.
        """
        X = rows_of(self, X, reset=True)
        with shown(type(self).__name__, bool(self.verbose)) as show:
            self.map_ = _somato.TMpsom.train(self._map_parameters(X), X, show)
        self.samples_seen_ = self.map_.parameters["iterations"]
        return self

    def partial_fit(self, X, y=None) -> "TMPSOM":
        """Learns the rows of X once each, in their order, as the next iterations of the training.

        Args:
            X: Numbers of (samples, columns).
            y: Ignored.
        """
        begins = not hasattr(self, "map_")
        X = rows_of(self, X, reset=begins, further=True)
        before = _somato.TMpsom.initial(self._map_parameters(X)) if begins else self.map_
        seen = 0 if begins else self.samples_seen_
        self.map_ = before.learned(X, seen)
        self.samples_seen_ = seen + len(X)
        return self

    def transform(self, X) -> np.ndarray:
        """The activity of all neurons for each row, in row-major order; float32 of (samples, neurons)."""
        check_fitted(self, "map_")
        return self.map_.activity(rows_of(self, X, reset=False))

    def predict(self, X) -> np.ndarray:
        """The number of each row's most active neuron, the first in a tie; int64 of (samples,)."""
        return self.transform(X).argmax(axis=1)

    def weights(self, input) -> np.ndarray:  # noqa: A002: as in the library
        """The weights of the neurons for an input, counted from 0; float32 of (neurons, elements)."""
        check_fitted(self, "map_")
        return self.map_.weights(input)

    @property
    def _n_features_out(self):
        return self.map_.neurons

    def __sklearn_tags__(self):
        tags = super().__sklearn_tags__()
        tags.transformer_tags.preserves_dtype = ["float32"]
        return tags

    def _map_parameters(self, X):
        values = self.get_params(deep=False)
        del values["verbose"]
        values["seed"] = seed_of(values.pop("random_state"), self.seed, type(self).__name__)
        values["shape"] = list(np.atleast_1d(self.shape).tolist())
        if self.input_sizes is None:
            values["input_sizes"] = self._equal_sizes(X.shape[1], len(values["shape"]))
        if self.input_axes is None:
            values["input_axes"] = []
        return values

    @staticmethod
    def _equal_sizes(columns, inputs):
        if columns < inputs:
            raise UsageError(f"the map has {inputs} axes, but the data n_features = {columns}",
                             "TMPSOM(shape)", "use at least one column for each axis")
        return [len(part) for part in np.array_split(np.arange(columns), inputs)]
