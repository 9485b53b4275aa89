"""Measures of maps against independent computations with numpy and scikit-learn."""

import json

import numpy as np
import pytest
from sklearn.manifold import trustworthiness

from pysomato import SOM, DataError, UsageError

KINDS = [("rectangular", "plane"), ("rectangular", "torus"), ("hexagonal", "plane"), ("hexagonal", "torus")]


def data(n=70, columns=4, seed=3):
    random = np.random.default_rng(seed)
    return (random.normal(size=(n, columns)) @ random.normal(size=(columns, columns))).astype(np.float32)


def grid_squares(rows, columns, lattice, topology):
    """Squared distances of all pairs of neurons, by all shifts of a torus."""
    row, column = np.divmod(np.arange(rows * columns), columns)
    high = np.sqrt(3) / 2 if lattice == "hexagonal" else 1.0
    place = np.stack([column + (0.5 * (row % 2) if lattice == "hexagonal" else 0.0), row * high], axis=1)
    shifts = [(x * columns, y * rows * high) for x in (-1, 0, 1) for y in (-1, 0, 1)]
    shifts = shifts if topology == "torus" else [(0, 0)]
    return np.round(min_over((place[:, None] - place[None] + shift) ** 2 for shift in shifts), 6)


def min_over(squares):
    return np.min([one.sum(axis=2) for one in squares], axis=0)


def winners_of(X, W):
    distances = np.linalg.norm(X[:, None].astype(float) - W[None].astype(float), axis=2)
    return distances, np.argsort(distances, axis=1, kind="stable")


def expected(distances, k):
    """The probability of a rank up to k, and the mean of max(0, rank - k), over random orders of ties."""
    others = np.where(np.eye(len(distances), dtype=bool), np.nan, distances)
    first = 1 + np.sum(others[:, None, :] < others[:, :, None], axis=2)
    ties = np.sum(others[:, None, :] == others[:, :, None], axis=2)
    ranks = np.arange(1, len(distances) + 1)
    possible = (ranks >= first[..., None]) & (ranks < (first + ties)[..., None])
    ties = np.maximum(ties, 1)
    return (np.sum(possible & (ranks <= k), axis=2) / ties,
            np.sum(possible * np.maximum(0, ranks - k), axis=2) / ties)


def topographic_product(W, squares):
    n = len(W)
    inputs = np.linalg.norm(W[:, None].astype(float) - W[None].astype(float), axis=2)
    total = 0.0
    for j in range(n):
        others = np.delete(np.arange(n), j)
        on_map = others[np.argsort(squares[j, others], kind="stable")]
        in_input = others[np.argsort(inputs[j, others], kind="stable")]
        q1 = inputs[j, on_map] / inputs[j, in_input]
        q2 = np.sqrt(squares[j, on_map] / squares[j, in_input])
        total += np.sum(np.cumsum(np.log(q1 * q2)) / (2 * np.arange(1, n)))
    return total / (n * (n - 1))


@pytest.mark.parametrize(("lattice", "topology"), KINDS)
@pytest.mark.parametrize("training", ["online", "batch"])
def test_measures_are_those_of_numpy(lattice, topology, training):
    X = data()
    length = {"epochs": 10} if training == "batch" else {"iterations": 400}
    som = SOM(6, 5, lattice=lattice, topology=topology, training=training, radius_end=0.8, **length).fit(X)
    W, k = som.weights_, 4
    squares = grid_squares(6, 5, lattice, topology)
    distances, order = winners_of(X, W)
    found = som.measures(X, neighbours=k)
    winners, seconds = order[:, 0], order[:, 1]
    assert found["quantization_error"] == pytest.approx(distances.min(axis=1).mean(), rel=1e-6)
    assert found["topographic_error"] == pytest.approx(np.mean(squares[winners, seconds] > 1.01))
    near = np.exp(-squares[winners] / (2 * 0.8**2))
    assert found["distortion"] == pytest.approx(np.sum(near * distances**2, axis=1).mean(), rel=1e-6)
    assert found["topographic_product"] == pytest.approx(topographic_product(W, squares), abs=1e-9)
    residuals = np.sum((X.astype(float) - W[winners]) ** 2)
    variance = np.sum((X.astype(float) - X.astype(float).mean(axis=0)) ** 2)
    assert found["explained_variance"] == pytest.approx(1 - residuals / variance, rel=1e-9)
    n = len(X)
    of_input = expected(np.linalg.norm(X[:, None].astype(float) - X[None], axis=2), k)
    of_map = expected(squares[winners][:, winners], k)
    scale = 2 / (n * k * (2 * n - 3 * k - 1))
    assert found["trustworthiness"] == pytest.approx(1 - scale * np.sum(of_map[0] * of_input[1]), abs=1e-12)
    assert found["continuity"] == pytest.approx(1 - scale * np.sum(of_input[0] * of_map[1]), abs=1e-12)
    kept = np.sum(of_input[0] * of_map[0]) / (n * k)
    assert found["neighbourhood_preservation"] == pytest.approx(kept, abs=1e-12)


