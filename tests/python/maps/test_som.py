"""The estimator SOM against definitions in numpy, and its errors."""

import copy
import pickle
import xml.etree.ElementTree
from inspect import signature

import numpy as np
import pytest
from sklearn.base import clone

import pysomato
from pysomato import SOM, _somato


def value_of(text):
    """A default in TOML notation as a Python value."""
    if text in ("true", "false", '"automatic"'):
        return {"true": True, "false": False}.get(text)
    return text[1:-1] if text.startswith('"') else float(text)


def test_parameters_have_the_names_and_defaults_of_the_library():
    defaults = {name: parameter.default for name, parameter in signature(SOM).parameters.items()
                if name not in ("seed", "missing", "extra_columns", "unlabelled", "threads", "verbose",
                                "layers", "size") and not name.startswith("refine")}
    declared = _somato.som_parameters()
    defaults["seed"] = defaults.pop("random_state")  # its name in scikit-learn
    assert list(defaults) == [info["name"] for info in declared]
    for info in declared:
        default = defaults[info["name"]]
        if info["name"] == "arithmetic":  # whose choices include 'automatic'
            assert default == "automatic"
        else:
            assert default == value_of(info["default"]), info["name"]


def distances_to(weights, X):
    return np.linalg.norm(X[:, None, :].astype(np.float64) - weights[None].astype(np.float64), axis=2)


def test_winners_are_the_nearest_neurons(X):
    som = SOM(5, 4, iterations=300).fit(X)
    distances = distances_to(som.weights_, X)
    np.testing.assert_array_equal(som.predict(X), distances.argmin(axis=1))
    assert som.quantization_error_ == pytest.approx(distances.min(axis=1).mean(), rel=1e-12)
    assert som.score(X) == pytest.approx(-som.quantization_error_, rel=1e-12)
    np.testing.assert_array_equal(som.winners_, som.predict(X))
    np.testing.assert_array_equal(som.hits_, np.bincount(som.winners_, minlength=20))


def cosine_distances(X, weights):
    products = X @ weights.T
    lengths = np.linalg.norm(X, axis=1)[:, None] * np.linalg.norm(weights, axis=1)
    return 1 - np.divide(products, lengths, out=np.zeros_like(products), where=lengths > 0)


DISTANCES = {
    "euclidean": lambda X, weights: np.linalg.norm(X[:, None] - weights, axis=2),
    "manhattan": lambda X, weights: np.abs(X[:, None] - weights).sum(axis=2),
    "chebyshev": lambda X, weights: np.abs(X[:, None] - weights).max(axis=2),
    "cosine": cosine_distances,
}


@pytest.mark.parametrize("training", ["online", "batch"])
@pytest.mark.parametrize("similarity", DISTANCES)
def test_every_distance_is_that_of_numpy(X, similarity, training):
    parameters = {"iterations": 300} if training == "online" else {"epochs": 5}
    som = SOM(5, 4, similarity=similarity, training=training, **parameters).fit(X)
    rows, weights = X.astype(np.float64), som.weights_.astype(np.float64)
    distances = DISTANCES[similarity](rows, weights)
    np.testing.assert_array_equal(som.predict(X), distances.argmin(axis=1))
    assert som.quantization_error_ == pytest.approx(distances.min(axis=1).mean(), rel=1e-9)
    activity = (1 / (1 + distances)) ** 10
    np.testing.assert_allclose(som.transform(X), activity / activity.max(axis=1, keepdims=True),
                               rtol=1e-4)
    heights = SOM(1, 2, similarity=similarity, iterations=9).fit(X)
    between = DISTANCES[similarity](*np.split(heights.weights_.astype(np.float64), 2))[0, 0]
    np.testing.assert_allclose(heights.map_.u_matrix(), [[between, between]], rtol=1e-9)


def test_inner_products_are_refused_for_other_distances(X):
    for similarity in ("manhattan", "chebyshev", "cosine"):
        with pytest.raises(pysomato.UsageError, match=f"similarity '{similarity}'"):
            SOM(3, 3, similarity=similarity, arithmetic="inner_products").fit(X)


def test_activity_is_the_power_of_the_similarity(X):
    som = SOM(5, 4, iterations=300, softmax_exponent=3).fit(X)
    activity = (1 / (1 + distances_to(som.weights_, X))) ** 3
    expected = activity / activity.max(axis=1, keepdims=True)
    np.testing.assert_allclose(som.transform(X), expected, rtol=1e-5)


