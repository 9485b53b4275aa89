"""Rows of samples: sparse ones, and the report of rows that must be copied."""

import warnings

import numpy as np
import pytest
from scipy import sparse
from test_som_program import SETTINGS

import pysomato
from pysomato import SOM, ConversionWarning, OneHot, Recording
from pysomato._inputs import rows as row_input


@pytest.fixture
def few():
    """Rows of (40, 120) whose values are mostly 0; float32."""
    random = np.random.default_rng(5)
    rows = random.random((40, 120), np.float32)
    rows[random.random(rows.shape) < 0.95] = 0
    rows[:, 60:] = 0
    rows[7, 3] = 1  # no row is empty
    return rows


@pytest.mark.parametrize("settings", SETTINGS.values(), ids=SETTINGS)
def test_sparse_rows_give_the_map_of_dense_ones(few, settings):
    rows = sparse.csr_array(few)
    found, expected = SOM(**settings).fit(rows), SOM(**settings).fit(few)
    # Sums have another order.
    np.testing.assert_allclose(found.weights_, expected.weights_, atol=2e-6)
    np.testing.assert_array_equal(found.winners_, expected.winners_)
    for method in (SOM.predict, SOM.transform):
        np.testing.assert_array_equal(method(expected, rows), method(expected, few))
    assert expected.score(rows) == expected.score(few)


def test_sparse_codes_give_the_map_of_a_study(tmp_path):
    random = np.random.default_rng(2)
    joints = random.random((12, 4)).astype(np.float32)
    recording = Recording.from_arrays({"object": list("abc") * 4},
                                      {"joints": joints[:, None, :]}, rates={"joints": 1})
    study = tmp_path / "codes.toml"
    study.write_text("""
        [study]
        name = "codes"
        label = "object"
        protocols = ["train_is_test"]
        seeds = 1
        [module.joints]
        type = "channel"
        channel = "joints"
        [module.last]
        type = "last"
        input = "joints"
        [module.code]
        type = "one_hot"
        input = "last"
        elements = 30
        low = 0
        high = 1
        [module.map]
        type = "som"
        input = "code"
        rows = 4
        columns = 4
        iterations = 200
        """)
    outcome = pysomato.study(recording, study)
    code = OneHot(elements=30, low=0, high=1).fit_transform(joints)
    som = SOM(**outcome.som.get_params()).fit(sparse.csr_matrix(code))
    np.testing.assert_array_equal(som.weights_, outcome.som.weights_)
    np.testing.assert_array_equal(som.winners_, outcome.som.winners_)


@pytest.mark.parametrize("form", ["csc_array", "coo_matrix", "lil_array", "dok_matrix", "bsr_array"])
def test_any_sparse_format_is_the_same_map(few, form):
    expected = SOM(3, 3, iterations=100).fit(sparse.csr_array(few))
    rows = getattr(sparse, form)(few.astype(np.float64))
    found = SOM(3, 3, iterations=100).fit(rows)
    np.testing.assert_array_equal(found.weights_, expected.weights_)
    np.testing.assert_array_equal(found.predict(rows), expected.predict(few))


def test_unordered_and_repeated_elements_are_summed_in_a_copy():
    untidy = sparse.csr_array((np.array([2, 1, 1, 0, 4], np.float32), [2, 0, 0, 1, 1], [0, 4, 5]),
                              shape=(2, 3))
    before = (untidy.data.tolist(), untidy.indices.tolist(), untidy.indptr.tolist())
    found = SOM(2, 2, iterations=50).fit(untidy)
    assert (untidy.data.tolist(), untidy.indices.tolist(), untidy.indptr.tolist()) == before
    expected = SOM(2, 2, iterations=50).fit(np.array([[2, 0, 2], [0, 4, 0]]))
    np.testing.assert_array_equal(found.weights_, expected.weights_)


def test_partial_fit_learns_elements_that_appear_later(few):
    parts = [few[:20].copy(), few[20:]]
    parts[0][:, 30:] = 0
    dense, thin = (SOM(3, 3, iterations=40) for _ in range(2))
    for part in parts:
        dense.partial_fit(part)
        thin.partial_fit(sparse.csr_array(part))
    np.testing.assert_allclose(thin.weights_, dense.weights_, atol=1e-6)  # sums have another order
    assert np.any(thin.weights_[:, 30:60])


def test_labels_and_pictures_of_sparse_rows(few):
    y = np.arange(40) % 3
    som = SOM(3, 3, iterations=200).fit(few, y)
    rows = sparse.csr_array(few)
    np.testing.assert_array_equal(som.classify(rows), som.classify(few))
    assert som.draw(X=rows, y=y).svg == som.draw(X=few, y=y).svg


def test_sparse_rows_that_contradict_themselves_are_refused():
    for starts, elements in (([0, 2], [1, 1]), ([0, 2], [0, 3]), ([0, 3], [0, 1]), ([1, 2], [0, 1])):
        with pytest.raises(ValueError, match="sparse row"):
            pysomato._somato.SampleRows(3, np.array(starts, np.int64), np.array(elements, np.uint32),
                                        np.ones(2, np.float32))


@pytest.fixture
def reports(monkeypatch):
    """Rows of any size are reported, as at the start of a process; returns the messages of work()."""
    monkeypatch.setattr(row_input, "_WORTH_A_REPORT", 1)
    monkeypatch.setattr(row_input, "_reported", set())

    def messages(work):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            work()
        return [str(one.message) for one in caught if issubclass(one.category, ConversionWarning)]

    return messages


@pytest.mark.parametrize("convert, reason", [
    (lambda X: X.astype(np.float64), "float64 was converted to float32"),
    (np.asfortranarray, "not in C order"),
    (lambda X: X[:, ::-1], "not in C order"),
    (lambda X: X.tolist(), "list is not an array"),
    (sparse.csc_array, "CSC was converted to CSR"),
])
def test_a_conversion_is_reported_once(X, reports, convert, reason):
    som = SOM(2, 2, iterations=20).fit(X)
    rows = convert(X)
    (message,) = reports(lambda: som.predict(rows))
    assert reason in message
    assert reports(lambda: som.fit(rows).transform(rows)) == []


def test_rows_that_are_not_copied_are_not_reported(X, reports):
    som = SOM(2, 2, iterations=20)
    assert reports(lambda: som.fit(X).predict(X[10:20])) == []
    assert reports(lambda: som.fit(sparse.csr_array(X))) == []


def test_few_rows_are_converted_without_a_report(X):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        SOM(2, 2, iterations=20).fit(X.tolist())


def test_the_place_of_a_report_is_the_call(X, reports):
    del reports
    with pytest.warns(ConversionWarning) as caught:
        SOM(2, 2, iterations=20).fit(X.astype(np.float64))
    assert caught[0].filename == __file__