def test_trustworthiness_without_ties_is_that_of_scikit_learn():
    """Places of a line whose distances from each place differ, as powers of two have them."""
    places = np.array([0, 1, 3, 7, 15, 31, 63])
    som = SOM(1, 64, iterations=1000).fit(data(200))
    X = som.weights_[places]
    np.testing.assert_array_equal(som.predict(X), places)
    on_map = np.stack([places, np.zeros(7)], axis=1)
    assert som.measures(X, neighbours=2)["trustworthiness"] == pytest.approx(
        trustworthiness(X, on_map, n_neighbors=2), abs=1e-12)


def test_trustworthiness_is_the_mean_of_scikit_learns_over_orders_of_ties():
    X = data(60)
    som = SOM(5, 5, iterations=500).fit(X)
    found = som.measures(X, neighbours=5, measures=["trustworthiness", "continuity"])
    row, column = np.divmod(som.predict(X), 5)
    place = np.stack([column, row], axis=1).astype(float)
    random = np.random.default_rng(2)
    moved = [place + random.normal(size=place.shape) * 1e-6 for _ in range(300)]
    means = [trustworthiness(X, one, n_neighbors=5) for one in moved]
    assert found["trustworthiness"] == pytest.approx(np.mean(means), abs=4 * np.std(means) / np.sqrt(300))
    swapped = [trustworthiness(one, X, n_neighbors=5) for one in moved]
    assert found["continuity"] == pytest.approx(np.mean(swapped), abs=4 * np.std(swapped) / np.sqrt(300))


def test_neurons_and_classes_are_those_of_pandas(X, labels):
    pandas = pytest.importorskip("pandas")
    som = SOM(3, 4, iterations=300).fit(X)
    found = som.measures(X, labels, measures=[])
    distances, order = winners_of(X, som.weights_)
    table = pandas.DataFrame({"winner": order[:, 0], "distance": distances.min(axis=1), "label": labels})
    of_winners = table.groupby("winner")["distance"].agg(["size", "mean", "max"]).reindex(range(12))
    np.testing.assert_array_equal(found.neurons["samples"], of_winners["size"].fillna(0))
    np.testing.assert_allclose(found.neurons["mean_distance"], of_winners["mean"], rtol=1e-6)
    np.testing.assert_allclose(found.neurons["greatest_distance"], of_winners["max"], rtol=1e-6)
    np.testing.assert_allclose(found.neurons["share"], of_winners["size"].fillna(0) / 60)
    classes = found.classes.set_index("class")
    share = pandas.crosstab(table["label"], table["winner"])
    for name, row in share.iterrows():
        p = row[row > 0] / row.sum()
        assert classes.loc[name, "entropy"] == pytest.approx(-np.sum(p * np.log2(p)), abs=1e-12)
        assert classes.loc[name, "neurons"] == len(p)
        assert classes.loc[name, "purity"] == pytest.approx(np.sum(row**2 / share.sum()) / row.sum())
        of_class = table["distance"][table["label"] == name]
        assert classes.loc[name, "quantization_error"] == pytest.approx(of_class.mean(), rel=1e-6)
    assert list(found) == []


