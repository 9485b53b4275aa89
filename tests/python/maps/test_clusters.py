"""Clusters of neurons against scipy and scikit-learn, and the clusterer in scikit-learn."""

import json
import pickle

import numpy as np
import pytest
from scipy.cluster.hierarchy import fcluster, linkage
from sklearn.base import clone
from sklearn.cluster import AgglomerativeClustering
from sklearn.metrics import adjusted_rand_score, davies_bouldin_score, silhouette_score

from pysomato import SOM, NotFittedError, SOMClusterer, UsageError

KINDS = [("rectangular", "plane"), ("rectangular", "torus"), ("hexagonal", "plane"), ("hexagonal", "torus")]


@pytest.mark.parametrize(("lattice", "topology"), KINDS)
def test_ward_is_that_of_scipy(X, lattice, topology):
    som = SOM(6, 7, lattice=lattice, topology=topology, iterations=500).fit(X)
    W = som.weights_.astype(np.float64)
    clusters = som.clusters()
    merges = linkage(W, "ward")
    np.testing.assert_allclose(clusters.merges, merges, rtol=1e-9, atol=1e-12)
    assert clusters.davies_bouldin_index == pytest.approx(davies_bouldin_score(W, clusters.labels), rel=1e-9)
    of_counts = {k: davies_bouldin_score(W, fcluster(merges, k, "maxclust")) for k in range(2, 7)}
    assert clusters.count == min(of_counts, key=of_counts.get)
    of_counts = {k: silhouette_score(W, fcluster(merges, k, "maxclust")) for k in range(2, 7)}
    assert som.clusters(index="silhouette").count == max(of_counts, key=of_counts.get)
    for count in (1, 4, 42):
        labels = som.clusters(count=count).labels
        assert adjusted_rand_score(labels, fcluster(merges, count, "maxclust")) == 1


def test_neurons_that_count_by_hits_are_repeated_rows(X):
    som = SOM(6, 7, iterations=500).fit(X)
    hits = som.hits_
    assert (hits == 0).any()
    rows = np.repeat(som.weights_.astype(np.float64), hits, axis=0)
    neurons = np.repeat(np.arange(42), hits)
    clusters = som.clusters(by_hits=True)
    merges = linkage(rows, "ward")
    heights = clusters.merges[:, 2]
    np.testing.assert_allclose(heights[heights > 0], merges[merges[:, 2] > 1e-9, 2], rtol=1e-9)
    assert clusters.davies_bouldin_index == pytest.approx(davies_bouldin_score(rows, clusters.labels[neurons]))
    assert adjusted_rand_score(clusters.labels[neurons], fcluster(merges, clusters.count, "maxclust")) == 1
    dead = np.flatnonzero(hits == 0)
    alive = np.flatnonzero(hits)
    W = som.weights_.astype(np.float64)
    nearest = alive[np.argmin(np.linalg.norm(W[dead, None] - W[None, alive], axis=2), axis=1)]
    np.testing.assert_array_equal(clusters.labels[dead], clusters.labels[nearest])


def test_connected_clusters_are_those_of_scikit_learn(X):
    som = SOM(6, 7, iterations=500).fit(X)
    row, column = np.divmod(np.arange(42), 7)
    place = np.stack([row, column], axis=1)
    edges = np.abs(place[:, None] - place[None]).sum(axis=2) == 1
    for count in (2, 3, 5):
        other = AgglomerativeClustering(count, connectivity=edges.astype(int), linkage="ward")
        labels = other.fit_predict(som.weights_.astype(np.float64))
        assert adjusted_rand_score(som.clusters(count=count, connected=True).labels, labels) == 1


def test_k_means_is_a_fixed_point(X):
    som = SOM(6, 7, iterations=500).fit(X)
    W = som.weights_.astype(np.float64)
    labels = som.clusters("k_means", 4).labels
    means = np.stack([W[labels == c].mean(axis=0) for c in range(4)])
    np.testing.assert_array_equal(np.argmin(np.linalg.norm(W[:, None] - means, axis=2), axis=1), labels)
    assert som.clusters("k_means").merges is None


def test_basins_hold_one_minimum_each(X):
    som = SOM(6, 7, lattice="hexagonal", iterations=500).fit(X)
    clusters = som.clusters("watershed")
    heights = som.u_matrix().ravel()
    lowest = [np.flatnonzero(clusters.labels == c)[np.argmin(heights[clusters.labels == c])]
              for c in range(clusters.count)]
    assert len(set(lowest)) == clusters.count
    assert som.clusters("watershed", 1).count == 1
    with pytest.raises(UsageError, match="basins"):
        som.clusters("watershed", 42)


def test_clusters_have_names(X, labels):
    pytest.importorskip("pandas")
    som = SOM(6, 7, iterations=2000).fit(X, labels)
    clusters = som.clusters(count=4)
    assert sorted(clusters.names) == sorted(set(labels))
    for cluster, name in enumerate(clusters.names):
        own = labels[clusters.labels[som.winners_] == cluster]
        assert clusters.table["purity"][cluster] == pytest.approx(np.mean(own == name))
    assert clusters.table["samples"].sum() == 60
    assert SOM(3, 3, iterations=50).fit(X).clusters().names is None


