"""Missing values and missing labels in every form in which arrays carry them."""

import decimal

import numpy as np
import pytest
from scipy import sparse

import pysomato
from pysomato import SOM, TMPSOM, OneHot, Recording


@pytest.fixture
def rows():
    """Rows of (20, 3) around two centres, as lists."""
    random = np.random.default_rng(8)
    return (np.arange(20)[:, None] % 2 * 4 + random.random((20, 3))).tolist()


def masked(rows):
    mask = np.zeros((20, 3), bool)
    mask[4, 1] = True
    values = np.array(rows)
    values[4, 1] = 1e6  # which must not be learned
    return np.ma.masked_array(values, mask)


def with_value(value):
    def changed(rows):
        rows[4][1] = value
        return rows
    return changed


def framed(change, dtype=None):
    def changed(rows):
        pandas = pytest.importorskip("pandas")
        frame = pandas.DataFrame(rows, columns=["a", "b", "c"])
        if dtype is not None:
            frame = frame.round().astype(dtype)
        return change(frame, pandas)
    return changed


def without_one(frame, pandas):
    frame.loc[4, "b"] = pandas.NA if str(frame["b"].dtype) in ("Int64", "Float64") else None
    return frame


def arrow(rows):
    pyarrow = pytest.importorskip("pyarrow")
    rows[4][1] = None
    columns = list(zip(*rows))
    return pyarrow.table({name: pyarrow.array(column) for name, column in zip("abc", columns)})


def arrow_frame(frame, pandas):
    frame = frame.convert_dtypes(dtype_backend="pyarrow")
    frame.loc[4, "b"] = pandas.NA
    return frame


MISSING = {
    "None in lists": with_value(None),
    "NaN in lists": with_value(float("nan")),
    "NaN of Decimal": with_value(decimal.Decimal("nan")),
    "masked in lists": with_value(np.ma.masked),
    "None in objects": lambda rows: np.array(with_value(None)(rows), dtype=object),
    "NaN": lambda rows: np.array(with_value(float("nan"))(rows)),
    "NaN in float32": lambda rows: np.array(with_value(float("nan"))(rows), np.float32),
    "mask": masked,
    "mask in float32": lambda rows: masked(rows).astype(np.float32),
    "mask in integers": lambda rows: np.ma.round(masked(rows)).astype(int),
    "masked rows": lambda rows: list(masked(rows)),
    "frame": framed(without_one),
    "frame of Int64": framed(without_one, "Int64"),
    "frame of Float64": framed(without_one, "Float64"),
    "frame of objects": framed(without_one, object),
    "frame of arrow": framed(arrow_frame),
    "table of arrow": arrow,
}


@pytest.mark.parametrize("form", MISSING.values(), ids=MISSING)
def test_a_missing_value_is_refused_with_its_place(rows, form):
    X = form(rows)
    for estimator in (SOM(2, 2), TMPSOM((2, 2)), OneHot()):
        with pytest.raises(pysomato.DataError, match=r"row 4, column 1.*missing") as caught:
            estimator.fit(X)
        assert "missing='mean'" in caught.value.advice


@pytest.mark.parametrize("form", MISSING.values(), ids=MISSING)
@pytest.mark.parametrize("missing", ["mean", "nearest"])
def test_a_missing_value_is_filled_on_request(rows, form, missing):
    X = form([list(row) for row in rows])
    som = SOM(2, 2, missing=missing, iterations=200).fit(X)
    assert np.isfinite(som.weights_).all() and som.weights_.max() < 7
    assert np.isfinite(som.transform(X)).all()
    assert som.predict(X).shape == (20,)


def holes():
    """The table of docs/tables.md's kind, with rows filled by hand in two ways."""
    nan = np.nan
    table = np.array([[1, 10, 2], [2, 23, 9], [nan, 13, nan], [5, nan, 4], [4, 34, 5]])
    # Means of the known values are 3, 20, 5.
    mean = np.array([[1, 10, 2], [2, 23, 9], [3, 13, 5], [5, 20, 4], [4, 34, 5]], float)
    # By b the third row is nearest to the first; by a and c the fourth to the last.
    nearest = np.array([[1, 10, 2], [2, 23, 9], [1, 13, 2], [5, 34, 4], [4, 34, 5]], float)
    return table, {"mean": mean, "nearest": nearest}


