"""Refinement of maps by labels: estimators, program and studies."""

import json
import os
import pickle
import subprocess

import numpy as np
import pytest
from sklearn.base import clone

import pysomato
from pysomato import SOM, DataError, Recording, SOMClassifier, SOMClusterer, UsageError, study

TWO_CLASSES = {"rows": 5, "columns": 5, "iterations": 1000}

SETTINGS = 'protocols = ["k_folds"]\nseeds = 1'

@pytest.fixture
def stripes():
    """Rows of two classes that alternate along the first of two columns, which is less wide."""
    random = np.random.default_rng(5)
    group = np.arange(300) % 4
    X = np.stack([group + 0.2 * random.normal(size=300), 3 * random.normal(size=300)], axis=1)
    return X.astype(np.float32), np.array(["soft", "hard"])[group % 2]


@pytest.fixture
def recording():
    random = np.random.default_rng(11)
    joints = [random.normal(size=(4, 3)) + [0, 0, 1.5 * (i % 2)] for i in range(40)]
    return Recording.from_arrays({"object": [["ball", "cube"][i % 2] for i in range(40)]},
                                 {"joints": joints}, rates={"joints": 10})


def measured_order(weights, X, columns):
    """The quantization error and the topographic error of a rectangular map."""
    distances = np.linalg.norm(X[:, None].astype(float) - weights[None].astype(float), axis=2)
    best = np.argsort(distances, axis=1)[:, :2]
    steps = np.abs(best // columns - (best // columns)[:, ::-1]) + np.abs(
        best % columns - (best % columns)[:, ::-1])
    return distances.min(axis=1).mean(), np.mean(steps[:, 0] != 1)


@pytest.mark.parametrize("similarity", ["euclidean", "manhattan"])
def test_more_rows_are_recognized_also_new_ones(stripes, similarity):
    X, y = stripes
    plain = SOM(**TWO_CLASSES, similarity=similarity).fit(X[:150], y[:150])
    refined = SOM(**TWO_CLASSES, similarity=similarity, refine="glvq").fit(X[:150], y[:150])
    assert refined.score(X[:150], y[:150]) > plain.score(X[:150], y[:150]) + 0.05
    assert refined.score(X[150:], y[150:]) > plain.score(X[150:], y[150:]) + 0.05


def test_the_order_before_and_after_is_that_of_the_maps(stripes):
    X, y = stripes
    plain = SOM(**TWO_CLASSES).fit(X, y)
    assert not hasattr(plain, "refinement_")
    refined = SOM(**TWO_CLASSES, refine="glvq").fit(X, y)
    for som, order in [(plain, "before"), (refined, "after")]:
        found = refined.refinement_[order]
        error, topographic = measured_order(som.weights_, X, 5)
        assert found["quantization_error"] == pytest.approx(error, rel=1e-6)
        assert found["topographic_error"] == pytest.approx(topographic, abs=1e-12)
        measures = som.measures(X)
        assert found["trustworthiness"] == pytest.approx(measures["trustworthiness"], rel=1e-12)
        assert found["continuity"] == pytest.approx(measures["continuity"], rel=1e-12)
    assert refined.topographic_error_ == refined.refinement_["after"]["topographic_error"]
    assert refined.fit(X, y).set_params(refine="none").fit(X, y).weights_.tolist() == plain.weights_.tolist()
    assert not hasattr(refined, "refinement_")


def test_threads_and_seeds(stripes):
    X, y = stripes
    fitted = [SOM(**TWO_CLASSES, refine="glvq", **more).fit(X, y).weights_
              for more in ({"threads": 1}, {"threads": 3}, {"random_state": 2})]
    np.testing.assert_array_equal(fitted[0], fitted[1])
    assert (fitted[0] != fitted[2]).any()


def test_the_unit_of_the_data_has_no_effect(stripes):
    X, y = stripes
    small = SOM(**TWO_CLASSES, refine="glvq").fit(X, y)
    large = SOM(**TWO_CLASSES, refine="glvq").fit(X * np.float32(1024), y)
    np.testing.assert_array_equal(large.weights_, small.weights_ * np.float32(1024))


@pytest.mark.parametrize("more", [{}, {"lattice": "hexagonal", "topology": "torus", "rows": 6},
                                  {"similarity": "manhattan", "training": "batch", "iterations": None},
                                  {"normalize_input": True},
                                  {"refine_passes": 3, "refine_neighbours": 0.0,
                                   "refine_learning_rate": 0.3, "refine_steepness_start": 1.0,
                                   "refine_steepness_end": 9.0},
                                  {"refine": "grlvq"},
                                  {"refine": "grlvq", "refine_relevance_rate": 0.2, "similarity": "manhattan"}],
                         ids=["plain", "hexagonal", "batch", "normalized", "parameters", "relevances",
                              "relevances of manhattan"])
