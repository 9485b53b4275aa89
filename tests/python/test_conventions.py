"""Parameters that users of scikit-learn expect: random_state, verbose, columns by name."""

import sys

import numpy as np
import pytest
from sklearn.base import clone

from pysomato import SOM, TMPSOM, DataError, SOMClassifier, UsageError


@pytest.mark.parametrize("estimator", [SOM(3, 3, iterations=50), SOMClassifier(3, 3, iterations=50),
                                       TMPSOM((3, 3), iterations=50)])
class TestRandomState:
    def seeds(self, estimator, X, labels, **parameters):
        """The seeds of two trainings."""
        changed = clone(estimator).set_params(**parameters)
        return [changed.fit(X, labels).map_.parameters["seed"] for _ in range(2)]

    def test_a_number_is_the_seed(self, estimator, X, labels):
        assert self.seeds(estimator, X, labels) == [1, 1]
        for name in ("random_state", "seed"):
            assert self.seeds(estimator, X, labels, **{name: 7}) == [7, 7]
            assert self.seeds(estimator, X, labels, **{name: np.uint32(7)}) == [7, 7]

    def test_a_source_gives_another_seed_each_time(self, estimator, X, labels):
        for source in (np.random.RandomState, np.random.default_rng):
            drawn = self.seeds(estimator, X, labels, random_state=source(5))
            assert drawn[0] != drawn[1]
            assert drawn == self.seeds(estimator, X, labels, random_state=source(5))

    def test_none_is_the_source_of_numpy(self, estimator, X, labels):
        np.random.seed(5)
        drawn = self.seeds(estimator, X, labels, random_state=None)
        assert drawn == self.seeds(estimator, X, labels, random_state=np.random.RandomState(5))

    def test_what_gives_no_seed_is_refused(self, estimator, X, labels):
        for given in (-1, 1.5, "automatic", True, 10**15 + 1):
            with pytest.raises(UsageError, match=r"\(random_state\): .* gives no seed"):
                self.seeds(estimator, X, labels, random_state=given)
        with pytest.raises(UsageError, match="are the same"):
            self.seeds(estimator, X, labels, random_state=3, seed=4)


def test_the_seed_of_a_model_file_is_the_random_state(X, tmp_path):
    SOM(3, 3, seed=9).fit(X).save(tmp_path / "map.somato")
    loaded = SOM.load(tmp_path / "map.somato")
    assert (loaded.random_state, loaded.seed) == (9, None)
    np.testing.assert_array_equal(clone(loaded).fit(X).weights_, SOM(3, 3, random_state=9).fit(X).weights_)


@pytest.mark.parametrize("estimator", [SOM, TMPSOM])
def test_fit_shows_its_progress_if_it_is_verbose(estimator, X, monkeypatch, capfd):
    estimator().fit(X)
    assert capfd.readouterr().err == ""
    estimator(verbose=True).fit(X)
    assert estimator.__name__ in capfd.readouterr().err
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    estimator(verbose=1).fit(X)
    assert capfd.readouterr().err.endswith(f"{estimator.__name__}: 100 %, about 0 s left\n")


class TestColumns:
    @pytest.fixture
    def table(self, X):
        pandas = pytest.importorskip("pandas")
        return pandas.DataFrame(X[:, :3], columns=["a", "b", "c"])

    @pytest.fixture
    def wider(self, table):
        return table.assign(d=range(len(table)), note="text")[["d", "note", "c", "a", "b"]]

    def test_additional_ones_are_refused_unless_they_are_ignored(self, table, wider):
        with pytest.raises(ValueError, match="d"):
            SOM(3, 3).fit(table).predict(wider[["a", "b", "c", "d"]])
        som = SOM(3, 3, extra_columns="ignore").fit(table)
        np.testing.assert_array_equal(som.predict(wider), som.predict(table))
        np.testing.assert_array_equal(som.transform(wider), som.transform(table))
        np.testing.assert_array_equal(som.partial_fit(wider).weights_,
                                      SOM(3, 3).fit(table).partial_fit(table).weights_)

    @pytest.mark.parametrize("package", ["polars", "pyarrow"])
    def test_tables_of_other_packages_too(self, table, wider, package):
        module = pytest.importorskip(package)
        convert = module.DataFrame if package == "polars" else module.Table.from_pandas
        other = convert(wider[["d", "c", "a", "b"]].reset_index(drop=True))
        som = SOM(3, 3, extra_columns="ignore").fit(table)
        np.testing.assert_array_equal(som.predict(other), som.predict(table))

    def test_missing_ones_are_named(self, table, wider):
        som = SOM(3, 3, extra_columns="ignore").fit(table)
        with pytest.raises(DataError, match="lacks columns of fit: 'a', 'c'"):
            som.predict(wider[["d", "b"]])
        twice = wider.rename(columns={"note": "a"})
        with pytest.raises(DataError, match="several columns with the name 'a'"):
            som.predict(twice)

    def test_other_words_are_refused(self, table):
        with pytest.raises(UsageError, match="'drop' is not one of refuse, ignore"):
            SOM(3, 3, extra_columns="drop").fit(table)
