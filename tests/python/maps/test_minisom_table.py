"""The table 'Coming from MiniSom' of docs/python.md: its code runs, and it names the whole interface."""

import os
import pickle
import re
from pathlib import Path

import numpy as np
import pytest

from pysomato import SOM, SOMClassifier

_PAGE = Path(__file__).parents[3] / "docs" / "python.md"

# The public interface of MiniSom 2.3, and the arguments of its methods with a choice.
_INTERFACE = """MiniSom sigma learning_rate random_seed topology neighborhood_function activation_distance
decay_function sigma_decay_function random_weights_init train train_batch train_random use_epochs
fixed_points random_order verbose train_batch_offline update winner activate quantization
quantization_error topographic_error distance_map scaling activation_response win_map return_indices
labels_map distortion_measure pca_weights_init get_weights get_euclidean_coordinates convert_map_to_euclidean pickle""".split()


def rows():
    section = _PAGE.read_text().split("## Coming from MiniSom")[1].split("\n## ")[0]
    lines = [line for line in section.splitlines() if line.startswith("| ")][1:]
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    return [row for row in cells if row[0].strip("-")]


def snippets(cell):
    return re.findall(r"`([^`]+)`", cell)


@pytest.fixture(scope="module")
def names():
    random = np.random.default_rng(1)
    X = random.normal(size=(60, 3)) + 4 * (np.arange(60) % 3)[:, None]
    y = np.array(["a", "b", "c"])[np.arange(60) % 3]
    som = SOM(6, 6, iterations=200).fit(X, y)
    return {"SOM": SOM, "SOMClassifier": SOMClassifier, "np": np, "pickle": pickle, "som": som, "X": X,
            "x": X[0], "y": y}


@pytest.mark.parametrize("row", rows(), ids=lambda row: row[0][:40])
def test_the_equivalent_runs_or_a_reason_is_given(row, names, tmp_path, capfd):
    _, ours, difference = row
    code = snippets(ours)
    assert code or len(difference) > 20  # the reason
    before = os.getcwd()
    os.chdir(tmp_path)
    try:
        for snippet in code:
            eval(snippet, dict(names))
    finally:
        os.chdir(before)


def test_the_table_names_the_whole_interface():
    first = " ".join(row[0] for row in rows())
    assert [name for name in _INTERFACE if not re.search(rf"\b{name}\b", first)] == []
    assert len(rows()) > 25


def test_the_page_of_behaviours_names_tests_that_exist():
    page = (_PAGE.parent / "som-behaviours.md").read_text()
    written = "".join(path.read_text() for path in Path(__file__).parents[1].rglob("test_*.py"))
    named = set(re.findall(r"`(test_\w+)`", page))
    assert [name for name in named if f"def {name}(" not in written] == []
    behaviours = Path(__file__).with_name("test_minisom_behaviours.py").read_text()
    assert set(re.findall(r"^def (test_\w+)\(", behaviours, re.MULTILINE)) - named == set()


def test_the_equivalents_of_results_have_their_values(names):
    som, X, y = names["som"], names["X"], names["y"]
    weights = som.weights_.reshape(6, 6, -1)
    for index, x in enumerate(X[:5]):
        activation = np.linalg.norm(x - weights, axis=2)
        row, column = np.unravel_index(activation.argmin(), (6, 6))
        assert divmod(int(som.predict([x])[0]), som.columns) == (row, column)
        np.testing.assert_allclose(som.distances([x])[0].reshape(6, 6), activation, rtol=1e-5)
        np.testing.assert_array_equal(som.quantize([x])[0], weights[row, column])
        assert index in som.samples_of_neurons(X)[row * 6 + column]
    labels, counts = som.class_counts(X, y)
    np.testing.assert_array_equal(counts.sum(axis=1).reshape(6, 6), som.hits_.reshape(6, 6))
    assert counts.sum(axis=0).tolist() == [20, 20, 20] and labels.tolist() == ["a", "b", "c"]