def test_the_program_refines_to_the_same_model(somato, tmp_path, stripes, more):
    X, y = stripes
    settings = {name: value for name, value in {**TWO_CLASSES, "refine": "glvq", **more}.items()
                if value is not None}
    np.save(tmp_path / "rows.npy", X)
    (tmp_path / "labels.txt").write_text("".join(f"{label}\n" for label in y))
    flags = [part for name, value in settings.items()
             for part in ("--" + name.replace("_", "-"), str(value).lower())]
    text = somato("som", "train", tmp_path / "rows.npy", "--labels", tmp_path / "labels.txt",
                  "-o", tmp_path / "map.somato", *flags)
    mine = SOM(**settings).fit(X, y)
    mine.save(tmp_path / "mine.somato")
    assert (tmp_path / "mine.somato").read_bytes() == (tmp_path / "map.somato").read_bytes()
    printed = dict(line.split() for line in text.splitlines() if len(line.split()) == 2)
    for name in ("quantization_error", "topographic_error", "trustworthiness", "continuity"):
        for prefix, when in (("unrefined_", "before"), ("refined_", "after")):
            assert float(printed[prefix + name]) == pytest.approx(mine.refinement_[when][name], rel=1e-5)
    loaded = SOM.load(tmp_path / "map.somato")
    np.testing.assert_array_equal(loaded.weights_, mine.weights_)
    assert loaded.score(X, y) == mine.score(X, y)


def weighted_distances(som, X):
    """By the definition of relevances, in the unit of the rows."""
    apart = np.abs(X[:, None].astype(float) - som.weights_[None].astype(float))
    if som.similarity == "manhattan":
        return (som.relevances_ * apart).sum(axis=2)
    return np.sqrt((som.relevances_ * apart**2).sum(axis=2))


@pytest.mark.parametrize("similarity", ["euclidean", "manhattan"])
def test_relevances_weigh_the_distance_everywhere(stripes, tmp_path, similarity):
    X, y = stripes
    X = np.column_stack([X, np.full(len(X), 7.0)]).astype(np.float32)
    som = SOM(**TWO_CLASSES, similarity=similarity, refine="grlvq").fit(X[:200], y[:200])
    assert som.relevances_.shape == (3,)
    assert som.relevances_.mean() == pytest.approx(1)
    assert som.relevances_[0] > 1.2 * som.relevances_[1] > 0
    distances = weighted_distances(som, X)
    nearest = np.sort(distances, axis=1)
    clear = nearest[:, 1] - nearest[:, 0] > 1e-4
    assert clear.sum() > 250
    np.testing.assert_array_equal(som.predict(X)[clear], distances.argmin(axis=1)[clear])
    assert som.quantization_error_ == pytest.approx(nearest[:200, 0].mean(), rel=1e-5)
    np.testing.assert_allclose(som.distances(X), distances, rtol=1e-4, atol=1e-4)
    np.testing.assert_array_equal(som.quantize(X), som.weights_[som.predict(X)])
    for name in ("map.somato", "map.npz"):
        som.save(tmp_path / name) if name == "map.somato" else som.export(tmp_path / name)
        loaded = SOM.load(tmp_path / name)
        np.testing.assert_array_equal(loaded.relevances_, som.relevances_)
        np.testing.assert_array_equal(loaded.weights_, som.weights_)
        np.testing.assert_array_equal(loaded.predict(X), som.predict(X))
        with pytest.raises(UsageError, match="relevances"):
            loaded.partial_fit(X)
    copy = pickle.loads(pickle.dumps(som))
    np.testing.assert_array_equal(copy.relevances_, som.relevances_)
    with np.load(tmp_path / "map.npz") as archive:
        scales = archive["relevances"] if similarity == "manhattan" else np.sqrt(archive["relevances"])
        np.testing.assert_allclose(archive["weights"].reshape(25, 3) / scales, som.weights_, rtol=1e-5, atol=1e-6)


def test_maps_without_relevances_have_none(stripes):
    X, y = stripes
    for refine in ("none", "glvq"):
        som = SOM(**TWO_CLASSES, refine=refine).fit(X, y)
        assert not hasattr(som, "relevances_")
    still = SOM(**TWO_CLASSES, refine="grlvq", refine_relevance_rate=0.0).fit(X, y)
    np.testing.assert_array_equal(still.relevances_, [1, 1])
    np.testing.assert_array_equal(still.weights_, som.weights_)


def test_relevances_do_not_depend_on_the_unit_or_on_threads(stripes):
    X, y = stripes
    small = SOM(**TWO_CLASSES, refine="grlvq", threads=1).fit(X, y)
    large = SOM(**TWO_CLASSES, refine="grlvq", threads=3).fit(X * np.float32(1024), y)
    np.testing.assert_array_equal(large.relevances_, small.relevances_)
    np.testing.assert_array_equal(large.weights_, small.weights_ * np.float32(1024))


def test_missing_values_are_left_out_with_relevances(stripes):
    X, y = stripes
    X = X.copy()
    X[::7, 1] = np.nan
    som = SOM(**TWO_CLASSES, refine="grlvq", missing="leave_out").fit(X, y)
    assert som.score(X, y) > SOM(**TWO_CLASSES, missing="leave_out").fit(X, y).score(X, y)
    assert np.isfinite(som.weights_).all()


