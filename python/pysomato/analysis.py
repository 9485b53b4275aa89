"""Measures of a trained map, clusters of its neurons, and its features."""

import numpy as np

from . import _somato
from ._frames import frame
from ._inputs.labels import labels_of
from ._progress import shown
from ._inputs.rows import check_fitted
from .errors import UsageError

_MEASURES = ("quantization_error", "topographic_error", "distortion", "topographic_product", "trustworthiness",
             "continuity", "neighbourhood_preservation", "explained_variance")
_NONE = np.empty(0, np.int64)


class MapMeasures(dict):
    """Measures of a map for samples, by their names; NaN where a measure is not defined.

    ``docs/mathematics/measures.md`` gives the definitions.

    Attributes:
        ranked_samples: How many samples represent all in trustworthiness, continuity and
            neighbourhood preservation; 0 without these.
        shuffled: The measures of each map of shuffled columns: a list of ``MapMeasures``.
    """

    def __init__(self, measured, class_names=(), shuffled=()):
        super().__init__(measured["values"])
        self.ranked_samples = measured["ranked_samples"]
        self.shuffled = list(shuffled)
        self._class_names = list(class_names)
        self._neurons = measured["neurons"]
        self._classes = measured["classes"]

    @property
    def neurons(self):
        """A DataFrame of pandas with a row for each neuron: samples, share of all samples, mean and
        greatest distance of its samples."""
        return frame(list(self._neurons), self._neurons)

    @property
    def classes(self):
        """A DataFrame of pandas with a row for each class: samples, neurons that win them,
        quantization error, purity and entropy."""
        count = len(self._class_names)
        columns = {name: values[:count] for name, values in self._classes.items()}
        return frame(["class", *columns], {"class": self._class_names, **columns})

    @property
    def by_chance(self):
        """The mean of each measure over the maps of shuffled columns: a dictionary."""
        return {name: float(np.mean([one[name] for one in self.shuffled])) for name in self
                if self.shuffled}


class MapClusters:
    """Clusters of the neurons of a map.

    Attributes:
        labels: The cluster of each neuron, from 0; int64 of (neurons,). ``labels[som.predict(X)]``
            are the clusters of samples.
        count: The number of clusters.
        merges: The merges of Ward's method as a linkage matrix of scipy, float64 of (neurons - 1, 4),
            for ``scipy.cluster.hierarchy.dendrogram``; None for other methods.
        davies_bouldin_index: The index of these clusters.
        outlines: For each cluster a list of closed lines around its neurons, float64 of
            (corners + 1, 2) with x and y in widths of a cell, as ``SOM.plot`` draws them: one for each
            connected region, and for each hole in it.
        names: The class of most samples of ``fit`` in each cluster, or None where no sample has a
            label; None for a map that was trained without labels.
    """

    def __init__(self, labels, merges, index, names, samples, cells):
        self.labels = labels
        self.count = int(labels.max()) + 1
        self.merges = merges if len(merges) else None
        self.davies_bouldin_index = index
        self.names = names
        self.outlines = [_outlines(cells[labels == cluster]) for cluster in range(self.count)]
        self._samples = samples

    @property
    def table(self):
        """A DataFrame of pandas with a row for each cluster: neurons, connected regions, and after
        ``fit`` samples, with labels name and purity."""
        columns = {name: self._samples[name] for name in ("neurons", "regions", "samples")}
        if self.names is not None:
            columns |= {"name": self.names, "purity": self._samples["purity"]}
        return frame(list(columns), columns)


