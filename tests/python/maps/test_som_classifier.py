"""The map as a classifier."""

import pickle

import numpy as np
import pytest
from sklearn.metrics import confusion_matrix
from sklearn.model_selection import StratifiedKFold, cross_val_predict
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler

from pysomato import SOM, DataError, SOMClassifier, UsageError


def test_the_map_is_that_of_the_estimator_without_labels(X, labels):
    names = np.array([str(label) for label in labels])
    plain = SOM(4, 5, iterations=400).fit(X, names)
    classifier = SOMClassifier(4, 5, iterations=400).fit(X, names)
    np.testing.assert_array_equal(classifier.weights_, plain.weights_)
    np.testing.assert_array_equal(classifier.predict(X), plain.classify(X))
    np.testing.assert_array_equal(classifier.transform(X), plain.transform(X))
    assert classifier.score(X, names) == plain.score(X, names)


def test_probabilities_are_the_shares_of_the_samples_that_the_neuron_won(X, labels):
    classifier = SOMClassifier(2, 2, iterations=400).fit(X, labels)
    np.testing.assert_array_equal(classifier.classes_, np.unique(labels))
    weights = classifier.weights_.astype(float)
    won = np.array([np.argmin(((weights - row) ** 2).sum(axis=1)) for row in X])
    given = classifier.predict_proba(X)
    for row in range(len(X)):
        own = np.asarray(labels)[won == won[row]]
        shares = [np.mean(own == label) for label in classifier.classes_]
        np.testing.assert_allclose(given[row], shares)
        assert classifier.predict(X)[row] == classifier.classes_[np.argmax(given[row])]


def test_neurons_without_samples_predict_nothing(X, labels):
    classifier = SOMClassifier(9, 9, iterations=400).fit(X, labels)
    assert (classifier.hits_ == 0).any()
    empty = classifier.weights_[classifier.hits_ == 0]
    np.testing.assert_allclose(classifier.predict_proba(empty).sum(axis=1), 1.0)


def test_folds_and_confusions_in_a_pipeline(X, labels):
    pipeline = make_pipeline(StandardScaler(), SOMClassifier(5, 5, iterations=500))
    predicted = cross_val_predict(pipeline, X, labels, cv=StratifiedKFold(5, shuffle=True, random_state=1))
    confused = confusion_matrix(labels, predicted)
    assert confused.sum() == len(X)
    assert np.trace(confused) > 0.5 * len(X)


def test_samples_without_a_label_are_learned_and_name_nothing(X):
    names = np.array(["left"] * 30 + [None] * 10 + ["right"] * 20, dtype=object)
    classifier = SOMClassifier(4, 4, iterations=300).fit(X, names)
    np.testing.assert_array_equal(classifier.weights_, SOM(4, 4, iterations=300).fit(X).weights_)
    assert list(classifier.classes_) == ["left", "right"]
    assert set(classifier.predict(X)) <= {"left", "right"}
    with pytest.raises(DataError, match="no sample has a label"):
        SOMClassifier().fit(X, [None] * 60)


def test_a_model_file_predicts_and_a_pickle_also_has_the_shares(X, labels, tmp_path):
    names = np.array([f"thing {label}" for label in labels])
    classifier = SOMClassifier(4, 4, iterations=300).fit(X, names)
    classifier.save(tmp_path / "map.somato")
    loaded = SOMClassifier.load(tmp_path / "map.somato")
    np.testing.assert_array_equal(loaded.predict(X), classifier.predict(X))
    with pytest.raises(UsageError, match="model file"):
        loaded.predict_proba(X)
    copied = pickle.loads(pickle.dumps(classifier))
    np.testing.assert_array_equal(copied.predict_proba(X), classifier.predict_proba(X))


def test_what_is_no_class_is_refused(X):
    with pytest.raises(ValueError, match="requires y"):
        SOMClassifier().fit(X)
    with pytest.raises(ValueError, match="continuous"):
        SOMClassifier().fit(X, np.linspace(0.0, 1.0, len(X)))
    with pytest.raises(TypeError, match="cannot be ordered"):
        SOMClassifier().fit(X, ["a"] * 30 + [1] * 30)
    assert not hasattr(SOMClassifier(), "partial_fit")


def test_many_classes_are_no_reason_to_warn(recwarn):
    rows = np.random.default_rng(1).normal(size=(250, 3))
    labels = np.arange(250) % 25
    SOMClassifier(4, 4, iterations=100).fit(rows, labels).score(rows, labels)
    assert not [str(one.message) for one in recwarn]
