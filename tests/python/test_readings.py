"""Readings that are no numbers are refused by name, and tables of all kinds are read."""

import datetime

import numpy as np
import pytest

import pysomato
from pysomato import SOM, Recording


@pytest.fixture
def pandas():
    return pytest.importorskip("pandas")


@pytest.fixture
def frame(pandas):
    random = np.random.default_rng(6)
    return pandas.DataFrame({"a": random.random(12), "b": np.arange(12), "c": random.random(12) > 0.5})


def refused(X, *words):
    with pytest.raises(pysomato.DataError) as caught:
        SOM(2, 2).fit(X)
    assert caught.value.advice
    for word in words:
        assert word in str(caught.value)


def test_columns_of_text_are_named(frame):
    refused(frame.assign(name=list("xyzxyzxyzxyz")), "column 'name'", "'x'", "row 0", "as y")
    refused(frame.assign(name=["1"] * 12), "column 'name'", "text")
    refused(frame.astype({"b": "string"}), "column 'b'")
    refused(frame.astype({"b": "str"}).astype({"b": "category"}), "column 'b'")
    refused([["1.5", "x"], ["2", "y"]], "column 0", "'1.5'")
    refused([[1, 2], [3, "y"]], "column 1", "row 1", "'y'")
    refused(np.array([[b"x"], [b"y"]]), "'x'")


def test_columns_of_dates_are_named(frame, pandas):
    times = pandas.date_range("2024-01-01", periods=12, freq="s")
    refused(frame.assign(time=times), "column 'time'", "dates", "total_seconds")
    refused(frame.assign(time=times.tz_localize("UTC")), "column 'time'", "dates")
    refused(frame.assign(time=times - times[0]), "column 'time'", "durations")
    refused(pandas.DataFrame({"time": [pandas.NaT, *times[1:]]}), "column 'time'")
    refused([[datetime.datetime(2024, 1, 1)], [datetime.datetime(2024, 1, 2)]], "column 0", "dates")
    refused(np.array([["2024", "NaT"], ["2025", "2024"]], "datetime64[D]"), "dates")


@pytest.mark.parametrize("name", ["Unnamed: 0", "", " ", "Unnamed: 0_level_0"])
def test_columns_without_a_name_are_refused(frame, name):
    refused(frame.rename(columns={"a": name}), "column 0 has no name", "index_col=0")
    with pytest.raises(pysomato.DataError, match="no name"):
        Recording.from_arrays({name: ["x"]}, {"touch": [[[1.0]]]})


def test_an_index_that_was_written_is_refused(frame, pandas, tmp_path):
    frame.to_csv(tmp_path / "frame.csv")
    refused(pandas.read_csv(tmp_path / "frame.csv"), "Unnamed: 0")
    SOM(2, 2).fit(pandas.read_csv(tmp_path / "frame.csv", index_col=0))


def test_columns_are_numbered_by_integers(pandas):
    SOM(2, 2).fit(pandas.DataFrame(np.random.default_rng(1).random((9, 2))))


class Lazy:
    """As a LazyFrame of polars: it has columns, but no rows."""

    columns = ("a", "b")

    def collect(self):
        return None


class Delayed:
    """As a DataFrame of dask."""

    __dask_graph__ = None
    shape = (None, 2)
    columns = ("a", "b")
    iloc = None

    def compute(self):
        return None


@pytest.mark.parametrize("X, words", [
    (Lazy(), ("Lazy", "collect()")),
    (Delayed(), ("Delayed", "compute()")),
    ("rows.csv", ("text", "pysomato.read")),
    ({"a": [1, 2]}, ("dict", "DataFrame")),
    (([row] for row in range(3)), ("generator", "list")),
    (object(), ("object",)),
    ([[1, 2], [3]], ("differ in length",)),
    ([[1, {}], [2, {}]], ("column 1",)),
    ([1.0, 2.0, 3.0], ("2D",)),
    (np.zeros((2, 2, 2)), ("dim",)),
    (np.zeros((3, 2), complex), ("omplex",)),
    (np.zeros(3, [("a", float), ("b", float)]), ("records", "structured_to_unstructured")),
    (np.empty((0, 3)), ("0 sample",)),
])
def test_what_is_no_array_of_numbers_is_named(X, words):
    refused(X, *words)


def test_a_recording_is_no_array():
    recording = Recording.from_arrays({"object": ["a"]}, {"touch": [[[1.0]]]})
    refused(recording, "recording", "frames[-1]")


def test_frames_of_all_kinds_are_the_same_rows(frame, pandas):
    expected = SOM(2, 2, iterations=100).fit(frame.to_numpy(float)).weights_
    kinds = [frame, frame.convert_dtypes(), frame.convert_dtypes(dtype_backend="pyarrow"),
             frame.astype(object), frame.astype({"c": "category"})]
    for kind in kinds:
        som = SOM(2, 2, iterations=100).fit(kind)
        np.testing.assert_array_equal(som.weights_, expected)
        assert som.map_.features == ["a", "b", "c"]
    pyarrow = pytest.importorskip("pyarrow")
    table = pyarrow.Table.from_pandas(frame)
    som = SOM(2, 2, iterations=100).fit(table)
    np.testing.assert_array_equal(som.weights_, expected)
    np.testing.assert_array_equal(som.predict(frame), som.predict(table))


def test_every_error_before_training_is_one_of_the_package():
    for method in (SOM().predict, SOM().transform, pysomato.TMPSOM().transform,
                   pysomato.OneHot().transform):
        with pytest.raises(pysomato.NotFittedError) as caught:
            method([[1.0]])
        assert isinstance(caught.value, pysomato.Error) and caught.value.advice
    som = SOM(2, 2).fit([[1.0, 2.0], [3.0, 4.0]])
    for X in ([[1.0]], [[1.0, 2.0, 3.0]]):
        with pytest.raises(pysomato.DataError, match="features"):
            som.predict(X)


def test_the_version_is_that_of_the_program(somato):
    assert somato("--version").split()[-1] == pysomato.__version__