class MapAnalysis:
    """The methods of ``SOM`` and its subclasses that analyse a trained map."""

    def measures(self, X, y=None, *, measures="all", neighbours=5, ranked_samples=2000, shuffles=0,
                 seed=1) -> MapMeasures:
        """Measures of the map for the rows of X, as ``somato som quality --measures`` prints them.

        Args:
            X: Numbers of (samples, columns).
            y: Labels of (samples,), or None. Samples without a label are together one more class,
                which is not listed.
            measures: ``all``, or a list of names: quantization_error, topographic_error, distortion,
                topographic_product, trustworthiness, continuity, neighbourhood_preservation,
                explained_variance.
            neighbours: The number k of nearest samples that trustworthiness, continuity and
                neighbourhood preservation compare. These need more than 2 k samples.
            ranked_samples: The most samples whose distances these three rank, which takes the square
                of their number; a random subset represents more.
            shuffles: How many maps are trained with the same parameters on X with shuffled columns
                and measured, as what chance gives. Each takes as long as ``fit`` and ``measures``.
            seed: The seed of the subset and of the first shuffle.

        Raises:
            UsageError: A measure is unknown, or a number is out of range.
            DataError: As for ``predict``.
        """
        X = self._checked(X)
        names = _MEASURES if isinstance(measures, str) and measures == "all" else np.atleast_1d(measures)
        labels = None if y is None else labels_of(y, len(X), self.unlabelled, "y")
        numbers = _NONE
        if labels is not None:
            numbers = np.where(labels.known, labels.numbers, len(labels.names)).astype(np.int64)
        parameters = {"neighbours": neighbours, "ranked_samples": ranked_samples, "shuffles": shuffles,
                      "seed": seed}
        with shown(f"{type(self).__name__}.measures", bool(self.verbose)) as show:
            measured, shuffled = _somato.measures(self.map_, X, numbers, [str(name) for name in names],
                                                  parameters, self._threads(), show)
        class_names = () if labels is None else labels.names
        return MapMeasures(measured, class_names, [MapMeasures(one, class_names) for one in shuffled])

    def clusters(self, method="ward", count=None, *, index="davies_bouldin", most_clusters=None,
                 by_hits=False, connected=False) -> MapClusters:
        """Clusters of the neurons, as ``somato som cluster`` finds them.

        Args:
            method: ``ward`` or ``k_means`` on the weights, or ``watershed`` of the U-matrix.
            count: The number of clusters; None: the one with the best index, or with ``watershed``
                as many as the U-matrix has basins.
            index: The index that selects the number: ``davies_bouldin``, the lowest; or
                ``silhouette``, the highest.
            most_clusters: The most clusters that are tried; None: the square root of the number of
                neurons.
            by_hits: Whether a neuron counts as many times as it wins samples of ``fit``. Neurons
                that win none then have no influence, and join the nearest one that does; otherwise
                all neurons count alike.
            connected: Whether ``ward`` only merges clusters that share an edge of the map.

        Raises:
            UsageError: There are fewer neurons or basins than clusters, a parameter has no effect
                with the others, or ``by_hits`` is set for a map without samples of ``fit``.
        """
        check_fitted(self, "map_")
        hits = getattr(self, "hits_", None)
        if by_hits and hits is None:
            raise UsageError("the map does not know how many samples each neuron wins",
                             f"{type(self).__name__}.clusters(by_hits)", "call fit, or omit by_hits")
        parameters = {"method": method, "count": count, "index": index, "most_clusters": most_clusters,
                      "by_hits": by_hits, "connected": connected}
        labels, merges, value = _somato.clusters(self.map_, parameters,
                                                 _NONE if hits is None else np.asarray(hits, np.int64))
        names, samples = self._cluster_samples(labels)
        return MapClusters(labels, merges, value, names, samples, self.map_.cells())

    def features(self, X):
        """How much of each feature's variance the map explains, and which planes are alike.

        Returns:
            A DataFrame of pandas with a row for each feature, in the order of similar component
            planes: ``feature``, its name or number from 0; ``explained_variance``,
            1 - sum (x - w)^2 / sum (x - mean)^2 with the weights w of the winners, NaN for a constant
            column; and ``group``, the group of similar planes, from 0. A map of more than 2048
            features has one group, and the order of its columns.
        """
        X = self._checked(X)
        explained, order, groups = _somato.features(self.map_, X, self._threads())
        if not len(order):
            order, groups = np.arange(len(explained)), np.zeros(len(explained), np.int64)
        return frame(["feature", "explained_variance", "group"],
                     {"feature": self._feature_names()[order], "explained_variance": explained[order],
                      "group": groups[order]})

    def plane_order(self) -> np.ndarray:
        """The numbers of the features in the order of similar component planes; int64 of (columns,)."""
        check_fitted(self, "map_")
        return _somato.plane_order(self.map_)[0]

    def differences(self, X, groups=None):
        """The features that set the samples of a group of neurons apart from all samples.

        Args:
            X: Numbers of (samples, columns).
            groups: The group of each neuron from 0, such as ``clusters().labels``; of (neurons,).
                None: each neuron is a group.

        Returns:
            A DataFrame of pandas with the columns ``group``, ``feature`` and ``difference``: the mean
            of the group's samples minus the mean of all, in standard deviations of all; for each
            group the greatest absolute difference first. Groups without samples are left out.

        Raises:
            UsageError: There is not one group for each neuron.
        """
        X = self._checked(X)
        groups = np.arange(len(self.weights_)) if groups is None else np.asarray(groups)
        if groups.shape != (len(self.weights_),) or groups.dtype.kind not in "iu" or groups.min() < 0:
            raise UsageError("groups are not one whole number from 0 for each neuron",
                             f"{type(self).__name__}.differences(groups)", "pass clusters().labels")
        of_groups = _somato.differences(self.map_, X, groups.astype(np.int64), self._threads())
        rows = {"group": np.repeat(np.arange(len(of_groups)), [len(one[0]) for one in of_groups]),
                "feature": self._feature_names()[np.concatenate([one[0] for one in of_groups])],
                "difference": np.concatenate([one[1] for one in of_groups])}
        return frame(list(rows), rows)

    def _feature_names(self):
        names = getattr(self, "feature_names_in_", None)
        return np.arange(self.n_features_in_) if names is None else np.asarray(names)

    def _cluster_samples(self, labels):
        """The names of clusters, and the columns of their table."""
        winners = np.asarray(getattr(self, "winners_", _NONE), np.int64)
        samples = _somato.cluster_samples(self.map_, labels, winners, _NONE)
        numbers = getattr(self, "_classes_of_samples", None)
        if numbers is None or not len(winners):
            return None, samples
        known = np.asarray(numbers) >= 0
        named = _somato.cluster_samples(self.map_, labels, winners[known],
                                        np.asarray(numbers, np.int64)[known])
        samples["purity"] = named["purity"]
        return [self.classes_[name] if name >= 0 else None for name in named["name"]], samples


def _outlines(cells):
    """The closed lines around cells, which are (cells, corners, 2) and share exact corners."""
    corners = {}
    edges = {}
    for cell in cells:
        keys = [tuple(np.rint(corner * 2**20).astype(int)) for corner in cell]
        corners.update(zip(keys, cell))
        for start, end in zip(keys, keys[1:] + keys[:1]):
            if start in edges.get(end, ()):
                edges[end].remove(start)  # a border within, which the two cells pass in opposite ways
            else:
                edges.setdefault(start, []).append(end)
    lines = []
    for first in list(edges):
        while edges[first]:
            line = [first, edges[first].pop(0)]
            while line[-1] != first:
                line.append(edges[line[-1]].pop(0))
            lines.append(np.array([corners[key] for key in line], np.float64))
    return lines
