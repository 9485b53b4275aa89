"""A self-organizing map as a clusterer of scikit-learn."""

import inspect

import numpy as np
from sklearn.base import ClusterMixin

from ._inputs.rows import check_fitted
from .som import SOM

# The parameters of the clusters, with the names of SOM.clusters.
_OF_CLUSTERS = ("method", "count", "index", "most_clusters", "by_hits", "connected")


class SOMClusterer(ClusterMixin, SOM):
    """Clusters samples: trains a self-organizing map, and clusters its neurons.

    Parameters, attributes and methods are those of ``SOM``, except those that follow here.

    Args:
        method: As for ``SOM.clusters``, and so are the next ones.
        count: The number of clusters; None: chosen by ``index``.
        index: The index that selects the number.
        most_clusters: The most clusters that are tried.
        by_hits: Whether a neuron counts as many times as it wins samples.
        connected: Whether ``ward`` only merges clusters that share an edge of the map.
        parameters: Those of ``SOM``.

    Attributes:
        labels_: The cluster of each training sample, from 0; int64 of (samples,).
        neuron_labels_: The cluster of each neuron; int64 of (neurons,). Clusters that win no sample
            have the highest numbers.
        clusters_: The clusters as ``SOM.clusters`` returns them, with its numbers.
    """

    def __init__(self, rows=None, columns=None, *, method="ward", count=None, index="davies_bouldin",
                 most_clusters=None, by_hits=False, connected=False, **parameters):
        super().__init__(rows, columns, **parameters)
        self.method = method
        self.count = count
        self.index = index
        self.most_clusters = most_clusters
        self.by_hits = by_hits
        self.connected = connected

    def fit(self, X, y=None) -> "SOMClusterer":
        """Trains a new map on the rows of X and clusters its neurons.

        Args:
            X: Numbers of (samples, columns), at least two samples.
            y: Ignored.

        Raises:
            UsageError: As for ``SOM.fit`` and ``SOM.clusters``.
            DataError: As for ``SOM.fit``.
        """
        super().fit(X)._cluster_neurons()
        self.labels_ = self.neuron_labels_[self.winners_]
        return self

    @classmethod
    def from_weights(cls, weights, **parameters) -> "SOMClusterer":
        """As ``SOM.from_weights``, with the parameters of the clusters."""
        own = {name: parameters.pop(name) for name in _OF_CLUSTERS if name in parameters}
        return super().from_weights(weights, **parameters).set_params(**own)._cluster_neurons()

    @classmethod
    def _of(cls, trained):
        return super()._of(trained)._cluster_neurons()

    def _cluster_neurons(self):
        self.clusters_ = self.clusters(**{name: getattr(self, name) for name in _OF_CLUSTERS})
        labels = self.clusters_.labels
        self.neuron_labels_ = (_with_samples_first(labels, self.hits_) if hasattr(self, "hits_")
                               else labels)
        return self

    @property
    def partial_fit(self):
        """Not available: a map is clustered after it has been trained."""
        raise AttributeError("SOMClusterer is trained by fit; SOM.partial_fit learns further samples")

    def predict(self, X) -> np.ndarray:
        """The cluster of each row's winner; int64 of (samples,)."""
        check_fitted(self, "neuron_labels_")
        return self.neuron_labels_[super().predict(X)]

    def score(self, X, y=None) -> float:
        """The negative quantization error; y is ignored."""
        return super().score(X)

    def _map_parameters(self):
        return {name: value for name, value in super()._map_parameters().items()
                if name not in _OF_CLUSTERS}

    def _forget(self):
        super()._forget()
        for name in ("clusters_", "neuron_labels_", "labels_"):
            self.__dict__.pop(name, None)


def _with_samples_first(labels, hits):
    """The labels with other numbers, so that the clusters that win samples have the lowest ones."""
    samples = np.bincount(labels, weights=hits)
    numbers = np.empty(len(samples), np.int64)
    numbers[np.argsort(samples == 0, kind="stable")] = np.arange(len(samples))
    return numbers[labels]


def _signature():
    """All parameters, which scikit-learn reads from the signature."""
    own = inspect.signature(SOMClusterer.__init__)
    of_map = inspect.signature(SOM.__init__).parameters
    parameters = [one for one in own.parameters.values() if one.kind != inspect.Parameter.VAR_KEYWORD]
    further = [one for name, one in of_map.items() if name not in own.parameters]
    return own.replace(parameters=[*parameters, *further])


SOMClusterer.__init__.__signature__ = _signature()
