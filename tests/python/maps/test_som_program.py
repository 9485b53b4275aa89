"""The estimator SOM and the program 'somato som' give the same bits."""

import io

import numpy as np
import pytest

from pysomato import SOM

SETTINGS = {
    "online": {"rows": 5, "columns": 6, "iterations": 500},
    "batch": {"rows": 4, "columns": 4, "training": "batch", "epochs": 7},
    "hexagonal": {"rows": 4, "columns": 5, "lattice": "hexagonal", "topology": "torus",
                  "similarity": "dot_product", "softmax": "exponential", "seed": 12},
    "automatic": {"rows": None, "columns": None, "draws": "without_replacement"},
}


def flags_of(settings):
    flags = []
    for name, value in settings.items():
        flags += ["--" + name.replace("_", "-"), "automatic" if value is None else value]
    return flags


def train_with(somato, folder, rows, settings, labels=None):
    """Trains with the program; returns the paths of the data and of the map."""
    np.save(folder / "rows.npy", rows)
    flags = flags_of(settings)
    if labels is not None:
        (folder / "labels.txt").write_text("".join(f"{label}\n" for label in labels))
        flags += ["--labels", folder / "labels.txt"]
    somato("som", "train", folder / "rows.npy", "-o", folder / "map.somato", *flags)
    return folder / "rows.npy", folder / "map.somato"


@pytest.mark.parametrize("settings", SETTINGS.values(), ids=SETTINGS)
def test_fit_gives_the_model_file_of_the_program(somato, tmp_path, X, settings):
    _, path = train_with(somato, tmp_path, X, settings)
    SOM(**settings).fit(X).save(tmp_path / "mine.somato")
    assert (tmp_path / "mine.somato").read_bytes() == path.read_bytes()


def test_labels_name_the_neurons_as_in_the_program(somato, tmp_path, X, labels):
    settings = SETTINGS["online"]
    _, path = train_with(somato, tmp_path, X, settings, labels)
    SOM(**settings).fit(X, labels).save(tmp_path / "mine.somato")
    assert (tmp_path / "mine.somato").read_bytes() == path.read_bytes()


def test_few_samples_of_many_columns_are_trained_by_inner_products_as_in_the_program(somato, tmp_path):
    rows = np.random.default_rng(3).normal(size=(12, 300)).astype(np.float32)
    _, path = train_with(somato, tmp_path, rows, {"rows": 6, "columns": 6})
    som = SOM(6, 6).fit(rows)
    rows[:] = 0  # the map does not refer to the rows
    som.save(tmp_path / "mine.somato")
    assert (tmp_path / "mine.somato").read_bytes() == path.read_bytes()


def test_float64_in_fortran_order_is_the_same_map(X):
    som = SOM(4, 4, iterations=200)
    expected = som.fit(X).weights_
    np.testing.assert_array_equal(som.fit(np.asfortranarray(X, dtype=np.float64)).weights_, expected)


def test_predict_transform_and_classify_are_som_map(somato, tmp_path, X, labels):
    data, path = train_with(somato, tmp_path, X, SETTINGS["online"], labels)
    printed = somato("som", "map", path, data, "--activity", tmp_path / "activity.npy")
    table = np.genfromtxt(io.StringIO(printed), delimiter=",", names=True, dtype=None, encoding="utf-8")
    som = SOM.load(path)
    np.testing.assert_array_equal(som.predict(X), table["winner"])
    np.testing.assert_array_equal(som.classify(X), table["label"])
    np.testing.assert_array_equal(som.transform(X), np.load(tmp_path / "activity.npy"))


def test_a_standardized_map_of_the_program_standardizes(somato, tmp_path, X):
    np.save(tmp_path / "rows.npy", X)
    somato("som", "train", tmp_path / "rows.npy", "-o", tmp_path / "map.somato", "--standardize")
    printed = somato("som", "map", tmp_path / "map.somato", tmp_path / "rows.npy")
    winners = [int(line.split(",")[1]) for line in printed.splitlines()[1:]]
    np.testing.assert_array_equal(SOM.load(tmp_path / "map.somato").predict(X), winners)


def test_the_number_of_threads_changes_no_bit(X):
    rows = np.tile(X, (20, 3))
    for settings in SETTINGS.values():
        one, three = (SOM(**settings, threads=threads).fit(rows) for threads in (1, 3))
        np.testing.assert_array_equal(one.weights_, three.weights_)
        np.testing.assert_array_equal(one.transform(rows), three.transform(rows))