@pytest.mark.parametrize("missing", ["mean", "nearest"])
def test_values_are_filled_as_by_the_program(somato, tmp_path, missing):
    table, filled = holes()
    np.save(tmp_path / "holes.npy", table)
    somato("som", "train", tmp_path / "holes.npy", "-o", tmp_path / "map.somato", "--missing", missing,
           "--rows", 2, "--columns", 3)
    som = SOM(2, 3, missing=missing).fit(table)
    expected = SOM(2, 3).fit(filled[missing])
    np.testing.assert_array_equal(som.weights_, expected.weights_)
    np.testing.assert_array_equal(som.winners_, expected.winners_)
    assert som.quantization_error_ == expected.quantization_error_
    som.save(tmp_path / "mine.somato")
    assert (tmp_path / "mine.somato").read_bytes() == (tmp_path / "map.somato").read_bytes()
    new = np.array([[1, np.nan, 2], [np.nan, np.nan, 9]])
    np.save(tmp_path / "new.npy", new)
    printed = somato("som", "map", tmp_path / "map.somato", tmp_path / "new.npy", "--missing", missing)
    winners = [int(line.split(",")[1]) for line in printed.splitlines()[1:]]
    np.testing.assert_array_equal(som.predict(new), winners)
    loaded = SOM.load(tmp_path / "map.somato").set_params(missing=missing)
    np.testing.assert_array_equal(loaded.predict(new), winners)


def test_maps_that_compare_directions_are_trained_on_nearest_values():
    table, filled = holes()
    settings = {"similarity": "dot_product", "iterations": 50}
    som = SOM(2, 2, missing="nearest", **settings).fit(table)
    np.testing.assert_array_equal(som.weights_, SOM(2, 2, **settings).fit(filled["nearest"]).weights_)
    with pytest.raises(pysomato.UsageError):
        som.predict(table)


def test_partial_fit_fills_values_too():
    table, _ = holes()
    for missing in ("mean", "nearest"):
        som = SOM(2, 2, missing=missing, iterations=20).partial_fit(table).partial_fit(table[2:4])
        assert np.isfinite(som.weights_).all()
        assert som.samples_seen_ == 7


def test_what_cannot_be_filled_is_named():
    table, _ = holes()
    with pytest.raises(pysomato.DataError, match="row 1 has no known value"):
        SOM(2, 2, missing="mean").fit(np.array([[1.0, 2.0], [np.nan, np.nan], [3, 4]]))
    with pytest.raises(pysomato.DataError, match="column 1 has no known value"):
        SOM(2, 2, missing="mean").fit(np.array([[1.0, np.nan], [2, np.nan]]))
    with pytest.raises(pysomato.DataError, match="no row is complete") as caught:
        SOM(2, 2, missing="nearest").fit(np.array([[1.0, np.nan], [np.nan, 2]]))
    assert "--" not in str(caught.value)
    with pytest.raises(pysomato.UsageError, match="means of its training data"):
        SOM(2, 2).fit(table[:2]).set_params(missing="mean").predict(table)
    with pytest.raises(pysomato.UsageError, match="did you mean 'mean'"):
        SOM(2, 2, missing="means").fit(table)
    with pytest.raises(pysomato.DataError, match="missing"):
        SOM(2, 2, missing="mean").fit(sparse.csr_array(table))


def test_infinite_values_are_refused_with_their_place(rows):
    rows[3][2] = -np.inf
    for X in (rows, np.array(rows, np.float32), sparse.csr_array(np.array(rows))):
        with pytest.raises(pysomato.DataError, match="row 3, column 2.*infinite"):
            SOM(2, 2, missing="mean").fit(X)
    rows[3][2] = 1e40
    with pytest.raises(pysomato.DataError, match="row 3, column 2.*single precision"):
        SOM(2, 2).fit(rows)


# --- labels


