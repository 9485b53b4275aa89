"""Layers of a map against their definition in numpy."""

import pickle

import numpy as np
import pytest

import pysomato
from pysomato import SOM, DataError, UsageError


def layered_distances(X, weights, layers):
    """The sum of the layers' distances, as kohonen's supersom but for distances that are not squared."""
    total = np.zeros((len(X), len(weights)))
    first = 0
    for count, distance, weight, scale in layers:
        x, w = X[:, first:first + count], weights[:, first:first + count]
        apart = np.abs(x[:, None] - w)
        lengths = np.linalg.norm(x, axis=1)[:, None] * np.linalg.norm(w, axis=1)
        d = {"euclidean": lambda: np.sqrt((apart ** 2).sum(axis=2)),
             "manhattan": lambda: apart.sum(axis=2),
             "chebyshev": lambda: apart.max(axis=2),
             "cosine": lambda: 1 - np.divide(x @ w.T, lengths, out=np.zeros(lengths.shape),
                                             where=lengths > 0)}[distance]()
        total += weight * d / scale
        first += count
    return total


def supersom(X, weights, layers, radii):
    """Batch training in loops on a row of neurons."""
    neurons = np.arange(len(weights))
    for radius in radii:
        gains = np.exp(-(neurons[:, None] - neurons) ** 2 / (2 * radius ** 2))
        to_neurons = gains[layered_distances(X, weights, layers).argmin(axis=1)]
        weights = to_neurons.T @ X / to_neurons.sum(axis=0)[:, None]
    return weights


@pytest.fixture
def data():
    """Measurements of (90, 5) around three centres, and the one-hot class of each."""
    random = np.random.default_rng(4)
    classes = np.arange(90) % 3
    X = random.normal(size=(3, 5))[classes] * 3 + random.normal(size=(90, 5))
    return np.hstack([X, np.eye(3)[classes]]).astype(np.float32).astype(np.float64)


LAYERS = {"shape": (2, "euclidean", 0.7), "touch": (3, "manhattan"), "kind": (3, "cosine", 2.0)}


def scaled(data, layers):
    """The layers with the mean distance of all pairs of samples as scale."""
    found, first = [], 0
    for count, distance, weight in ((*how, *("euclidean", 1.0)[len(how) - 1:])
                                    for how in layers.values()):
        columns = data[:, first:first + count]
        distances = layered_distances(columns, columns, [(count, distance, 1.0, 1.0)])
        found.append((count, distance, weight, distances[np.triu_indices(len(data), 1)].mean()))
        first += count
    return found


def test_training_is_that_of_a_super_organized_map(data):
    settings = {"layers": LAYERS, "training": "batch", "radius_start": 1.2, "radius_end": 1.2}
    layers = scaled(data, LAYERS)
    initial = SOM(1, 8, epochs=0, **settings).fit(data).weights_.astype(np.float64)
    som = SOM(1, 8, epochs=5, **settings).fit(data)
    np.testing.assert_allclose([scale for *_, scale in som.map_.layers],
                               [scale for *_, scale in layers], rtol=1e-6)
    np.testing.assert_allclose(som.weights_, supersom(data, initial, layers, [1.2] * 5), atol=1e-5)
    distances = layered_distances(data, som.weights_.astype(np.float64), layers)
    np.testing.assert_array_equal(som.predict(data), distances.argmin(axis=1))
    assert som.quantization_error_ == pytest.approx(distances.min(axis=1).mean(), rel=1e-5)


def test_a_layer_is_predicted_from_the_others(data):
    som = SOM(4, 4, layers=LAYERS, iterations=2000).fit(data)
    layers = scaled(data, LAYERS)
    weights = som.weights_.astype(np.float64)
    winners = layered_distances(data[:, :5], weights[:, :5], layers[:2]).argmin(axis=1)
    expected = som.weights_[winners, 5:]
    for X in (data, data[:, :5], np.hstack([data[:, :5], np.full((90, 3), 7.0)])):
        np.testing.assert_array_equal(som.predict_layer(X, "kind"), expected)
    assert (expected.argmax(axis=1) == np.arange(90) % 3).mean() > 0.8
    shape = som.predict_layer(data[:, 2:], "shape")
    assert shape.shape == (90, 2)
    with pytest.raises(pysomato.UsageError, match="no layer 'smell'"):
        som.predict_layer(data, "smell")


