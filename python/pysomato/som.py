"""A self-organizing map as an estimator of scikit-learn."""

import inspect

import numpy as np
from sklearn.base import BaseEstimator, ClassNamePrefixFeaturesOutMixin, TransformerMixin

from . import _somato
from ._inputs.labels import warn_of_doubtful
from ._inputs.layers import layers_of, with_columns
from ._inputs.numbers import number_of_threads, seed_of
from ._inputs.rows import check_fitted, level_of_user, sample_rows_of
from ._maps.drawing import MapDrawing
from ._maps.files import MapFiles
from ._maps.labels import Contributions, MapLabels
from ._progress import shown
from .analysis import MapAnalysis
from .errors import UsageError

_OF_REFINEMENT = [parameter["name"] for parameter in _somato.refinement_parameters()]

_SIZES = _somato.size_parameters()[0]["choices"]


class SOM(MapAnalysis, MapDrawing, MapFiles, MapLabels, ClassNamePrefixFeaturesOutMixin, TransformerMixin,
          BaseEstimator):
    """A self-organizing map.

    Its parameters, except those from ``random_state`` on, have the names, values and defaults of
    ``somato som train`` (docs/reference/flags-and-keys.md); ``None`` is ``automatic``. The same rows, parameters and seed
    give the same map, bit by bit, as the program. Rows are float32 in C order, (samples, columns);
    such an array is not copied, others are converted (a ``ConversionWarning`` reports large ones).
    Sparse rows of scipy give the same weights as dense ones, in less time if they are nearly empty.

    Training, ``predict`` and ``transform`` release the interpreter's lock, and Ctrl-C stops them.

    Args:
        rows: Rows of the map; None: about 10 sqrt(samples) neurons in an approximately square map, with
            20,000 iterations, or 100 per neuron, and a final radius of 0.5, unless these are given;
            or as ``size`` requires.
        columns: Columns of the map; None: as for rows.
        random_state: The seed of the initial weights and draws: a whole number, which gives the same map
            each time; or a RandomState or Generator of numpy, or None for numpy's own, from which each
            training draws another seed.
        seed: The same by its name in the program; None: ``random_state``.
        missing: Treatment of missing values of X, which are None, NA, NaN or masked: ``refuse``;
            ``mean``, which is that of the column in the training data; ``nearest``, which is the
            value of the nearest complete row in ``fit``, and the weight of the winner afterwards; or
            ``leave_out``, with which winners follow from the known values in ``fit``, too, and each
            weight learns from the rows that know its column.
        extra_columns: Treatment of a table's columns that ``fit`` did not have: ``refuse``, as in
            scikit-learn, which also requires their order; or ``ignore``, which selects those of ``fit``
            by their names.
        unlabelled: A value of y that means that a sample has no label, such as -1, in addition to
            None, NA, NaN, NaT, masked elements and empty texts.
        threads: Threads that compute; None: as many as the machine runs at once. Does not affect
            results.
        verbose: Whether ``fit`` shows its progress on standard error: a bar of tqdm, or lines without it.
        layers: Groups of neighbouring columns, each with a distance: a dictionary in the order of the
            columns, such as ``{"shape": 3, "kind": (["a", "b"], "manhattan", 2.0)}``. A layer is its
            number of columns or their names, and perhaps its distance, its weight, and the distance
            that counts as 1, by default the mean distance of training samples. The distance of a map
            with layers is the sum of theirs, each times weight and divided by scale.
        size: ``"measured"``: the size and the length follow from the rows, without labels. The number of
            neurons is the least, from a sixteenth of that of the rows to as many, than which the best does
            not lower the distance of rows that are held out by more than one standard error; fewer than 50 rows
            get as many neurons. Training is in batches, until
            nothing improves, with a final radius of 0.2. Such a map classifies better and is less suitable
            for looking at (docs/decisions/0040-automatic-size.md). Parameters that it decides, such as
            rows, columns, training and radius_end, must be left out. Rows without missing values.
        refine: ``"glvq"``: after training, ``fit`` moves the neurons by the labels y with generalized
            learning vector quantization, so that ``classify`` recognizes more samples; neighbouring
            neurons are then less alike, which ``refinement_`` measures. ``"grlvq"``: it also learns how
            much each column counts in the distance, ``relevances_``. For the Euclidean and the
            manhattan distance, without layers. ``"none"``: labels do not affect the weights.
        refine_passes: Passes over all samples.
        refine_learning_rate: Learning rate at the start, 0 to 0.5, which falls to 0.
        refine_steepness_start: Steepness of the sigmoid at the start.
        refine_steepness_end: Its steepness at the end.
        refine_neighbours: Share of a step by which adjacent neurons of the same class follow, 0 to 1.
        refine_relevance_rate: With ``"grlvq"``, by how much a sample changes relevances at the start.

    Attributes:
        map_: The trained map, which a notebook draws. Immutable.
        winners_: Number of each training sample's winner, after ``fit``; int64 of (samples,).
        hits_: Number of training samples that each neuron wins, after ``fit``; int64 of (neurons,).
        quantization_error_: Mean distance of a training sample from its winner, after ``fit``.
        topographic_error_: Share of training samples whose two best neurons share no edge, after
            ``fit``.
        steps_: Number of iterations, or epochs in batch training, that ``fit`` has made: with a
            ``tolerance`` more than ``iterations`` or ``epochs``.
        size_checks_: With ``size="measured"``, pairs (neurons, mean distance of rows that were held out)
            in the order of the measurement.
        refinement_: With ``refine``, a dictionary: ``before`` and ``after`` are dictionaries with
            ``quantization_error``, ``topographic_error``, ``trustworthiness`` and ``continuity`` of
            the map for the training samples (the latter two compare 5 neighbours of 500 random samples,
            and are NaN for 10 samples or fewer); ``named_by_nearest`` is the number of neurons that
            won no sample and took the class of the nearest, and ``classes_without_neuron`` that of
            classes that no neuron had, whose samples had no effect.
        classes_: The labels in the order of first appearance, if ``fit`` had labels.
        samples_seen_: Samples that online training has learned, in all calls since the map began;
            model files and pickles contain it.
    """

    # In __init__, but not parameters of a map.
    _NOT_OF_MAP = {"random_state", "seed", "missing", "extra_columns", "unlabelled", "threads", "verbose", "size",
                   *_OF_REFINEMENT}

    def __init__(self, rows=None, columns=None, *, lattice="rectangular", topology="plane",
                 similarity="euclidean", normalize_input=None, initial_weights="range",
                 training="online", iterations=None, epochs=20, tolerance=0.0, patience=3,
                 most_checks=100, draws="with_replacement",
                 neighbourhood="gaussian", radius_schedule="linear", radius_start=None,
                 radius_end=None, radius_reached_at=None, learning_rate_schedule="linear",
                 learning_rate_start=0.3, learning_rate_end=0.02, learning_rate_reached_at=None,
                 arithmetic="automatic", softmax="power", softmax_exponent=10.0,
                 activity_norm="maximum", random_state=1, seed=None, missing="refuse",
                 extra_columns="refuse", unlabelled=None, threads=None, verbose=False,
                 layers=None, refine="none", refine_passes=30, refine_learning_rate=0.1,
                 refine_steepness_start=2.0, refine_steepness_end=30.0, refine_neighbours=0.3,
                 refine_relevance_rate=0.03, size="by_number"):
        self.rows = rows
        self.columns = columns
        self.lattice = lattice
        self.topology = topology
        self.similarity = similarity
        self.normalize_input = normalize_input
        self.initial_weights = initial_weights
        self.training = training
        self.iterations = iterations
        self.epochs = epochs
        self.tolerance = tolerance
        self.patience = patience
        self.most_checks = most_checks
        self.draws = draws
        self.neighbourhood = neighbourhood
        self.radius_schedule = radius_schedule
        self.radius_start = radius_start
        self.radius_end = radius_end
        self.radius_reached_at = radius_reached_at
        self.learning_rate_schedule = learning_rate_schedule
        self.learning_rate_start = learning_rate_start
        self.learning_rate_end = learning_rate_end
        self.learning_rate_reached_at = learning_rate_reached_at
        self.arithmetic = arithmetic
        self.softmax = softmax
        self.softmax_exponent = softmax_exponent
        self.activity_norm = activity_norm
        self.random_state = random_state
        self.seed = seed
        self.missing = missing
        self.extra_columns = extra_columns
        self.unlabelled = unlabelled
        self.threads = threads
        self.verbose = verbose
        self.layers = layers
        self.refine = refine
        self.refine_passes = refine_passes
        self.refine_learning_rate = refine_learning_rate
        self.refine_steepness_start = refine_steepness_start
        self.refine_steepness_end = refine_steepness_end
        self.refine_neighbours = refine_neighbours
        self.refine_relevance_rate = refine_relevance_rate
        self.size = size

    def fit(self, X, y=None) -> "SOM":
        """Trains a new map on the rows of X.

        Args:
            X: Numbers of (samples, columns), at least two samples.
            y: Labels of (samples,), or None. They name the neurons for ``classify`` and ``score``.
                Only with ``refine`` do they affect the weights. Samples without a label are learned,
                and name none.

        Raises:
            UsageError: Parameters contradict each other, are out of range or have no effect; or
                there is a ``refine``, but no y.
            DataError: Values are missing, infinite, too large or no numbers; float32 does not hold
                what differs in a column; or labels cannot be distinguished.

        Warns:
            LabelWarning: A label may mean that there is none.
        """
        X = self._rows(X, reset=True, least=2).filled()
        labels = None if y is None else self._labels_to_learn(y, X)
        parameters = self._map_parameters()
        self._check_refinement(parameters, labels)
        checks = None
        if self._is_size_measured():
            parameters, checks = self._sized(parameters, X)
        with shown(type(self).__name__, bool(self.verbose)) as show:
            trained = _somato.Map.train(parameters, X, self._threads(), show)
        steps, order = trained.steps, None
        if self.refine != "none":
            with shown(f"{type(self).__name__}, refinement", bool(self.verbose)) as show:
                trained, order = trained.refined(X, labels.numbers, self._refinement(), self._threads(),
                                                 show)
        self._forget()
        self.steps_ = steps
        if checks is not None:
            self.size_checks_ = checks
        if order is not None:
            self.refinement_ = order
        found = trained.quality(X, self._threads())
        self.quantization_error_, self.topographic_error_, self.hits_, self.winners_ = found
        if labels is not None and labels.known.any():
            warn_of_doubtful(labels.names, level_of_user())
            self.classes_, self._classes_of_samples = labels.names, labels.numbers
            trained = trained.labelled([str(name) for name in labels.names],
                                       self.winners_[labels.known], labels.numbers[labels.known])
        self._take(trained)
        return self

    def partial_fit(self, X, y=None) -> "SOM":
        """Learns the rows of X once each, in their order, as the next samples of the training.

        The first call makes the initial map from its rows. Learning rate and radius follow their
        schedules over ``iterations`` samples of all calls together and then keep their final values.
        A map that was saved or pickled continues where it was. With ``missing="nearest"``, values
        that are missing are the weights of the winner; with ``"mean"``, the means of the first call.

        Args:
            X: Numbers of (samples, columns).
            y: Ignored: neurons are named by ``fit``.

        Raises:
            UsageError: ``training`` is ``batch``, a new map has a ``tolerance``, there is a
                ``refine``, or as for ``fit``.
            DataError: As for ``fit``; columns are compared with those of all calls.
        """
        begins = not hasattr(self, "map_")
        if self.training != "online":
            raise UsageError("partial_fit learns one sample after the other", "SOM(training)",
                             'use training="online", or fit')
        if begins and self.tolerance:
            raise UsageError("partial_fit learns each sample once, whatever the error is",
                             "SOM(tolerance)", "use tolerance=0, or fit")
        if self._is_size_measured():
            raise UsageError("partial_fit knows only a part of the rows, by which no size can be measured",
                             "SOM(size)", 'use size="by_number", or fit')
        if self.refine != "none":
            raise UsageError("partial_fit learns without labels, which a refinement needs",
                             "SOM(refine)", 'use refine="none", or fit')
        if not begins and self.map_.relevances is not None:
            raise UsageError("a map with relevances, which labels have refined, does not learn further",
                             "SOM.partial_fit", "fit a map with all rows")
        X = self._rows(X, reset=begins, further=True)
        X = X.filled() if begins else X
        before = _somato.Map.initial(self._map_parameters(), X) if begins else self.map_
        learned = before.learned(X, self._threads())
        self._forget()
        self._take(learned)
        return self

    def predict(self, X) -> np.ndarray:
        """The number of each row's winner, counted row by row from 0; int64 of (samples,)."""
        X = self._checked(X)
        return self.map_.winners(X, self._threads())

    def transform(self, X) -> np.ndarray:
        """The activity of all neurons for each row; float32 of (samples, neurons)."""
        X = self._checked(X)
        return self.map_.activity(X, self._threads())

    def distances(self, X) -> np.ndarray:
        """The distance of each row from the weights of all neurons; float64 of (samples, neurons)."""
        X = self._checked(X)
        return self.map_.distances(X, self._threads())

    def quantize(self, X) -> np.ndarray:
        """The weights of each row's winner, in the units of ``weights_``; float32 of (samples, columns)."""
        return self.weights_[self.map_.winners(self._checked(X), self._threads())]

    def predict_layer(self, X, layer) -> np.ndarray:
        """The columns of a layer, in their units, from those of the others; float64 of (samples, columns).

        The winner of a row is the neuron at the least distance by the other layers, and its weights
        for the layer are the prediction. The greatest of one-hot columns names the class.

        Args:
            X: Rows with all columns, of which those of the layer do not matter, or without these.
            layer: The name of the layer.

        Raises:
            UsageError: The map has no such layer, or no other one.
            DataError: A row has no known value of another layer.
        """
        check_fitted(self, "map_")
        first, count = self.map_.layer_columns(layer)
        values = (self.map_.offsets() or [0.0] * self.n_features_in_)[first:first + count]
        X = self._checked(with_columns(X, first, values, self.n_features_in_,
                                       getattr(self, "feature_names_in_", None)))
        return self.map_.predict_layer(X, layer, self._threads())

    @property
    def samples_seen_(self) -> int:
        """Samples that online training has learned, in all calls since the map began."""
        if "map_" not in self.__dict__ or self.map_.parameters["training"] != "online":
            raise AttributeError("only a map that learns one sample after the other counts them")
        return self.map_.samples_seen

    @property
    def weights_(self) -> np.ndarray:
        """Weights of the neurons, row by row; float32 of (neurons, columns)."""
        check_fitted(self, "map_")
        return self.map_.weights()

    @property
    def relevances_(self) -> np.ndarray:
        """How much each column counts in the distance, 1 on average; float64 of (columns,).

        The distance of a row x from weights w is ``sqrt(sum(relevances_ * (x - w)**2))``, and with
        ``similarity="manhattan"`` ``sum(relevances_ * abs(x - w))``. Only of a map of ``refine="grlvq"``.
        """
        check_fitted(self, "map_")
        if self.map_.relevances is None:
            raise AttributeError('only a map of refine="grlvq" has relevances')
        return self.map_.relevances

    @property
    def positions_(self) -> np.ndarray:
        """Positions of the neurons on the map; float64 of (neurons, 2), x to the right and y downwards.

        The unit is the distance of neighbours in a row; odd rows of a hexagonal lattice are shifted by
        1/2 to the right, and rows are sqrt(3)/2 apart.
        """
        check_fitted(self, "map_")
        return self.map_.positions()

    def u_matrix(self) -> np.ndarray:
        """Mean distance of each neuron's weights from those of its neighbours; of (rows, columns)."""
        check_fitted(self, "map_")
        return self.map_.u_matrix()

    @property
    def _n_features_out(self):
        return self.map_.parameters["rows"] * self.map_.parameters["columns"]

    def __setstate__(self, state):
        """Parameters that a pickle of an earlier version lacks have their defaults."""
        super().__setstate__(state)
        for name, parameter in inspect.signature(type(self).__init__).parameters.items():
            if parameter.default is not inspect.Parameter.empty:
                self.__dict__.setdefault(name, parameter.default)

    def __sklearn_tags__(self):
        tags = super().__sklearn_tags__()
        tags.transformer_tags.preserves_dtype = ["float32"]
        tags.input_tags.sparse = True
        return tags

    def _map_parameters(self):
        values = {name: value for name, value in self.get_params(deep=False).items()
                  if name not in self._NOT_OF_MAP}
        if self.layers is None:
            values.pop("layers")
        else:
            values["layers"] = layers_of(self.layers, getattr(self, "feature_names_in_", None))
        return {**values, "seed": seed_of(self.random_state, self.seed, type(self).__name__)}

    def _is_size_measured(self):
        if self.size not in _SIZES:
            raise UsageError(f"there is no size {self.size!r}", "SOM(size)", f"choose one of {', '.join(_SIZES)}")
        return self.size == "measured"

    def _sized(self, parameters, X):
        """The parameters of a map of measured size, and the checks of the measurement."""
        sized, checks = _somato.Map.sized(parameters, X, self._threads())
        return {**sized, **{name: value for name, value in parameters.items() if name == "layers"}}, checks

    def _refinement(self):
        return {name: getattr(self, name) for name in _OF_REFINEMENT}

    def _check_refinement(self, parameters, labels):
        """Refuses a refinement that is not possible, before the training."""
        _somato.check_refinement(self._refinement(), parameters)
        if self.refine != "none" and labels is None:
            raise UsageError("labels refine the map, and there are none", "SOM(refine)",
                             "pass labels to fit as y, or leave refine out")

    def _threads(self):
        return number_of_threads(self.threads, "SOM")

    def _checked(self, X):
        check_fitted(self, "map_")
        return self._rows(X, reset=False)

    def _rows(self, X, **how):
        return sample_rows_of(self, X, missing=self.missing, extra_columns=self.extra_columns, **how)

    def _forget(self):
        """Removes what describes the samples of an earlier training."""
        for name in ("steps_", "size_checks_", "refinement_", "quantization_error_", "topographic_error_", "hits_", "winners_",
                     "classes_", "_classes_of_samples"):
            self.__dict__.pop(name, None)

    def _take(self, trained):
        names = getattr(self, "feature_names_in_", None)
        self.map_ = trained if names is None else trained.named([str(name) for name in names])