def test_samples_without_a_label_are_not_listed(X, labels):
    pytest.importorskip("pandas")
    some = labels.astype(object)
    some[::5] = None
    found = SOM(3, 4, iterations=300).fit(X).measures(X, some, measures=["topographic_error"])
    assert found.classes["samples"].sum() == np.sum([one is not None for one in some])
    assert (found.classes["purity"] <= 1).all()


def test_shuffled_columns_are_what_chance_gives(X):
    som = SOM(4, 4, iterations=500).fit(X)
    found = som.measures(X, shuffles=3, seed=5)
    assert len(found.shuffled) == 3
    assert found.by_chance["explained_variance"] < found["explained_variance"] - 0.1
    again = som.measures(X, shuffles=1, seed=6)
    assert again.shuffled[0] == found.shuffled[1]
    assert som.measures(X).by_chance == {}


def test_a_subset_represents_many_samples(X):
    som = SOM(3, 3, iterations=200).fit(X)
    found = som.measures(X, ranked_samples=30)
    assert found.ranked_samples == 30
    assert found["trustworthiness"] != som.measures(X, ranked_samples=30, seed=2)["trustworthiness"]
    assert som.measures(X).ranked_samples == 60
    assert np.isnan(som.measures(X[:10])["trustworthiness"])


def test_features_are_those_of_numpy(X):
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(X, columns=[f"joint{i}" for i in range(7)]).assign(still=2.0)
    som = SOM(4, 4, iterations=500).fit(table)
    found = som.features(table).set_index("feature")
    winners = som.predict(table)
    values = table.to_numpy(np.float64)
    for place, name in enumerate(table.columns[:-1]):
        residual = np.sum((values[:, place] - som.weights_[winners, place]) ** 2)
        share = 1 - residual / np.sum((values[:, place] - values[:, place].mean()) ** 2)
        assert found.loc[name, "explained_variance"] == pytest.approx(share, rel=1e-6)
    assert np.isnan(found.loc["still", "explained_variance"])
    assert found.index[-1] == "still"
    assert sorted(som.plane_order()) == list(range(8))
    clusters = som.clusters(count=3)
    differences = som.differences(table, clusters.labels)
    z = (values - values.mean(axis=0)) / np.where(values.std(axis=0) > 0, values.std(axis=0), 1)
    for group, rows in differences.groupby("group"):
        means = z[clusters.labels[winners] == group].mean(axis=0)
        for feature, difference in zip(rows["feature"], rows["difference"]):
            assert difference == pytest.approx(means[list(table.columns).index(feature)], abs=1e-6)
        assert (np.diff(np.abs(rows["difference"])) <= 1e-12).all()
    each = som.differences(table)
    assert set(each["group"]) == set(winners)
    with pytest.raises(UsageError, match="groups"):
        som.differences(table, [0, 1])


def test_what_is_wrong_is_said(X):
    som = SOM(3, 3, iterations=100).fit(X)
    for wrong in ({"measures": ["trust"]}, {"neighbours": 0}, {"shuffles": -1}, {"ranked_samples": 2}):
        with pytest.raises(UsageError):
            som.measures(X, **wrong)
    with pytest.raises((DataError, ValueError)):
        som.measures(X[:, :3])


def test_the_program_gives_the_same(X, labels, tmp_path, somato):
    np.savetxt(tmp_path / "x.csv", X, delimiter=",")
    np.savetxt(tmp_path / "y.txt", labels, fmt="%s")
    som = SOM(3, 4, iterations=300).fit(X, labels)
    som.save(tmp_path / "map.somato")
    words = ("som", "quality", tmp_path / "map.somato", tmp_path / "x.csv", "--labels", tmp_path / "y.txt",
             "--measures", "all", "--shuffles", 1, "--json")
    printed = json.loads(somato(*words))
    rows = np.loadtxt(tmp_path / "x.csv", delimiter=",")
    found = som.measures(rows, labels, shuffles=1)
    for name, value in found.items():
        assert printed[name] == value
        assert printed[f"shuffled_{name}"] == found.by_chance[name]
    assert [one["purity"] for one in printed["classes"]] == list(found.classes["purity"])
    assert [one["samples"] for one in printed["of_neurons"]] == list(found.neurons["samples"])