def test_frames_name_the_columns_of_layers(data):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(data, columns=list("abcdefgh"))
    by_name = {"shape": (["a", "b"], "euclidean", 0.7), "touch": (["c", "d", "e"], "manhattan"),
               "kind": (["f", "g", "h"], "cosine", 2.0)}
    som = SOM(3, 3, layers=by_name, iterations=300).fit(frame)
    other = SOM(3, 3, layers=LAYERS, iterations=300).fit(data)
    np.testing.assert_array_equal(som.weights_, other.weights_)
    np.testing.assert_array_equal(som.predict_layer(frame[list("abcde")], "kind"),
                                  other.predict_layer(data, "kind"))
    with pytest.raises(pysomato.UsageError, match="begins with the column 'b'"):
        SOM(3, 3, layers={"one": ["b", "a"], "two": 6}).fit(frame)


def test_layers_are_kept_by_files_and_pickles(data, tmp_path):
    som = SOM(3, 3, layers=LAYERS, iterations=300).fit(data)
    som.save(tmp_path / "layers.map")
    loaded = SOM.load(tmp_path / "layers.map")
    assert list(loaded.layers) == list(LAYERS)
    for other in (loaded, pickle.loads(pickle.dumps(som))):
        np.testing.assert_array_equal(other.predict_layer(data, "kind"), som.predict_layer(data, "kind"))
    np.testing.assert_array_equal(SOM(**loaded.get_params()).fit(data).weights_, som.weights_)


@pytest.mark.parametrize("layers, message", [
    ({"a": 3}, "the layers have 3 columns, and the data 8"),
    ({"a": 0, "b": 8}, "neither a number above 0 nor names"),
    ([3, 5], "layers are a dictionary"),
    ({"a": (8, "dot_product")}, "'dot_product' is not"),
    ({"a": (8, "chess")}, "chess"),
    ({"a": (8, "euclidean", "much")}, "no number"),
    ({"a": (8, "euclidean", -1.0)}, "above 0"),
    ({"a": (8, "euclidean", 1.0, 1.0, 1.0)}, "5 values"),
])
def test_layers_that_do_not_fit_are_refused(data, layers, message):
    with pytest.raises(pysomato.UsageError, match=message):
        SOM(3, 3, layers=layers).fit(data)


def test_what_is_predicted_does_not_look_at_its_own_columns(data):
    som = SOM(4, 4, layers=LAYERS, iterations=500).fit(data)
    name = list(LAYERS)[-1]
    first, count = som.map_.layer_columns(name)
    others = np.delete(data, np.s_[first:first + count], axis=1)
    unknown = data.copy()
    unknown[:, first:first + count] = np.nan
    expected = som.predict_layer(others, name)
    np.testing.assert_array_equal(som.predict_layer(unknown, name), expected)
    np.testing.assert_array_equal(som.predict_layer(data, name), expected)
    with pytest.raises(UsageError, match="only layer"):
        SOM(2, 2, layers={"all": data.shape[1]}).fit(data).predict_layer(data, "all")
    with pytest.raises(UsageError, match="no layer"):
        SOM(2, 2, layers={}).fit(data)


def test_nothing_is_predicted_from_nothing(data):
    layers = {"first": 2, "others": (data.shape[1] - 2, "manhattan")}
    som = SOM(4, 4, layers=layers, iterations=500, missing="leave_out").fit(data)
    unknown = data[:2].copy()
    unknown[1, 2:] = np.nan
    with pytest.raises(DataError, match="row 1 has no known value of another layer"):
        som.predict_layer(unknown, "first")
