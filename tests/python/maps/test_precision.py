"""Columns whose differences float32 does not hold are refused, as by the program."""

import copy
import pickle
import warnings

import numpy as np
import pytest
from scipy import sparse
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler

import pysomato
from pysomato import SOM, TMPSOM, OneHot, Recording, Spectrum, TensorProduct

LOST = "loses precision"


@pytest.fixture
def raw():
    """Rows of (60, 2) that differ by less than 32-bit numbers near them do; float64."""
    return 1e8 + 4 * np.random.default_rng(1).random((60, 2))


def refused(work):
    with pytest.raises(pysomato.DataError, match=LOST) as caught:
        work()
    assert "--" not in str(caught.value) and "subtract an offset" in caught.value.advice
    return str(caught.value)


@pytest.mark.parametrize("estimator", [SOM(3, 3), TMPSOM((2, 2)), OneHot(), TensorProduct(),
                                       Spectrum(100, bands=0, segment_length=2)], ids=lambda one: type(one).__name__)
def test_every_estimator_refuses_them(raw, estimator):
    message = refused(lambda: estimator.fit(raw))
    assert "column 0" in message and "8 apart" in message
    if hasattr(estimator, "partial_fit"):
        refused(lambda: estimator.partial_fit(raw))
    near = np.random.default_rng(2).random((60, 2))
    estimator.fit(near)
    refused(lambda: estimator.transform(raw))


def test_columns_that_lose_something_are_reported():
    near = np.random.default_rng(1).normal(size=(60, 2))
    far = near + [1e6, 0]
    with pytest.warns(pysomato.PrecisionWarning, match="column 0 is rounded.*0.0625 apart") as caught:
        SOM(3, 3).fit(far)
    assert len(caught) == 1
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        SOM(3, 3).fit(near)
        make_pipeline(StandardScaler(), SOM(3, 3)).fit(far).predict(far[:1])


@pytest.mark.parametrize("constant", [9.81, 0.1, 1 / 3, 273.15])
def test_a_constant_column_is_read_as_it_is_learned(constant):
    X = np.c_[np.random.default_rng(1).normal(size=(60, 2)), np.full(60, constant)]
    som = SOM(5, 5).fit(X)
    np.testing.assert_array_equal(som.predict(X), som.winners_)


@pytest.mark.parametrize("form", [
    np.asfortranarray, lambda X: X.tolist(), lambda X: X.astype(object), sparse.csr_array,
    sparse.coo_matrix, lambda X: np.ma.masked_array(X), lambda X: X[:, ::-1],
    lambda X: np.round(X).astype(np.int64)])
def test_they_are_refused_in_every_form(raw, form):
    refused(lambda: SOM(3, 3).fit(form(raw)))


def test_the_column_is_named(raw):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"b": np.arange(60.0), "a": raw[:, 0]})
    assert "column 1 ('a')" in refused(lambda: SOM(3, 3).fit(frame))


def test_the_program_says_the_same(raw, tmp_path):
    import os
    import subprocess

    np.save(tmp_path / "raw.npy", raw)
    done = subprocess.run([os.environ["SOMATO_PROGRAM"], "som", "train", tmp_path / "raw.npy", "-o",
                           tmp_path / "map.somato"], check=False, capture_output=True, text=True)
    mine = refused(lambda: SOM(3, 3).fit(raw))
    assert done.returncode != 0
    assert mine[mine.index(LOST):] in done.stderr


def test_one_row_after_the_other_is_refused_too(raw):
    som = SOM(3, 3, iterations=100).partial_fit(raw[:1])
    refused(lambda: [som.partial_fit(row[None]) for row in raw[1:]])
    again = SOM(3, 3, iterations=100).partial_fit(raw[:1])
    for other in (copy.deepcopy(again), pickle.loads(pickle.dumps(again))):
        refused(lambda other=other: [other.partial_fit(row[None]) for row in raw[1:]])


def test_rows_are_read_one_by_one_as_together():
    far = 1e6 + np.random.default_rng(3).normal(size=(60, 3))
    with pytest.warns(pysomato.PrecisionWarning):
        som = SOM(3, 3).fit(far)
    np.testing.assert_array_equal([som.predict(row[None])[0] for row in far], som.winners_)
    stream = SOM(3, 3, iterations=100)
    for row in far:
        stream.partial_fit(row[None])
    assert stream.samples_seen_ == len(far)