def labels_without_some(kind):
    pandas = pytest.importorskip("pandas")
    cup = [None, None, "cup", "cup", "ball", "ball"]
    objects = np.array(cup, dtype=object)
    return {
        "None": objects,
        "None in a list": cup,
        "NaN of objects": np.array([np.nan, np.nan, *cup[2:]], dtype=object),
        "NaN in a list": [np.nan, np.nan, *cup[2:]],
        "NaN that became a text": np.array([np.nan, np.nan, *cup[2:]]),
        "empty texts": ["", " ", *cup[2:]],
        "NA of strings": pandas.Series(cup, dtype="string"),
        "str": pandas.Series(cup, dtype="str"),
        "NA of objects": pandas.Series([pandas.NA, pandas.NA, *cup[2:]], dtype=object),
        "NaT": np.array([pandas.NaT, pandas.NaT, *cup[2:]], dtype=object),
        "categories": pandas.Categorical(cup),
        "series of categories": pandas.Series(cup, dtype="category"),
        "mask": np.ma.masked_array(["ball", "cup", *cup[2:]], [1, 1, 0, 0, 0, 0]),
        "masked in a list": [np.ma.masked, np.ma.masked, *cup[2:]],
        "frame of a column": pandas.DataFrame({"y": cup}),
    }[kind]


MISSING_LABELS = ["None", "None in a list", "NaN of objects", "NaN in a list",
                  "NaN that became a text", "empty texts", "NA of strings", "str", "NA of objects",
                  "NaT", "categories", "series of categories", "mask", "masked in a list"]


@pytest.fixture
def six():
    """Three pairs of rows that are far apart."""
    return np.repeat([0.0, 10.0, 20.0], 2)[:, None] + np.array([[0.0, 0.1]] * 6)


@pytest.mark.parametrize("kind", MISSING_LABELS)
def test_samples_without_a_label_are_learned_and_name_no_neuron(six, kind):
    y = labels_without_some(kind)
    som = SOM(3, 3, iterations=500).fit(six, y)
    assert list(som.classes_) == ["cup", "ball"]
    np.testing.assert_array_equal(som.weights_, SOM(3, 3, iterations=500).fit(six).weights_)
    assert som.classify(six)[2:].tolist() == ["cup", "cup", "ball", "ball"]
    assert som.score(six, y) == 1.0  # of the four that have a label
    assert som.draw("labels").svg == som.draw("labels", six, y).svg


@pytest.mark.parametrize("y, known", [
    (np.array([np.nan, np.nan, 1, 1, 2, 2]), [1, 2]),
    ([None, None, 1, 1, 2, 2], [1, 2]),
    (np.ma.masked_array([2, 1, 1, 1, 2, 2], [1, 1, 0, 0, 0, 0]), [1, 2]),
    (np.array(["NaT", "NaT", "2020", "2020", "2021", "2021"], "datetime64[Y]"), None),
])
def test_numbers_keep_their_type(six, y, known):
    som = SOM(3, 3).fit(six, y)
    assert len(som.classes_) == 2
    if known is not None:
        assert som.classes_.tolist() == known and som.classes_.dtype.kind in "if"
    assert som.score(six, y) == 1.0


def test_nullable_numbers_are_labels(six):
    pandas = pytest.importorskip("pandas")
    for dtype in ("Int64", "Float64", "int64[pyarrow]"):
        y = pandas.Series([None, None, 1, 1, 2, 2], dtype=dtype)
        som = SOM(3, 3).fit(six, y)
        assert som.classes_.tolist() == [1, 2]
        assert som.score(six, y) == 1.0
    y = pandas.Series([None, None, True, True, False, False], dtype="boolean")
    assert SOM(3, 3).fit(six, y).score(six, y) == 1.0


def test_a_value_of_ones_own_marks_samples_without_a_label(six):
    y = np.array([-1, -1, 0, 0, 1, 1])
    som = SOM(3, 3, unlabelled=-1).fit(six, y)
    assert som.classes_.tolist() == [0, 1]
    assert som.score(six, y) == 1.0
    with pytest.warns(pysomato.LabelWarning, match="unlabelled=-1"):
        assert SOM(3, 3).fit(six, y).classes_.tolist() == [-1, 0, 1]
    texts = np.array(["?", "?", "cup", "cup", "ball", "ball"])
    assert list(SOM(3, 3, unlabelled="?").fit(six, texts).classes_) == ["cup", "ball"]
    with pytest.warns(pysomato.LabelWarning, match="None for samples"):
        SOM(3, 3).fit(six, texts)


