"""Clusters that are found without labels. Each clusterer is a function of (vectors, seed), which returns the
cluster of each vector. Vectors are standardized; the seed decides their order and all random draws.
"""

import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from sklearn.cluster import KMeans
from sklearn.metrics import adjusted_rand_score, normalized_mutual_info_score

import pysomato

from . import methods

CLUSTERS = 10  # objects of the set


@dataclass(frozen=True)
class Clusterer:
    """`cluster` as above, its settings, on which stored cells depend, and its name in tables."""
    name: str
    text: str
    settings: str
    cluster: Callable
    uses_somato: bool = True


def nearest_centres(vectors, centres):
    """The number of the nearest centre of each vector; the first in a tie."""
    return np.argmin(((vectors[:, None] - centres[None]) ** 2).sum(axis=2), axis=1)


def sequential_centres(vectors, seed, count=CLUSTERS):
    """MacQueen (1967): the first vectors are the centres; each further one moves the nearest centre by
    1/n, where n is the number of vectors that this centre has had. One pass in random order.
    """
    order = np.random.default_rng(seed).permutation(len(vectors))
    centres, had = vectors[order[:count]].copy(), np.ones(count)
    for vector in vectors[order[count:]]:
        nearest = nearest_centres(vector[None], centres)[0]
        had[nearest] += 1
        centres[nearest] += (vector - centres[nearest]) / had[nearest]
    return centres


def sequential_k_means(vectors, seed):
    return nearest_centres(vectors, sequential_centres(vectors, seed))


def k_means(vectors, seed):
    return KMeans(CLUSTERS, n_init=10, random_state=seed).fit_predict(vectors)


def map_clusters(count):
    """Clusters of the neurons of a map with the defaults of pysomato; None: as many as its index selects."""
    def cluster(vectors, seed):
        clusterer = pysomato.SOMClusterer(count=count, random_state=seed, threads=1)
        return clusterer.fit(vectors.astype(np.float32)).labels_
    return cluster


def grown(vectors, seed):
    """A growing map of the vectors. A study requires two classes; they do not affect the training."""
    return methods.grown_map(methods.GROWING, vectors, np.where(np.arange(len(vectors)) % 2, "odd", "even"), seed)


def growing_clusters(vectors, seed):
    """Ward clusters of the neurons of a growing map, at most as many as neurons."""
    found = grown(vectors, seed)
    count = min(CLUSTERS, len(found.weights_))
    return found.clusters(count=count).labels[found.predict(vectors.astype(np.float32))]


def growing_parts(vectors, seed):
    """The connected parts of the graph of a growing map."""
    found = grown(vectors, seed)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "map.npz")
        found.export(file)
        edges = np.load(file)["edges"]
    neurons = len(found.weights_)
    graph = coo_array((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(neurons, neurons))
    parts = connected_components(graph, directed=False)[1]
    return parts[found.predict(vectors.astype(np.float32))]


CLUSTERERS = {clusterer.name: clusterer for clusterer in (
    Clusterer("map_10", "map, 10 clusters of neurons", "SOMClusterer(count=10)", map_clusters(CLUSTERS)),
    Clusterer("map_automatic", "map, automatic number", "SOMClusterer()", map_clusters(None)),
    Clusterer("growing_10", "growing map, 10 clusters of neurons", f"{methods.GROWING} ward, 10", growing_clusters),
    Clusterer("growing_parts", "growing map, connected parts", f"{methods.GROWING} connected parts", growing_parts),
    Clusterer("sequential_k_means", "sequential k-means, 10", "MacQueen, one pass", sequential_k_means,
              uses_somato=False),
    Clusterer("k_means", "k-means, 10, all at once", "KMeans(10, n_init=10)", k_means, uses_somato=False))}


def agreement(labels, clusters):
    """How well clusters agree with labels: the adjusted Rand index and the normalized mutual information with
    the arithmetic mean of both entropies (scikit-learn).
    """
    return {"clusters": len(np.unique(clusters)),
            "adjusted_rand_index": float(adjusted_rand_score(labels, clusters)),
            "normalized_mutual_information": float(normalized_mutual_info_score(labels, clusters))}