def test_missing_values_are_left_out(stripes):
    X, y = stripes
    X = X.copy()
    X[::7, 1] = np.nan
    som = SOM(**TWO_CLASSES, refine="glvq", missing="leave_out").fit(X, y)
    assert som.score(X, y) > SOM(**TWO_CLASSES, missing="leave_out").fit(X, y).score(X, y)
    # Rows of which the second column is never known say nothing about it.
    X[:, 1] = 0
    X[0, 1] = 1
    X[1:, 1] = np.nan
    for refine in ("none", "glvq"):
        assert np.isfinite(SOM(**TWO_CLASSES, refine=refine, missing="leave_out").fit(X, y).weights_).all()


def test_rows_without_a_label_are_not_learned_from(stripes):
    X, y = stripes
    y = np.where(np.arange(300) < 200, y, None)
    assert SOM(**TWO_CLASSES, refine="glvq").fit(X, y).score(X, y) > 0.8


def test_estimators(stripes):
    X, y = stripes
    classifier = SOMClassifier(**TWO_CLASSES, refine="glvq").fit(X, y)
    assert clone(classifier).refine == "glvq"
    assert (classifier.predict(X) == y).mean() == classifier.score(X, y) > 0.85
    with pytest.raises(UsageError, match="labels"):
        SOMClusterer(refine="glvq").fit(X, y)


@pytest.mark.parametrize("parameters, message", [
    ({"refine": "glvq", "similarity": "cosine"}, "'cosine' cannot be refined"),
    ({"refine": "glvq", "similarity": "dot_product"}, "'dot_product' cannot be refined"),
    ({"refine": "glvq", "layers": {"a": 1, "b": 1}}, "layers"),
    ({"refine": "glvq", "refine_learning_rate": 0.6}, "refine_learning_rate"),
    ({"refine": "glvq", "refine_passes": 0}, "refine_passes"),
    ({"refine": "lvq"}, "glvq"),
    ({"refine_passes": 5}, "has no effect, because refine is none"),
    ({"refine": "glvq", "refine_relevance_rate": 0.1}, "has no effect, because refine is glvq"),
    ({"refine": "grlvq", "similarity": "cosine"}, "a step of grlvq"),
])
def test_what_is_refused(stripes, parameters, message):
    X, y = stripes
    with pytest.raises(UsageError, match=message):
        SOM(3, 3, **parameters).fit(X, y)


def test_labels_that_are_refused(stripes):
    X, y = stripes
    with pytest.raises(UsageError, match="there are none"):
        SOM(3, 3, refine="glvq").fit(X)
    for same in (["one"] * 300, [None] * 300):
        with pytest.raises(DataError, match="at least two classes"):
            SOM(3, 3, refine="glvq").fit(X, same)
    with pytest.raises(UsageError, match="without labels"):
        SOM(3, 3, refine="glvq").partial_fit(X, y)


@pytest.mark.parametrize("flags, message", [
    (["--refine", "glvq"], "needs the labels"),
    (["--refine-passes", 3], "refine is none"),
    (["--refine", "glvq", "--similarity", "chebyshev"], "cannot be refined"),
])
def test_the_program_refuses(tmp_path, stripes, flags, message):
    np.save(tmp_path / "rows.npy", stripes[0])
    words = ["som", "train", tmp_path / "rows.npy", "-o", tmp_path / "map", *flags]
    done = subprocess.run([os.environ["SOMATO_PROGRAM"], *map(str, words)], check=False,
                          capture_output=True, text=True)
    assert done.returncode == 2
    assert message in done.stderr
    assert not (tmp_path / "map").exists()


def test_a_study_states_the_order_before_and_after(recording, tmp_path, study_text):
    text, metrics = study_text(SETTINGS), {}
    for refine in ("none", "glvq", "grlvq"):
        path = tmp_path / f"{refine}.toml"
        path.write_text(text if refine == "none" else text + f'refine = "{refine}"\n')
        outcome = study(recording, path)
        protocol = outcome.results["parts"][0]["protocols"][0]
        metrics[refine] = {name: one["mean"] for name, one in protocol["metrics"].items()}
    refined = metrics["glvq"]
    assert not any("refined" in name for name in metrics["none"])
    for name in ("topographic_error", "trustworthiness", "continuity"):
        assert 0 <= refined[f"unrefined_{name}"] <= 1
        assert 0 <= refined[f"refined_{name}"] <= 1
    assert refined["accuracy"] > metrics["none"]["accuracy"]


@pytest.mark.parametrize("line, message", [
    ('refine = "glvq"\nsimilarity = "cosine"\n', "cannot be refined"),
    ("refine_passes = 4\n", "has no effect, because refine is none"),
    ('refine = "gvlq"\n', "glvq"),
    ('refin = "glvq"\n', "refine"),
])
def test_a_study_refuses(recording, tmp_path, study_text, line, message):
    path = tmp_path / "study.toml"
    path.write_text(study_text(SETTINGS) + line)
    with pytest.raises(UsageError, match=message):
        study(recording, path)


def test_the_parameters_are_those_of_the_library():
    declared = pysomato._somato.refinement_parameters()
    for one in declared:
        default = SOM().get_params()[one["name"]]
        assert json.dumps(default) == one["default"] or float(default) == float(one["default"])