@pytest.mark.filterwarnings("error")
def test_two_classes_of_signs_are_classes(six):
    assert SOM(3, 3).fit(six, [-1, -1, 1, 1, -1, 1]).classes_.tolist() == [-1, 1]


def test_labels_of_several_types_are_distinguished(six):
    y = np.array([1, 1, "cup", "cup", 2, 2], dtype=object)
    som = SOM(3, 3).fit(six, y)
    assert list(som.classes_) == [1, "cup", 2]
    assert som.score(six, y) == 1.0
    assert list(SOM(3, 3).fit(six, [1, 1, "cup", "cup", 2, 2]).classes_) == [1, "cup", 2]
    with pytest.raises(pysomato.DataError, match="written alike"):
        SOM(3, 3).fit(six, np.array([1, "1", 2, 2, 3, 3], dtype=object))


@pytest.mark.parametrize("y", [[[1], [2, 3], 4, 5, 6, 7], np.zeros((6, 2)), [1, 2, 3], 7,
                               [{}, {}, 1, 2, 3, 4]])
def test_labels_that_cannot_be_are_refused_by_the_package(six, y):
    with pytest.raises(pysomato.Error) as caught:
        SOM(3, 3).fit(six, y)
    assert caught.value.advice


def test_without_any_label_there_is_nothing_to_name_or_to_score(six):
    som = SOM(3, 3).fit(six, [None] * 6)
    with pytest.raises(pysomato.UsageError, match="pass labels to fit"):
        som.classify(six)
    som.fit(six, list("aabbcc"))
    with pytest.raises(pysomato.DataError, match="no sample has a label"):
        som.score(six, [None] * 6)


def test_a_score_of_labels_that_the_map_does_not_know_warns(six):
    som = SOM(3, 3).fit(six[:4], list("aabb"))
    with pytest.warns(pysomato.LabelWarning, match="StratifiedKFold"):
        assert som.score(six, list("cccccc")) == 0.0


@pytest.mark.filterwarnings("error")
def test_a_score_counts_labels_of_which_some_are_known(six):
    som = SOM(3, 3).fit(six[:4], list("aabb"))
    assert som.score(six, list("aabbcc")) == pytest.approx(4 / 6)


def test_a_loaded_map_scores_numbers_as_before(six, tmp_path):
    y = np.array([1, 1, 2, 2, 3, 3])
    som = SOM(3, 3).fit(six, y)
    som.save(tmp_path / "map.somato")
    assert SOM.load(tmp_path / "map.somato").score(six, y) == som.score(six, y) == 1.0


# --- recordings


def test_masked_values_of_recordings_are_missing():
    touch = np.ma.masked_greater(np.arange(12.0).reshape(4, 3), 10)
    recording = Recording.from_arrays({}, {"touch": [touch, touch.data]})
    assert recording["touch"][0][3].tolist() == [9, 10, 0]
    assert recording.valid("touch")[0].sum() == 11
    assert recording.valid("touch")[1] is None
    marked = Recording.from_arrays({}, {"touch": [touch]}, valid={"touch": [np.arange(12).reshape(4, 3)]})
    assert marked.valid("touch")[0].sum() == 10


@pytest.mark.parametrize("value", [None, np.nan, np.ma.masked])
def test_missing_values_of_recordings_are_refused_with_their_place(value):
    frames = [[1.0, 2.0], [3.0, value]]
    with pytest.raises(pysomato.DataError, match="'touch', exploration 1.*frame 1, element 1") as caught:
        Recording.from_arrays({}, {"touch": [[[1.0, 2.0]], frames]})
    assert "valid" in caught.value.advice


