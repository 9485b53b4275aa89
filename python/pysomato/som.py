"""A self-organizing map as an estimator of scikit-learn."""

import os
import warnings
from typing import NamedTuple

import numpy as np
from sklearn.base import BaseEstimator, ClassNamePrefixFeaturesOutMixin, TransformerMixin

from . import _somato
from ._foreign_maps import parts_of_minisom, weights_of
from ._labels import labels_of, places_of, warn_of_doubtful
from ._layers import layers_of, with_columns
from ._numbers import number_of_threads, seed_of
from ._progress import shown
from ._rows import check_fitted, level_of_user, sample_rows_of
from .analysis import MapAnalysis
from .drawing import Drawing, Look, MapData
from .errors import DataError, LabelWarning, LeftOutWarning, UsageError

_OF_REFINEMENT = [parameter["name"] for parameter in _somato.refinement_parameters()]

_SIZES = _somato.size_parameters()[0]["choices"]

# In __init__, but not parameters of a map.
_NOT_OF_MAP = {"random_state", "seed", "missing", "extra_columns", "unlabelled", "threads", "verbose",
               "size", *_OF_REFINEMENT}


class Contributions(NamedTuple):
    """What separates the two neurons that decide the label of each row.

    Attributes:
        neurons: The numbers of the neuron that names the row and of the most similar one with
            another label; int64 of (samples, 2).
        distances: Their distances from the row, in the units of the map; for ``dot_product`` the
            inner products; float64 of (samples, 2).
        values: The contribution of each column. Each row sums to the difference of its distances,
            the second minus the first, for ``dot_product`` to that of the inner products, the first
            minus the second; float64 of (samples, columns).
    """

    neurons: np.ndarray
    distances: np.ndarray
    values: np.ndarray


