"""Contributions of columns and sensors, compared with NumPy."""

import numpy as np
import pytest

from pysomato import SOM, Recording, System, UsageError

KINDS = ["euclidean", "manhattan", "cosine", "chebyshev", "dot_product"]


def problem(similarity, seed=3, **settings):
    random = np.random.default_rng(seed)
    X = random.normal(size=(60, 5)).astype(np.float32) + np.repeat(np.arange(3), 20)[:, None].astype(np.float32)
    y = np.repeat(["a", "b", "c"], 20)
    som = SOM(4, 4, similarity=similarity, iterations=300, random_state=seed, **settings).fit(X, y)
    return som, X, y


def compared(similarity, x, w):
    """The distance of x from w, or the negative inner product."""
    x, w = x.astype(float), w.astype(float)
    if similarity == "euclidean":
        return np.sqrt(((x - w) ** 2).sum())
    if similarity == "manhattan":
        return np.abs(x - w).sum()
    if similarity == "chebyshev":
        return np.abs(x - w).max()
    if similarity == "cosine":
        return 1 - x @ w / np.sqrt((x @ x) * (w @ w))
    return -(x @ w)


@pytest.mark.parametrize("similarity", KINDS)
def test_they_sum_to_the_difference_of_the_two_distances(similarity):
    som, X, _ = problem(similarity, normalize_input=False)
    found = som.contributions(X)
    labels = np.array(som.map_.neuron_labels, dtype=object)
    assert found.values.shape == X.shape
    named = [n for n, label in enumerate(labels) if label is not None]
    for i, x in enumerate(X):
        away = {n: compared(similarity, x, som.weights_[n]) for n in named}
        nearest = min(away, key=away.get)
        other = min((n for n in named if labels[n] != labels[nearest]), key=away.get)
        assert tuple(found.neurons[i]) == (nearest, other)
        sign = -1 if similarity == "dot_product" else 1
        np.testing.assert_allclose(found.distances[i], [sign * away[nearest], sign * away[other]], rtol=1e-6)
        assert found.values[i].sum() == pytest.approx(away[other] - away[nearest], abs=1e-9)
    np.testing.assert_array_equal(labels[found.neurons[:, 0]], som.classify(X))


def test_each_is_the_difference_of_squares_in_proportion():
    som, X, _ = problem("euclidean")
    found = som.contributions(X)
    a, b = (som.weights_[found.neurons[:, k]].astype(float) for k in (0, 1))
    expected = ((X - b) ** 2 - (X - a) ** 2) / found.distances.sum(axis=1, keepdims=True)
    np.testing.assert_allclose(found.values, expected, atol=1e-9)


@pytest.mark.parametrize("missing", ["mean", "nearest", "leave_out"])
def test_missing_values_contribute_nothing(missing):
    som, X, _ = problem("euclidean", missing=missing)
    if missing == "mean":
        known = X.copy()
        known[7, 1] = np.nan  # so that the map knows the means
        som.fit(known, np.repeat(["a", "b", "c"], 20))
    X = X.copy()
    X[::4, 2] = np.nan
    found = som.contributions(X)
    np.testing.assert_array_equal(found.values[::4, 2], 0)
    a, b = (som.weights_[found.neurons[:, k]].astype(float) for k in (0, 1))
    away = [np.sqrt(np.nansum((X - w) ** 2, axis=1)) for w in (a, b)]
    np.testing.assert_allclose(found.values.sum(axis=1), away[1] - away[0], atol=1e-9)
    labels = np.array(som.map_.neuron_labels, dtype=object)
    np.testing.assert_array_equal(labels[found.neurons[:, 0]], som.classify(X))


def test_a_constant_column_contributes_nothing_and_permuted_columns_permute_them():
    random = np.random.default_rng(5)
    X = random.normal(size=(30, 4)).astype(np.float32)
    X[:, 1] = 7.5
    y = np.repeat([0, 1, 2], 10)
    som = SOM(3, 3, iterations=200, arithmetic="plain").fit(X, y)
    found = som.contributions(X)
    np.testing.assert_allclose(found.values[:, 1], 0, atol=1e-10)  # the trained weights are rounded
    order = [2, 0, 3, 1]
    weights = som.weights_[:, order]
    turned = SOM.from_weights(weights, rows=3)
    turned.map_ = turned.map_.labelled(["0", "1", "2"], som.winners_, y.astype(np.int64))
    turned.classes_ = som.classes_
    np.testing.assert_allclose(turned.contributions(X[:, order]).values, found.values[:, order], atol=1e-12)


def test_labels_of_two_kinds_are_needed():
    som, X, _ = problem("euclidean")
    with pytest.raises(UsageError, match="no labels"):
        SOM(2, 2, iterations=10).fit(X).contributions(X)
    with pytest.raises(UsageError, match="two labels"):
        SOM(2, 2, iterations=10).fit(X, ["a"] * len(X)).contributions(X)


STUDY = """
[study]
name = "grasps"
label = "object"
seeds = 1
[module.joints]
type = "channel"
channel = "joints"
[module.touch]
type = "channel"
channel = "touch"
[module.crossed]
type = "tensor_product"
inputs = ["joints", "touch"]
[module.memory]
type = "accumulate"
input = "crossed"
[module.map]
type = "som"
input = "memory"
rows = 3
columns = 4
iterations = 300
"""


def test_those_of_a_system_are_traced_to_its_channels(tmp_path):
    random = np.random.default_rng(11)
    kinds = [["ball", "cube", "cone"][i % 3] for i in range(9)]
    recording = Recording.from_arrays({"object": kinds},
                                      {"joints": [random.random((4, 2)) + i % 3 for i in range(9)],
                                       "touch": [random.random((4, 3)) for i in range(9)]})
    (tmp_path / "study.toml").write_text(STUDY)
    trained = System(tmp_path / "study.toml").fit(recording)
    found = trained.contributions(recording)
    answers = trained.answers(recording)
    assert list(found.columns) == ["exploration", "nearest", "other", "distance", "other_distance",
                                   "channel", "element", "contribution"]
    assert found.attrs["unit"] == ""
    assert len(found) == 9 * 5
    for number, rows in found.groupby("exploration"):
        first = rows.iloc[0]
        assert first.nearest == answers.nearest[number] != first.other
        assert rows.contribution.sum() == pytest.approx(first.other_distance - first.distance, abs=1e-9)
        # Equal shares of the factors of a product.
        of_channel = rows.groupby("channel").contribution.sum()
        assert of_channel["joints"] == pytest.approx(of_channel["touch"], abs=1e-9)