@pytest.mark.parametrize("lattice", ["rectangular", "hexagonal"])
def test_outlines_enclose_the_cells_of_clusters(X, lattice):
    """The areas within the lines, holes subtracted, are those of the cells."""
    pytest.importorskip("pandas")
    som = SOM(6, 7, lattice=lattice, iterations=500).fit(X)
    cell = som.map_.cells()[0]
    for clusters in (som.clusters(count=6), som.clusters("watershed"), som.clusters(count=1)):
        for cluster, lines in enumerate(clusters.outlines):
            areas = [area_within(line) for line in lines]
            assert all((line[0] == line[-1]).all() for line in lines)
            assert sum(areas) == pytest.approx(np.sum(clusters.labels == cluster) * area_within(cell), rel=1e-6)
            assert sum(area * areas[0] > 0 for area in areas) >= 1
    assert len(som.clusters(count=1).outlines[0]) == 1


def area_within(line):
    x, y = np.asarray(line, np.float64).T
    return 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))


def test_what_is_wrong_is_said(X, tmp_path):
    som = SOM(3, 3, iterations=50).fit(X)
    for wrong in ({"count": 0}, {"count": 10}, {"method": "other"}, {"index": "gap"}, {"most_clusters": 1},
                  {"method": "k_means", "connected": True}, {"count": 2, "most_clusters": 3}):
        with pytest.raises(UsageError):
            som.clusters(**wrong)
    som.save(tmp_path / "map.somato")
    with pytest.raises(UsageError, match="by_hits"):
        SOM.load(tmp_path / "map.somato").clusters(by_hits=True)
    assert SOM.load(tmp_path / "map.somato").clusters().count == som.clusters().count


def test_the_program_gives_the_same(X, labels, tmp_path, somato):
    np.savetxt(tmp_path / "x.csv", X, delimiter=",")
    np.savetxt(tmp_path / "y.txt", labels, fmt="%s")
    som = SOM(4, 5, iterations=500).fit(X, labels)
    som.save(tmp_path / "map.somato")
    files = {name: tmp_path / f"{name}.csv" for name in ("output", "samples", "merges", "features")}
    words = ("som", "cluster", tmp_path / "map.somato", tmp_path / "x.csv", "--labels", tmp_path / "y.txt",
             *(word for name, path in files.items() for word in (f"--{name}", path)))
    printed = json.loads(somato(*words, "--json"))
    clusters = som.clusters()
    assert [one["cluster"] for one in printed["neurons"]] == list(clusters.labels)
    assert [one["name"] for one in printed["clusters"]] == list(clusters.names)
    assert printed["davies_bouldin_index"] == clusters.davies_bouldin_index
    neurons = np.genfromtxt(files["output"], delimiter=",", names=True, dtype=None, encoding="utf-8")
    np.testing.assert_array_equal(neurons["cluster"], clusters.labels)
    np.testing.assert_array_equal(neurons["samples"], som.hits_)
    samples = np.genfromtxt(files["samples"], delimiter=",", names=True, dtype=None, encoding="utf-8")
    np.testing.assert_array_equal(samples["winner"], som.winners_)
    np.testing.assert_array_equal(samples["cluster"], clusters.labels[som.winners_])
    merges = np.genfromtxt(files["merges"], delimiter=",", skip_header=1)
    np.testing.assert_array_equal(merges, clusters.merges)
    features = np.genfromtxt(files["features"], delimiter=",", skip_header=1)
    np.testing.assert_allclose(features[:, 2], som.differences(X, clusters.labels)["difference"], atol=1e-8)


def test_the_clusterer_finds_groups(X, labels):
    clusterer = SOMClusterer(6, 6, iterations=2000, count=4)
    found = clusterer.fit_predict(X)
    assert adjusted_rand_score(found, labels) > 0.9
    np.testing.assert_array_equal(found, clusterer.labels_)
    np.testing.assert_array_equal(found, clusterer.predict(X))
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(clusterer)).predict(X), found)
    np.testing.assert_array_equal(clone(clusterer).fit(X).labels_, found)
    assert clusterer.transform(X).shape == (60, 36)
    assert clusterer.get_params()["iterations"] == 2000
    assert not hasattr(clusterer, "partial_fit")
    with pytest.raises(NotFittedError):
        SOMClusterer().predict(X)
    assert set(SOM().get_params()) < set(SOMClusterer().get_params())


def test_labels_have_no_gaps(X):
    for seed in range(5):
        clusterer = SOMClusterer(8, 8, iterations=300, count=20, seed=seed).fit(X)
        found = np.unique(clusterer.labels_)
        np.testing.assert_array_equal(found, np.arange(len(found)))
        assert adjusted_rand_score(clusterer.neuron_labels_, clusterer.clusters_.labels) == 1


def test_maps_of_others_are_clustered(X):
    weights = SOM(4, 4).fit(X).weights_.reshape(4, 4, -1)
    clusterer = SOMClusterer.from_weights(weights, count=3)
    assert clusterer.count == 3 and len(set(clusterer.neuron_labels_)) == 3
    assert len(clusterer.predict(X)) == len(X)
    assert clusterer.samples_seen_ == 0
