"""SOM(size="measured") against explicit parameters and the program."""

import numpy as np
import pytest
from sklearn.base import clone

from pysomato import SOM, SOMClassifier
from pysomato.errors import DataError, UsageError


@pytest.fixture
def rows():
    return np.random.default_rng(4).normal(size=(60, 3)).astype(np.float32)


def as_given(rows, columns, **more):
    """The parameters that docs/decisions/0040-automatic-size.md states for a measured size."""
    return SOM(rows, columns, initial_weights="linear", training="batch", epochs=100, tolerance=0.001,
               radius_schedule="exponential", radius_start=max(1.0, max(rows, columns) / 8), radius_end=0.2, **more)


def test_the_map_is_the_one_with_these_parameters(rows):
    measured = SOM(size="measured", similarity="manhattan").fit(rows)
    shape = measured.map_.parameters["rows"], measured.map_.parameters["columns"]
    assert shape == (7, 8)  # spread rows need as many neurons as rows
    np.testing.assert_array_equal(measured.weights_, as_given(*shape, similarity="manhattan").fit(rows).weights_)
    neurons, errors = zip(*measured.size_checks_)
    assert all(twice > once for once, twice in zip(neurons, neurons[1:])) and neurons[-1] <= 48
    assert list(errors) == sorted(errors, reverse=True)


def test_the_last_check_is_the_mean_distance_of_rows_that_were_held_out(rows):
    neurons, error = SOM(size="measured").fit(rows).size_checks_[-1]
    assert neurons == 48  # 6 x 8 of 48 rows
    distances = []
    for fold in range(5):  # each of so few rows is held out once, at random: other fifths are similar
        held_out = np.arange(len(rows)) % 5 == fold
        smaller = as_given(6, 8).set_params(epochs=20, tolerance=0.0).fit(rows[~held_out])
        apart = rows[held_out][:, None].astype(float) - smaller.weights_.reshape(1, 48, 3)
        distances.extend(np.linalg.norm(apart, axis=2).min(axis=1))
    assert error == pytest.approx(np.mean(distances), rel=0.2)


def test_rows_of_four_kinds_need_few_neurons():
    rows = np.repeat(np.float32([[0, 0], [0, 9], [9, 0], [9, 9]]), 50, axis=0)
    labels = np.repeat(["a", "b", "c", "d"], 50)
    som = clone(SOMClassifier(size="measured")).fit(rows, labels)
    assert len(som.positions_) <= 100
    assert som.score(rows, labels) == 1.0


def test_the_program_trains_the_same_map(somato, tmp_path, rows):
    np.save(tmp_path / "rows.npy", rows)
    somato("som", "train", tmp_path / "rows.npy", "-o", tmp_path / "map.somato", "--size", "measured")
    SOM(size="measured").fit(rows).save(tmp_path / "mine.somato")
    assert (tmp_path / "mine.somato").read_bytes() == (tmp_path / "map.somato").read_bytes()


@pytest.mark.parametrize("decided", [{"rows": 3}, {"columns": 3}, {"training": "batch"}, {"radius_end": 0.3},
                                     {"iterations": 9}, {"initial_weights": "samples"}, {"learning_rate_end": 0.1}],
                         ids=lambda decided: next(iter(decided)))
def test_what_it_decides_cannot_be_given(rows, decided):
    with pytest.raises(UsageError, match=f"{next(iter(decided))}.*the size is measured"):
        SOM(size="measured", **decided).fit(rows)


def test_what_cannot_be_measured_is_refused(rows):
    with pytest.raises(UsageError, match="by_number, measured"):
        SOM(size="large").fit(rows)
    with pytest.raises(UsageError, match="partial_fit"):
        SOM(size="measured").partial_fit(rows)
    rows[3, 1] = np.nan
    with pytest.raises(DataError, match="complete"):
        SOM(size="measured", missing="leave_out").fit(rows)
    assert SOM(size="measured", missing="mean").fit(rows).size_checks_
    assert not hasattr(SOM(3, 3).fit(np.nan_to_num(rows)), "size_checks_")