class SOM(MapAnalysis, ClassNamePrefixFeaturesOutMixin, TransformerMixin, BaseEstimator):
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
            not lower the distance of rows that are held out by more than one standard error; training is in batches, until
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

    def samples_of_neurons(self, X=None) -> dict:
        """The numbers of the rows that each neuron wins, ascending; neurons without rows are absent.

        Args:
            X: Rows; None: those of ``fit``.

        Raises:
            UsageError: There are no rows: ``fit`` was not called.
        """
        winners = self._winners_of(X, "samples_of_neurons")
        order = np.argsort(winners, kind="stable")
        neurons, first = np.unique(winners[order], return_index=True)
        return dict(zip(neurons.tolist(), np.split(order, first[1:])))

    def class_counts(self, X=None, y=None) -> tuple:
        """How many rows of each class each neuron wins, as in pies of a map.

        Args:
            X: Rows; None: those of ``fit``.
            y: Their labels; None: those of ``fit``. Rows without a label do not count.

        Returns:
            The labels, and int64 of (neurons, labels).

        Raises:
            UsageError: There are no rows or no labels.
        """
        winners = self._winners_of(X, "class_counts")
        names, numbers = self._labels_of_rows(X, y, len(winners))
        counts = np.zeros((self._n_features_out, len(names)), np.int64)
        np.add.at(counts, (winners[numbers >= 0], numbers[numbers >= 0]), 1)
        return names, counts

    def classify(self, X) -> np.ndarray:
        """The label of the labelled neuron most similar to each row; of (samples,).

        Raises:
            UsageError: The map was trained without labels.
        """
        X = self._checked(X)
        self._check_labelled("classify")
        return self.classes_[self.map_.classes(X, self._threads())]

    def contributions(self, X) -> "Contributions":
        """How much each column separates the label of a row from the next one.

        The neurons that are compared are the labelled one most similar to the row, which names it in
        ``classify``, and the most similar one of all other labels. A positive contribution makes the
        row more similar to the first, a negative one to the other; docs/mathematics/som.md defines
        them. Missing values contribute 0 and are no part of the distances; the neurons are those
        that ``classify`` compares.

        Raises:
            UsageError: The map was trained without labels, or all its neurons have the same one.
        """
        X = self._checked(X)
        self._check_labelled("contributions")
        if len(set(self.map_.neuron_labels) - {None}) < 2:
            raise UsageError("contributions compare neurons of two labels, but all have the same",
                             f"{type(self).__name__}.contributions", "fit samples of two labels")
        return Contributions(*self.map_.contributions(X, self._threads()))

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

    def score(self, X, y=None) -> float:
        """The share of rows that ``classify`` names right, or without labels the negative
        quantization error; greater is better in both cases. Rows without a label do not count.

        Raises:
            UsageError: There are labels, but the map was trained without.
            DataError: No row has a label.

        Warns:
            LabelWarning: The map knows no label of y, so that the score is 0.
        """
        X = self._checked(X)
        if y is None:
            return -self.map_.quality(X, self._threads())[0]
        self._check_labelled("score")
        labels = self._labels(y, X)
        if not labels.known.any():
            raise DataError("no sample has a label", "SOM.score(y)", "pass labels, or no y")
        places = places_of(labels.names, self.classes_)
        if (places < 0).all():
            warnings.warn(_of_unknown_labels(labels.names, self.classes_), LabelWarning,
                          stacklevel=level_of_user())
        named = self.map_.classes(X, self._threads())
        return float(np.mean((named == places[labels.numbers])[labels.known]))

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

        The distance of a row x from weights w is sqrt(sum(relevances_ * (x - w)**2)), and with
        ``similarity="manhattan"`` sum(relevances_ * abs(x - w)). Only of a map of ``refine="grlvq"``.
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

    def draw(self, panels=None, X=None, y=None, *, title="SOM", components=12, component_order="columns",
             component_scale="own", size_by_hits=False, clusters=None, trajectory=None,
             layout=None, neuron=None) -> Drawing:
        """The pictures that ``somato som plot`` draws, as SVG, which a notebook shows.

        Args:
            panels: A name or a list of names: ``u_matrix`` (mean distances of neighbours),
                ``u_matrix_edges`` (also the distance of each two neighbours), ``hits`` (samples that
                each neuron wins), ``labels`` (the winners of labelled samples), ``label_text`` (the
                name of most samples of each neuron), ``pies`` (the share of each class),
                ``components`` (the weights of each column), ``clusters`` (of the neurons),
                ``dendrogram`` (their merges), ``projection`` (the grid, and the samples X, in the
                plane of the first two principal components of the weights) and ``trajectory`` (the
                winners of consecutive samples). None: ``u_matrix``, ``hits``, ``labels`` and
                ``components`` if there are data for them.
            X: Samples for panels that need them, such as the frames of an exploration for
                ``trajectory``; None: those of ``fit``.
            y: Their labels.
            title: The title of the picture.
            components: Maximum number of component planes.
            component_order: ``"columns"``, or ``"likeness"``: correlated planes follow each other.
            component_scale: ``"own"``: colours have the range of each plane; ``"common"``: that of all.
            size_by_hits: Whether the area of a pie is proportional to its samples.
            clusters: Clusters that are outlined in all panels: ``"ward"``, ``"k_means"`` or
                ``"watershed"``, with a number as in ``"ward:4"`` or one that is chosen; or an array
                with the number of each neuron's cluster, from 0. None: none, and ``"ward"`` for the
                panels ``clusters`` and ``dendrogram``.
            trajectory: The rows that ``trajectory`` connects, as a range or slice of at most 1000
                rows; None: all. The numbers in the picture begin at 1, as those of the program.
            layout: The path of a layout file: the weights of each neuron are drawn on this skin
                instead of panels.
            neuron: With a layout, the number of the only neuron to draw, as in ``winners_``.

        Raises:
            UsageError: A panel is unknown, or its data are missing; the layout does not fit the
                columns.
        """
        if _on_skin(layout, neuron, (panels, X, y), "SOM.draw"):
            return self._data(None, None).draw_skin(layout, neuron, title, "SOM.draw")
        look = Look(components=components, component_order=component_order, component_scale=component_scale,
                    size_by_hits=size_by_hits, clusters=clusters, trajectory=trajectory)
        return self._data(X, y).draw(panels, title, look, "SOM.draw")

    def plot(self, panel=None, X=None, y=None, *, ax=None, size_by_hits=False, clusters=None,
             trajectory=None, layout=None, neuron=None):
        """Draws one panel on axes of matplotlib (``pip install 'pysomato[matplotlib]'``).

        Args:
            panel: As for ``draw``; instead of ``components`` a column: its name, or its number from 0.
                None: ``u_matrix``.
            X: As for ``draw``.
            y: As for ``draw``.
            ax: The axes; None: those of a new figure.
            size_by_hits: As for ``draw``.
            clusters: As for ``draw``.
            trajectory: As for ``draw``.
            layout: The path of a layout file: weights are drawn on this skin instead of a panel.
            neuron: With a layout, the number of the neuron, as in ``winners_``; None: the means of
                all neurons.

        Returns:
            The axes. A unit is the width of a cell, and the first row is at the top; with a layout
            it is 1 mm, and for ``projection`` that of the weights.

        Raises:
            ImportError: matplotlib is not installed.
            UsageError: The panel is unknown, or its data are missing.
        """
        if _on_skin(layout, neuron, (panel, X, y), "SOM.plot"):
            return self._data(None, None).plot_skin(layout, neuron, ax, "SOM.plot")
        look = Look(size_by_hits=size_by_hits, clusters=clusters, trajectory=trajectory)
        return self._data(X, y).plot("u_matrix" if panel is None else panel, ax, look, "SOM.plot")

    def save(self, path) -> None:
        """Writes the map to a model file, which ``somato som map`` reads as well."""
        check_fitted(self, "map_")
        self.map_.save(os.fspath(path))

    def export(self, path) -> None:
        """Writes the map to an NPZ archive, which ``numpy.load`` opens without pickle.

        ``SOM.load`` and ``somato som import`` read the same map from it. docs/formats/map-npz.md
        describes its arrays.

        Raises:
            DataError: The weights need 4 GiB or more.
        """
        check_fitted(self, "map_")
        self.map_.export_npz(os.fspath(path))

    @classmethod
    def load(cls, path, *, features=None, variable=None, **parameters) -> "SOM":
        """The estimator of a map in a file.

        Args:
            path: A model file of ``save`` or ``somato som train``, an archive of ``export``, a codebook
                of SOM_PAK or SOM Toolbox (``.cod``), or weights of (rows, columns, features) or
                (neurons, features) in a file of ``numpy.save`` or ``numpy.savez``.
            features: Names of the columns, for an array.
            variable: The array of an archive of ``numpy.savez`` with several.
            **parameters: Parameters that an array or a codebook does not contain: ``lattice``,
                ``topology``, ``similarity``, ``rows`` and ``columns`` of (neurons, features), ...

        Raises:
            OperatingSystemError: The file cannot be read.
            DataError: It is damaged, or contains no map.
            UsageError: An argument does not fit the file, or has no effect.

        Warns:
            LeftOutWarning: The map does not contain everything that is in the file.
        """
        if "layers" in parameters:
            raise UsageError("a map in a file is not divided into layers afterwards", "SOM.load(layers)",
                             "pass its array to SOM.from_weights")
        trained, notes = _somato.Map.imported(os.fspath(path), parameters,
                                              [str(name) for name in features or ()], variable or "")
        for note in notes:
            warnings.warn(f"{path}: {note}", LeftOutWarning, stacklevel=level_of_user())
        return cls._of(trained)

    @classmethod
    def from_weights(cls, weights, *, lattice="rectangular", topology="plane", features=None,
                     **parameters) -> "SOM":
        """The estimator of a map that was trained elsewhere.

        Args:
            weights: Numbers of (rows, columns, features); or of (neurons, features), row by row, with
                ``rows`` or ``columns`` as a parameter. A DataFrame of the latter has names.
            lattice: Its lattice. Odd rows of a hexagonal one are shifted to the right.
            topology: Its topology.
            features: Names of the features, or None.
            **parameters: Further parameters of ``SOM``, such as ``similarity``.

        Raises:
            DataError: The weights are no such array, not finite, or float32 does not hold what differs.
            UsageError: The parameters contradict the array or each other.
        """
        som = cls(lattice=lattice, topology=topology, **parameters)
        numbers, shape, names = weights_of(weights)
        names = names if features is None else [str(name) for name in features]
        found = cls._of(_somato.Map.of_weights(som._map_parameters(), numbers, shape, names))
        return found.set_params(**{name: value for name, value in som.get_params(deep=False).items()
                                   if name in _NOT_OF_MAP and name not in ("random_state", "seed")})

    @classmethod
    def from_minisom(cls, minisom, *, similarity=None, features=None) -> "SOM":
        """The estimator of a map of the package MiniSom, which need not be installed.

        Weights, lattice and the distance that chooses winners are taken over, the parameters of its
        training are not. The first side of a rectangular map, x, becomes the rows, so that ``divmod`` of
        a winner's number by ``columns`` is MiniSom's pair. On a hexagonal lattice MiniSom shifts lines
        of equal y; these become the rows, with the last line first if there is an even number of them.

        Args:
            minisom: A ``MiniSom``.
            similarity: Instead of its distance, which is found by comparing some values of
                ``activate``.
            features: Names of the features, or None.

        Raises:
            UsageError: Its distance has no equivalent here: a function, or the signed maximum that
                MiniSom 2.3 computes for ``chebyshev``.
            DataError: As for ``from_weights``.
        """
        weights, lattice, similarity = parts_of_minisom(minisom, similarity)
        return cls.from_weights(weights, lattice=lattice, similarity=similarity, features=features)

    @classmethod
    def _of(cls, trained):
        """The estimator of a map of the library."""
        parameters = trained.parameters
        som = cls(random_state=parameters.pop("seed"), **parameters)
        som.layers = {name: tuple(how) for name, *how in trained.layers} or None
        som.map_ = trained
        som.n_features_in_ = trained.input_size
        if trained.features:
            som.feature_names_in_ = np.array(trained.features, dtype=object)
        if trained.class_names:
            som.classes_ = np.array(trained.class_names)
        return som

    @classmethod
    def _of_samples(cls, trained, winners, names, classes):
        """The same with the winners of samples and the numbers of their classes."""
        som = cls._of(trained.labelled(names, winners, classes))
        neurons = som.map_.parameters["rows"] * som.map_.parameters["columns"]
        som.hits_ = np.bincount(winners, minlength=neurons)
        som.winners_ = winners
        som._classes_of_samples = classes
        return som

    @property
    def _n_features_out(self):
        return self.map_.parameters["rows"] * self.map_.parameters["columns"]

    def __sklearn_tags__(self):
        tags = super().__sklearn_tags__()
        tags.transformer_tags.preserves_dtype = ["float32"]
        tags.input_tags.sparse = True
        return tags

    def _repr_svg_(self):
        if not hasattr(self, "map_"):
            return None
        panels = ["u_matrix", "hits"] if hasattr(self, "hits_") else "u_matrix"
        return self.draw(panels).svg

    @property
    def _repr_html_(self):
        # A notebook prefers HTML, which describes the parameters, to the picture of a trained map.
        if hasattr(self, "map_"):
            raise AttributeError("a trained map is drawn")
        return super()._repr_html_

    def _repr_mimebundle_(self, **kwargs):
        picture = self._repr_svg_()
        if picture is None:
            return super()._repr_mimebundle_(**kwargs)
        return {"text/plain": repr(self), "image/svg+xml": picture}

    def _map_parameters(self):
        values = {name: value for name, value in self.get_params(deep=False).items()
                  if name not in _NOT_OF_MAP}
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

    def _data(self, X, y):
        """What is drawn: the samples of X, or else those of fit."""
        check_fitted(self, "map_")
        if X is None:
            if y is not None:
                raise UsageError("there are labels without samples", "SOM(y)", "pass X as well")
            numbers = getattr(self, "_classes_of_samples", None)
            classes = None if numbers is None else (self.classes_, numbers)
            return MapData(self.map_, getattr(self, "hits_", None), getattr(self, "winners_", None),
                           classes)
        X = self._checked(X)
        _, _, hits, winners = self.map_.quality(X, self._threads())
        labels = None if y is None else self._labels(y, X)
        return MapData(self.map_, hits, winners,
                       None if labels is None or not labels.known.any()
                       else (labels.names, labels.numbers), X)

    def _winners_of(self, X, method):
        """The winners of the rows of X, or else those of fit."""
        if X is not None:
            return self.map_.winners(self._checked(X), self._threads())
        check_fitted(self, "map_")
        if not hasattr(self, "winners_"):
            raise UsageError("the map does not contain the rows that it was trained on",
                             f"{type(self).__name__}.{method}", "pass X")
        return self.winners_

    def _labels_of_rows(self, X, y, rows):
        """The labels of rows of X, or else those of fit: the distinct ones, and a number for each row."""
        where = f"{type(self).__name__}.class_counts"
        if y is not None:
            labels = labels_of(y, rows, self.unlabelled, "y")
            return labels.names, labels.numbers
        if X is not None or not hasattr(self, "_classes_of_samples"):
            raise UsageError("there are no labels", where, "pass y")
        return self.classes_, self._classes_of_samples

    def _checked(self, X):
        check_fitted(self, "map_")
        return self._rows(X, reset=False)

    def _rows(self, X, **how):
        return sample_rows_of(self, X, missing=self.missing, extra_columns=self.extra_columns, **how)

    def _labels_to_learn(self, y, X):
        return self._labels(y, X)

    def _labels(self, y, X):
        return labels_of(y, len(X), self.unlabelled, "y")

    def _check_labelled(self, method):
        if not hasattr(self, "classes_"):
            raise UsageError("the neurons have no labels", f"{type(self).__name__}.{method}",
                             "pass labels to fit as y")

    def _forget(self):
        """Removes what describes the samples of an earlier training."""
        for name in ("steps_", "size_checks_", "refinement_", "quantization_error_", "topographic_error_", "hits_", "winners_",
                     "classes_", "_classes_of_samples"):
            self.__dict__.pop(name, None)

    def _take(self, trained):
        names = getattr(self, "feature_names_in_", None)
        self.map_ = trained if names is None else trained.named([str(name) for name in names])


def _of_unknown_labels(names, known):
    few = 3
    texts = [", ".join(f"'{name}'" for name in some[:few]) + (", ..." if len(some) > few else "")
             for some in (names, known)]
    return (f"the map knows no label of y ({texts[0]}), so that the score is 0; its labels are "
            f"{texts[1]}. Folds of samples that are sorted by class need "
            "cv=StratifiedKFold(n), or GroupKFold with a group for each trial")


def _on_skin(layout, neuron, others, where):
    """Whether a skin is drawn; it shows weights only."""
    if layout is None and neuron is not None:
        raise UsageError("neuron has no effect without a layout", where, "pass layout=FILE")
    if layout is not None and any(one is not None for one in others):
        raise UsageError("a picture of weights on a skin has no panels and no samples", where,
                         "omit panel, X and y, or the layout")
    return layout is not None