def test_u_matrix_is_the_mean_distance_of_neighbours(X):
    som = SOM(3, 2, iterations=100).fit(X)
    weights = som.weights_.astype(np.float64)
    between = np.linalg.norm(weights[:, None] - weights[None], axis=2)
    assert som.u_matrix().shape == (3, 2)
    assert som.u_matrix()[0, 0] == pytest.approx((between[0, 1] + between[0, 2]) / 2)
    assert som.u_matrix()[1, 1] == pytest.approx((between[3, 1] + between[3, 2] + between[3, 5]) / 3)


def test_partial_fit_follows_kohonens_rule(X):
    settings = {"initial_weights": "uniform", "iterations": 80, "radius_start": 2.0,
                "radius_end": 0.5, "learning_rate_start": 0.5, "learning_rate_end": 0.1}
    som = SOM(3, 4, **settings).partial_fit(X[:1])
    for start in range(1, len(X), 7):
        som.partial_fit(X[start:start + 7])
    weights = _somato.Map.initial({"rows": 3, "columns": 4, **settings}, _somato.SampleRows(X)).weights().astype(np.float64)
    places = np.array([(row, column) for row in range(3) for column in range(4)], np.float64)
    for step, x in enumerate(X):
        rate, radius = 0.5 - 0.4 * step / 80, 2.0 - 1.5 * step / 80
        winner = np.linalg.norm(weights - x, axis=1).argmin()
        squares = ((places - places[winner]) ** 2).sum(axis=1)
        weights += rate * np.exp(-squares / (2 * radius**2))[:, None] * (x - weights)
    assert som.samples_seen_ == len(X)
    np.testing.assert_allclose(som.weights_, weights, rtol=1e-4, atol=1e-5)


def test_partial_fit_after_fit_continues(X):
    som = SOM(3, 3, iterations=200).fit(X)
    assert som.samples_seen_ == 200
    before = som.map_
    som.partial_fit(X[:10])
    assert som.samples_seen_ == 210
    np.testing.assert_array_equal(som.weights_, before.learned(_somato.SampleRows(X[:10]), 1).weights())
    assert not hasattr(som, "winners_")


def copies_of(som, folder):
    som.save(folder / "map.somato")
    return {"kept": copy.deepcopy(som), "pickled": pickle.loads(pickle.dumps(som)),
            "saved": SOM.load(folder / "map.somato")}


@pytest.mark.parametrize("seen", [0, 30, 200, 230])
def test_a_saved_and_a_pickled_map_continue_where_they_were(X, tmp_path, seen):
    som = SOM(3, 3, iterations=200)
    if seen == 200:
        som.fit(X)
    else:
        som.partial_fit(X[:1])
        for start in range(1, seen, 29):
            som.partial_fit(X[:min(29, seen - start)])
    copies = copies_of(som, tmp_path)
    for name, other in copies.items():
        assert other.samples_seen_ == max(seen, 1), name
        other.partial_fit(X[:5])
    for other in copies.values():
        np.testing.assert_array_equal(other.weights_, copies["kept"].weights_)
        assert other.samples_seen_ == max(seen, 1) + 5


def test_known_samples_do_not_disturb_a_loaded_map(X, tmp_path):
    som = SOM(6, 6).fit(X)
    before = -som.score(X)
    for name, other in copies_of(som, tmp_path).items():
        assert -other.partial_fit(X[:5]).score(X) < 1.1 * before, name


def test_the_map_of_the_program_continues_at_the_end_of_its_schedule(somato, X, tmp_path):
    np.save(tmp_path / "rows.npy", X)
    somato("som", "train", tmp_path / "rows.npy", "--iterations", 300, "-o", tmp_path / "map.somato")
    assert SOM.load(tmp_path / "map.somato").samples_seen_ == 300


def test_a_map_trained_in_batches_counts_no_samples(X):
    assert not hasattr(SOM(3, 3, training="batch").fit(X), "samples_seen_")


def test_labels_keep_their_types_and_order(X):
    y = np.array([30, 10, 20, 40])[np.arange(60) % 4]
    som = SOM(6, 6, iterations=2000).fit(X, y)
    assert som.classes_.tolist() == [30, 10, 20, 40]
    assert som.score(X, y) == np.mean(som.classify(X) == y)
    assert som.score(X, y) > 0.9
    assert not hasattr(som.fit(X), "classes_")


def test_a_map_without_labels_says_so(X, labels):
    som = SOM(3, 3).fit(X)
    with pytest.raises(pysomato.UsageError, match="pass labels to fit as y"):
        som.classify(X)
    with pytest.raises(pysomato.UsageError, match="pass labels to fit as y"):
        som.score(X, labels)


