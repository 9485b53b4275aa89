"""A self-organizing map as a classifier of scikit-learn."""

import numpy as np
from sklearn.base import ClassifierMixin
from sklearn.utils.multiclass import check_classification_targets

from ._inputs.labels import Labels
from .errors import DataError, DataTypeError, UsageError, errors_of_sklearn
from .som import SOM


class SOMClassifier(ClassifierMixin, SOM):
    """A self-organizing map that predicts labels.

    Parameters, attributes and methods are those of ``SOM``, except those that follow here. The map
    is trained without the labels, unless ``refine`` is set; they name its neurons afterwards. Samples of ``fit`` without a
    label are learned, and name no neuron.

    Attributes:
        classes_: The labels, ascending; after ``load`` texts, in the order of the model file.
    """

    def fit(self, X, y=None) -> "SOMClassifier":
        """Trains a new map on the rows of X and names its neurons by the labels y.

        Args:
            X: Numbers of (samples, columns), at least two samples.
            y: Labels of (samples,), at least one of which is known.

        Raises:
            UsageError: As for ``SOM.fit``; or there is no y.
            DataError: As for ``SOM.fit``; or no sample has a label, or the labels are no classes.
        """
        if y is None:
            raise UsageError("SOMClassifier requires y to be passed, but the target y is None",
                             "SOMClassifier.fit", "pass a label for each sample, or use SOM")
        super().fit(X, y)
        known = self._classes_of_samples >= 0
        self._votes = np.zeros((self._n_features_out, len(self.classes_)), np.int64)
        np.add.at(self._votes, (self.winners_[known], self._classes_of_samples[known]), 1)
        return self

    @property
    def partial_fit(self):
        """Not available: labels name the neurons of a map that has been trained."""
        raise AttributeError("SOMClassifier is trained by fit; SOM.partial_fit learns further samples")

    def predict(self, X) -> np.ndarray:
        """The label of the labelled neuron most similar to each row; of (samples,)."""
        return self.classify(X)

    def predict_proba(self, X) -> np.ndarray:
        """The shares of the classes among the training samples that this neuron won.

        Returns:
            Shares between 0 and 1, which sum to 1 for each row, in the order of ``classes_``;
            float64 of (samples, classes).

        Raises:
            UsageError: The map was loaded from a model file, which does not contain them.
        """
        X = self._checked(X)
        self._check_labelled("predict_proba")
        if not hasattr(self, "_votes"):
            raise UsageError("a model file does not contain how many samples each neuron won",
                             "SOMClassifier.predict_proba", "pickle the estimator, or call fit")
        votes = self._votes[self.map_.labelled_winners(X, self._threads())]
        return votes / votes.sum(axis=1, keepdims=True)

    def score(self, X, y) -> float:
        """The share of rows with a label that ``predict`` names right; warns as ``SOM.score``."""
        return SOM.score(self, X, y)

    def _labels(self, y, X):
        """The labels in ascending order, as scikit-learn requires them."""
        labels = super()._labels(y, X)
        try:
            names, places = np.unique(labels.names, return_inverse=True)
        except TypeError as error:
            raise DataTypeError("its labels cannot be ordered", "y",
                                "use labels of one type, such as texts") from error
        return Labels(names, np.append(places, -1)[labels.numbers])  # -1 is no label in both

    def _labels_to_learn(self, y, X):
        labels = self._labels(y, X)
        if not labels.known.any():
            raise DataError("no sample has a label", "SOMClassifier.fit(y)", "use SOM")
        with errors_of_sklearn("y", "pass texts or whole numbers"):
            check_classification_targets(labels.names[labels.numbers[labels.known]])
        return labels

    def _forget(self):
        super()._forget()
        self.__dict__.pop("_votes", None)
