"""The estimators in scikit-learn: its own checks, pipelines, searches, pickles."""

import copy
import pickle

import numpy as np
import pytest
from sklearn.base import clone
from sklearn.model_selection import GridSearchCV, GroupKFold, cross_val_score
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler
from sklearn.utils.estimator_checks import parametrize_with_checks

from pysomato import SOM, TMPSOM, OneHot, SOMClassifier, SOMClusterer, Spectrum, TensorProduct


@parametrize_with_checks([SOM(4, 4, iterations=100, threads=1), SOMClassifier(4, 4, iterations=500, threads=1),
                          SOMClusterer(6, 6, iterations=500, threads=1),
                          TMPSOM((3, 4), iterations=100), OneHot(), TensorProduct(), Spectrum(100, bands=4)])
def test_scikit_learns_checks(estimator, check):
    check(estimator)


def test_pipelines_groups_and_searches(X, labels):
    pipeline = make_pipeline(StandardScaler(), SOM(5, 5, iterations=500))
    scores = cross_val_score(pipeline, X, labels, groups=np.arange(60) // 12, cv=GroupKFold(5))
    assert scores.min() > 0.5
    pipeline = make_pipeline(StandardScaler(), SOM(columns=1, iterations=500))
    search = GridSearchCV(pipeline, {"som__rows": [1, 5], "som__seed": np.array([1, 2])}, cv=3)
    assert search.fit(X, labels).best_params_["som__rows"] == 5


def test_columns_have_names(X):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(X, columns=[f"joint{i}" for i in range(7)])
    som = SOM(2, 3).set_output(transform="pandas")
    activity = som.fit_transform(frame)
    assert list(activity.columns) == [f"som{i}" for i in range(6)]
    assert list(activity.columns) == list(som.get_feature_names_out())
    assert som.map_.features == list(frame.columns)
    with pytest.raises(ValueError, match="feature names"):
        som.predict(frame.rename(columns={"joint0": "other"}))


def test_names_of_columns_are_saved(X, tmp_path):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(X, columns=[f"joint{i}" for i in range(7)])
    SOM(2, 3).fit(frame).save(tmp_path / "map.somato")
    loaded = SOM.load(tmp_path / "map.somato")
    assert list(loaded.feature_names_in_) == list(frame.columns)
    np.testing.assert_array_equal(loaded.predict(frame), SOM(2, 3).fit(frame).predict(frame))


@pytest.mark.parametrize("copied", [copy.deepcopy, lambda som: pickle.loads(pickle.dumps(som))])
def test_copies_are_the_same_map(X, labels, copied):
    som = SOM(4, 4, iterations=300).fit(X, labels)
    other = copied(som)
    np.testing.assert_array_equal(other.weights_, som.weights_)
    np.testing.assert_array_equal(other.classify(X), som.classify(X))
    np.testing.assert_array_equal(other.partial_fit(X).weights_, som.partial_fit(X).weights_)


def test_a_pickle_of_an_earlier_version_lacks_parameters(X, labels):
    for estimator in (SOM(4, 4, iterations=100), SOMClassifier(4, 4, iterations=100)):
        estimator.fit(X, labels)
        for name in ("size", "refine_relevance_rate"):
            del estimator.__dict__[name]
        loaded = pickle.loads(pickle.dumps(estimator))
        assert clone(loaded).get_params()["size"] == "by_number"
        assert loaded.refine_relevance_rate == 0.03


def test_a_pickle_contains_the_model_file(X, tmp_path):
    som = SOM(4, 4, iterations=300).fit(X)
    som.save(tmp_path / "map.somato")
    assert (tmp_path / "map.somato").read_bytes() in pickle.dumps(som, protocol=4)


def test_a_clone_is_not_trained(X):
    assert not hasattr(clone(SOM(4, 4).fit(X)), "map_")