def test_one_row_is_compared_with_the_map(raw, tmp_path):
    som = SOM(3, 3).fit(raw - raw.mean(axis=0))
    som.save(tmp_path / "map.somato")
    for one in (som, SOM.load(tmp_path / "map.somato")):
        refused(lambda one=one: one.predict(raw[:1] + 0.3))
        refused(lambda one=one: one.classify(raw[:1] + 0.3))
        refused(lambda one=one: one.partial_fit(raw[:1] + 0.3))


# 32-bit numbers near 90 are 7.6e-6 apart.
def test_a_hand_at_rest_is_not_refused():
    random = np.random.default_rng(3)
    joints = 90 + 20 * random.random((40, 2))
    rest = 90 + 1e-6 * random.random((5, 2))
    som = SOM(3, 3).fit(joints)
    assert len(set(som.predict(rest).tolist())) == 1
    som.partial_fit(rest)
    TMPSOM((2, 2)).fit(joints).transform(rest)
    Recording.from_arrays({}, {"joints": [joints, rest]})


def test_columns_without_differences_or_with_great_ones_are_accepted():
    rows = np.random.default_rng(4).random((30, 3))
    rows[:, 0] = 1700000000.25  # constant
    rows[:, 1] = 1.7e9 + 1000 * np.arange(30)  # 128 apart
    rows[:, 2] = 2**24 - 30 + np.arange(30)
    SOM(3, 3).fit(rows).predict(rows)


def test_integers_beyond_64_bit_floating_point_are_refused():
    nanoseconds = (1_700_000_000 * 10**9 + np.arange(30, dtype=np.int64))[:, None]
    refused(lambda: SOM(3, 3).fit(nanoseconds))
    SOM(3, 3).fit(nanoseconds - nanoseconds.min())


@pytest.mark.parametrize("offset", [1e6, 1.7e9])
def test_a_standardized_column_trains_in_spite_of_its_offset(offset):
    near = np.random.default_rng(5).normal(size=(80, 2))
    near = np.round(near * 64) / 64  # exact also beside the offset
    far = near + np.array([offset, 0.0])
    trained = [make_pipeline(StandardScaler(), SOM(3, 3)).fit(rows) for rows in (near, far)]
    np.testing.assert_array_equal(trained[0].predict(near), trained[1].predict(far))


@pytest.mark.parametrize("offset", [1e6, 1.7e9])
def test_a_standardized_map_of_the_program_takes_columns_with_offsets(somato, tmp_path, offset):
    near = np.round(np.random.default_rng(5).normal(size=(80, 2)) * 64) / 64
    far = near + np.array([offset, 0.0])
    np.save(tmp_path / "far.npy", far)
    somato("som", "train", tmp_path / "far.npy", "-o", tmp_path / "map.somato", "--standardize",
           "--rows", 4, "--columns", 4)
    printed = somato("som", "map", tmp_path / "map.somato", tmp_path / "far.npy")
    winners = [int(line.split(",")[1]) for line in printed.splitlines()[1:]]
    som = SOM.load(tmp_path / "map.somato")
    np.testing.assert_array_equal(som.predict(far), winners)
    assert len(set(winners)) > 8
    np.testing.assert_array_equal([som.predict(row[None])[0] for row in far], winners)


def test_recordings_refuse_them(raw):
    message = refused(lambda: Recording.from_arrays({}, {"touch": [raw]}))
    assert "touch" in message and "element 0" in message
    named = refused(lambda: Recording.from_arrays({}, {"touch": [raw]},
                                                  element_names={"touch": ["x", "y"]}))
    assert "'x'" in named


def test_recordings_refuse_times_that_are_equal_within_an_exploration():
    hours = [1.7e9 + 3600 * hour + np.arange(100)[:, None] / 100 for hour in range(20)]
    assert "exploration 0" in refused(lambda: Recording.from_arrays({}, {"clock": hours}))


def test_values_of_recordings_that_are_not_valid_are_not_compared(raw):
    touch = np.random.default_rng(2).random((60, 2))
    marks = np.ones((60, 2))
    touch[7], marks[7] = 1e300, 0
    recording = Recording.from_arrays({}, {"touch": [touch]}, valid={"touch": [marks]})
    assert recording["touch"][0][7].tolist() == [0, 0]
