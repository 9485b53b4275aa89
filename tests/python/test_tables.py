"""Tables whose rows are explorations: the same from a file, a DataFrame and an array."""

import numpy as np
import pytest

import pysomato
from pysomato import DataError, Recording, UsageError, read

TEXT = "day,width,mass,kind\n2026-05-01,1.5,300,cup\n2026-05-02,,25,sponge\n2026-05-02,2.5,60,ball\n"


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "t.csv"
    path.write_text(TEXT)
    return path


@pytest.fixture
def frame(file):
    return pytest.importorskip("pandas").read_csv(file)


def values_of(recording):
    return np.concatenate(recording["columns"])


def test_a_frame_is_what_the_program_reads_from_its_file(file, frame):
    of_file = read(file, label_column="kind", skip=["day"], missing="mask")
    of_frame = Recording.from_table(frame, "kind", skip=["day"], missing="mask")
    for recording in (of_file, of_frame):
        np.testing.assert_array_equal(values_of(recording), [[1.5, 300], [0, 25], [2.5, 60]])
        assert recording.channels[0]["element_names"] == ["width", "mass"]
        assert recording.label("kind").tolist() == ["cup", "sponge", "ball"]
        assert recording.label("row").tolist() == ["1", "2", "3"]
        np.testing.assert_array_equal(np.concatenate(recording.valid("columns")), [[1, 1], [0, 1], [1, 1]])


def test_an_array_has_labels_of_its_own(tmp_path):
    rows = np.arange(6.0).reshape(3, 2)
    recording = Recording.from_table(rows, labels=["a", "b", "a"])
    np.testing.assert_array_equal(values_of(recording), rows)
    assert recording.label("label").tolist() == ["a", "b", "a"]
    np.save(tmp_path / "rows.npy", rows)
    np.testing.assert_array_equal(values_of(read(tmp_path / "rows.npy")), rows)


def test_a_table_is_suggested_and_studied():
    random = np.random.default_rng(3)
    kinds = np.repeat(["cup", "ball", "can"], 12)
    rows = random.normal(size=(36, 3)) + 9 * (kinds[:, None] == ["cup", "ball", "can"])
    rows[4, 1] = np.nan
    table = Recording.from_table(rows * [1, 1000, 1], labels=kinds, missing="mask")
    suggestion = pysomato.suggest(table, label="label")
    assert "standardized_last_of_columns" in suggestion.toml and "fill = [" in suggestion.toml
    study = pysomato.study(table, suggestion, seeds=1)
    assert study.metrics.set_index("metric")["mean"]["accuracy"] > 0.9


@pytest.mark.parametrize(("arguments", "part"), [
    ({"label_column": "knd"}, "there is no column 'knd'"),
    ({"label_column": "kind", "skip": ["dy"]}, "there is no column 'dy'"),
    ({"label_column": "kind"}, "day"),
    ({"label_column": "kind", "labels": ["a"] * 3, "skip": ["day"]}, "by a column and by a list"),
    ({"labels": ["a"], "skip": ["day", "kind"], "missing": "mask"}, "there are 1 labels for 3 rows"),
    ({"label_column": "kind", "skip": ["day"], "missing": "mean"}, "'missing' is 'mean'"),
    ({"label_column": "kind", "skip": ["day"]}, "width"),
])
def test_what_is_wrong_is_named(frame, arguments, part):
    with pytest.raises((UsageError, DataError), match=part):
        Recording.from_table(frame, **arguments)


def test_keys_of_tables_are_refused_for_recordings(tmp_path):
    recording = Recording.from_arrays({"a": ["x", "y"]}, {"c": [[[1.0]], [[2.0]]]})
    recording.write(tmp_path / "r.mcap")
    with pytest.raises(UsageError, match="'skip' is a setting of tables"):
        read(tmp_path / "r.mcap", skip=["a"])
    with pytest.raises(UsageError, match="skp"):
        read(tmp_path / "r.mcap", skp=["a"])