@pytest.mark.parametrize("value", [None, np.nan, "", np.ma.masked])
def test_missing_labels_of_recordings_are_refused(value):
    with pytest.raises(pysomato.DataError, match="label 'object' of exploration 1"):
        Recording.from_arrays({"object": ["cup", value]}, {"touch": [[[1.0]], [[2.0]]]})


def batch_by_known(X, weights, radii, similarity):
    """Batch training in loops: winners and means over the known values (Samad and Harp 1992)."""
    neurons = np.arange(len(weights))
    for radius in radii:
        gains = np.exp(-(neurons[:, None] - neurons) ** 2 / (2 * radius ** 2))
        differences = np.abs(X[:, None] - weights)
        distances = (np.nansum(differences, axis=2) if similarity == "manhattan" else
                     np.nansum(differences ** 2, axis=2) if similarity == "euclidean" else
                     np.nanmax(differences, axis=2))
        to_neurons = gains[distances.argmin(axis=1)]
        sums = to_neurons.T @ np.nan_to_num(X)
        weights = sums / (to_neurons.T @ ~np.isnan(X))
    return weights


@pytest.mark.parametrize("similarity", ["euclidean", "manhattan", "chebyshev"])
def test_left_out_values_are_no_part_of_distances_and_means(similarity):
    random = np.random.default_rng(3)
    X = random.normal(size=(60, 5)).astype(np.float32).astype(np.float64)
    X[np.arange(60), np.arange(60) % 5] = np.nan  # no row is complete
    settings = {"similarity": similarity, "missing": "leave_out", "training": "batch"}
    schedule = {"radius_start": 1.5, "radius_end": 1.5, "radius_schedule": "linear"}
    initial = SOM(1, 6, epochs=0, **settings, **schedule).fit(X).weights_.astype(np.float64)
    som = SOM(1, 6, epochs=4, **settings, **schedule).fit(X)
    expected = batch_by_known(X, initial, [1.5] * 4, similarity)
    np.testing.assert_allclose(som.weights_, expected, atol=1e-5)
    known = np.abs(X[:, None] - som.weights_.astype(np.float64))
    distances = {"euclidean": np.sqrt(np.nansum(known ** 2, axis=2)),
                 "manhattan": np.nansum(known, axis=2),
                 "chebyshev": np.nanmax(known, axis=2)}[similarity]
    np.testing.assert_array_equal(som.predict(X), distances.argmin(axis=1))
    assert som.quantization_error_ == pytest.approx(distances.min(axis=1).mean(), rel=1e-6)


def test_partial_fit_leaves_values_out():
    X = np.array([[1.0, np.nan], [np.nan, 3.0], [2.0, 5.0]])
    som = SOM(1, 1, missing="leave_out", iterations=2, learning_rate_start=0.5, learning_rate_end=0.5,
              initial_weights="range").partial_fit(X)
    before = SOM(1, 1, missing="mean", iterations=0, initial_weights="range").fit(X).weights_[0]
    # Three steps of a half, of which two know each column.
    np.testing.assert_allclose(som.weights_[0], [(before[0] + 1) / 4 + 1, (before[1] + 3) / 4 + 2.5],
                               rtol=1e-6)


def test_maps_of_directions_cannot_leave_values_out():
    X = np.array([[1.0, np.nan], [np.nan, 3.0], [2.0, 5.0]])
    for similarity in ("cosine", "dot_product"):
        with pytest.raises(pysomato.UsageError, match="which missing values leave unknown"):
            SOM(2, 2, similarity=similarity, missing="leave_out").fit(X)


@pytest.mark.parametrize("parameters", [{"similarity": "cosine"}, {"similarity": "dot_product"},
                                        {"normalize_input": True}])
def test_complete_rows_are_read_by_maps_of_directions(parameters):
    X = np.random.default_rng(1).normal(size=(40, 3))
    incomplete = X.copy()
    incomplete[3, 1] = np.nan
    som = SOM(3, 3, missing="nearest", **parameters).fit(incomplete)
    np.testing.assert_array_equal(som.predict(X[:3]), som.winners_[:3])
    with pytest.raises(pysomato.UsageError, match="missing values leave unknown"):
        som.predict(incomplete)