@pytest.mark.parametrize("settings, message", [
    ({"rows": 0}, "rows"),
    ({"lattice": "hexagon"}, "did you mean 'hexagonal'"),
    ({"learning_rate_start": "fast"}, "learning_rate_start"),
    ({"seed": 1.5}, "seed"),
    ({"rows": object()}, r"SOM\(rows\): a value of type object"),
    ({"training": "batch", "iterations": 10}, "iterations"),
    ({"lattice": "hexagonal", "topology": "torus", "rows": 5}, "even"),
    ({"threads": 0}, r"SOM\(threads\)"),
])
def test_wrong_parameters_are_named(X, settings, message):
    with pytest.raises(pysomato.UsageError, match=message):
        SOM(**settings).fit(X)


def test_errors_have_parts_and_are_value_errors(X):
    with pytest.raises(ValueError) as caught:
        SOM(rows=0).fit(X)
    error = caught.value
    assert isinstance(error, pysomato.Error)
    assert error.what and error.where
    assert str(error).startswith(error.where)


def test_batch_maps_do_not_learn_one_by_one(X):
    with pytest.raises(pysomato.UsageError, match="online"):
        SOM(training="batch").partial_fit(X)


def test_rows_beyond_single_precision_are_refused(X):
    som = SOM(3, 3).fit(X)
    X[4] = 1e20
    with pytest.raises(pysomato.DataError, match="row 4"):
        som.predict(X)
    with pytest.raises(pysomato.DataError, match="too large"):
        som.fit(X)
    assert som.predict(X[:4]).shape == (4,)  # the earlier map is still there


def test_files_that_are_no_maps_are_refused(tmp_path):
    with pytest.raises(pysomato.OperatingSystemError, match="missing.somato"):
        SOM.load(tmp_path / "missing.somato")
    (tmp_path / "text.somato").write_text("not a map")
    with pytest.raises(pysomato.DataError, match="text.somato"):
        SOM.load(tmp_path / "text.somato")


def test_a_notebook_draws_the_map(X):
    som = SOM(3, 3)
    assert som._repr_svg_() is None
    assert "SOM" in som._repr_html_()  # the parameters
    picture = som.fit(X)._repr_mimebundle_()["image/svg+xml"]
    assert xml.etree.ElementTree.fromstring(picture).tag.endswith("svg")
    assert "U-matrix" in picture
    assert not hasattr(som, "_repr_html_")  # which a notebook would show instead
    assert ("Hits" in picture) != ("Hits" in som.partial_fit(X)._repr_svg_())


@pytest.mark.parametrize("similarity", ["euclidean", "dot_product"])
def test_many_rows_are_read_as_one_by_one(similarity):
    rng = np.random.default_rng(3)
    X = rng.normal(size=(300, 5)).astype(np.float32)
    names = np.array(["a", "b", None, None, None], dtype=object)[np.arange(300) % 5]
    som = SOM(12, 15, iterations=400, similarity=similarity, threads=3).fit(X, names)
    new = rng.normal(size=(200, 5)).astype(np.float32)
    single = som.set_params(threads=1)
    np.testing.assert_array_equal(som.classify(new), np.concatenate([single.classify(row[None]) for row in new]))
    np.testing.assert_array_equal(som.predict(new), np.concatenate([single.predict(row[None]) for row in new]))
    np.testing.assert_array_equal(som.transform(new), np.concatenate([single.transform(row[None]) for row in new]))


def test_the_label_is_that_of_the_nearest_neuron_with_one():
    rng = np.random.default_rng(4)
    X = rng.normal(size=(20, 4)).astype(np.float32)
    names = np.array([f"class {number % 4}" for number in range(20)])
    som = SOM(10, 12, iterations=300).fit(X, names)
    new = rng.normal(size=(150, 4)).astype(np.float32)
    votes = np.zeros((120, 4))
    np.add.at(votes, (som.winners_, np.arange(20) % 4), 1)
    named = np.flatnonzero(votes.any(axis=1))
    nearest = named[distances_to(som.weights_[named], new).argmin(axis=1)]
    expected = [f"class {votes[neuron].argmax()}" for neuron in nearest]
    assert (som.predict(new) != nearest).any()
    assert som.classify(new).tolist() == expected


@pytest.mark.parametrize("parameters", [{"training": "batch"}, {"radius_schedule": "constant"}])
def test_a_loaded_map_is_trained_again(parameters, tmp_path):
    X = np.random.default_rng(1).normal(size=(30, 2))
    SOM(3, 3, **parameters).fit(X).save(tmp_path / "map.somato")
    again = clone(SOM.load(tmp_path / "map.somato")).fit(X)
    np.testing.assert_array_equal(again.weights_, SOM.load(tmp_path / "map.somato").weights_)
