"""Names of neurons, and the samples that neurons win."""

import warnings
from typing import NamedTuple

import numpy as np

from .._inputs.labels import labels_of, places_of
from .._inputs.rows import check_fitted, level_of_user
from ..errors import DataError, LabelWarning, UsageError


class Contributions(NamedTuple):
    """What separates the two neurons that decide the label of each row.

    Attributes:
        neurons: The numbers of the neuron that names the row and of the most similar one with
            another label; int64 of (samples, 2).
        distances: Their distances from the row, in the units of the map; for ``dot_product`` the
            inner products; float64 of (samples, 2).
        values: The contribution of each column. Each row sums to the difference of its distances,
            the second minus the first, for ``dot_product`` to that of the inner products, the first
            minus the second; float64 of (samples, columns).
    """

    neurons: np.ndarray
    distances: np.ndarray
    values: np.ndarray


class MapLabels:
    """The labels of ``SOM``: its methods are these."""

    def samples_of_neurons(self, X=None) -> dict:
        """The numbers of the rows that each neuron wins, ascending; neurons without rows are absent.

        Args:
            X: Rows; None: those of ``fit``.

        Raises:
            UsageError: There are no rows: ``fit`` was not called.
        """
        winners = self._winners_of(X, "samples_of_neurons")
        order = np.argsort(winners, kind="stable")
        neurons, first = np.unique(winners[order], return_index=True)
        return dict(zip(neurons.tolist(), np.split(order, first[1:])))

    def class_counts(self, X=None, y=None) -> tuple:
        """How many rows of each class each neuron wins, as in pies of a map.

        Args:
            X: Rows; None: those of ``fit``.
            y: Their labels; None: those of ``fit``. Rows without a label do not count.

        Returns:
            The labels, and int64 of (neurons, labels).

        Raises:
            UsageError: There are no rows or no labels.
        """
        winners = self._winners_of(X, "class_counts")
        names, numbers = self._labels_of_rows(X, y, len(winners))
        counts = np.zeros((self._n_features_out, len(names)), np.int64)
        np.add.at(counts, (winners[numbers >= 0], numbers[numbers >= 0]), 1)
        return names, counts

    def classify(self, X) -> np.ndarray:
        """The label of the labelled neuron most similar to each row; of (samples,).

        Raises:
            UsageError: The map was trained without labels.
        """
        X = self._checked(X)
        self._check_labelled("classify")
        return self.classes_[self.map_.classes(X, self._threads())]

    def contributions(self, X) -> Contributions:
        """How much each column separates the label of a row from the next one.

        The neurons that are compared are the labelled one most similar to the row, which names it in
        ``classify``, and the most similar one of all other labels. A positive contribution makes the
        row more similar to the first, a negative one to the other; docs/mathematics/som.md defines
        them. Missing values contribute 0 and are no part of the distances; the neurons are those
        that ``classify`` compares.

        Raises:
            UsageError: The map was trained without labels, or all its neurons have the same one.
        """
        X = self._checked(X)
        self._check_labelled("contributions")
        if len(set(self.map_.neuron_labels) - {None}) < 2:
            raise UsageError("contributions compare neurons of two labels, but all have the same",
                             f"{type(self).__name__}.contributions", "fit samples of two labels")
        return Contributions(*self.map_.contributions(X, self._threads()))

    def score(self, X, y=None) -> float:
        """The share of rows that ``classify`` names right, or without labels the negative
        quantization error; greater is better in both cases. Rows without a label do not count.

        Raises:
            UsageError: There are labels, but the map was trained without.
            DataError: No row has a label.

        Warns:
            LabelWarning: The map knows no label of y, so that the score is 0.
        """
        X = self._checked(X)
        if y is None:
            return -self.map_.quality(X, self._threads())[0]
        self._check_labelled("score")
        labels = self._labels(y, X)
        if not labels.known.any():
            raise DataError("no sample has a label", "SOM.score(y)", "pass labels, or no y")
        places = places_of(labels.names, self.classes_)
        if (places < 0).all():
            warnings.warn(_of_unknown_labels(labels.names, self.classes_), LabelWarning,
                          stacklevel=level_of_user())
        named = self.map_.classes(X, self._threads())
        return float(np.mean((named == places[labels.numbers])[labels.known]))

    def _winners_of(self, X, method):
        """The winners of the rows of X, or else those of fit."""
        if X is not None:
            return self.map_.winners(self._checked(X), self._threads())
        check_fitted(self, "map_")
        if not hasattr(self, "winners_"):
            raise UsageError("the map does not contain the rows that it was trained on",
                             f"{type(self).__name__}.{method}", "pass X")
        return self.winners_

    def _labels_of_rows(self, X, y, rows):
        """The labels of rows of X, or else those of fit: the distinct ones, and a number for each row."""
        where = f"{type(self).__name__}.class_counts"
        if y is not None:
            labels = labels_of(y, rows, self.unlabelled, "y")
            return labels.names, labels.numbers
        if X is not None or not hasattr(self, "_classes_of_samples"):
            raise UsageError("there are no labels", where, "pass y")
        return self.classes_, self._classes_of_samples

    def _labels_to_learn(self, y, X):
        return self._labels(y, X)

    def _labels(self, y, X):
        return labels_of(y, len(X), self.unlabelled, "y")

    def _check_labelled(self, method):
        if not hasattr(self, "classes_"):
            raise UsageError("the neurons have no labels", f"{type(self).__name__}.{method}",
                             "pass labels to fit as y")


def _of_unknown_labels(names, known):
    few = 3
    texts = [", ".join(f"'{name}'" for name in some[:few]) + (", ..." if len(some) > few else "")
             for some in (names, known)]
    return (f"the map knows no label of y ({texts[0]}), so that the score is 0; its labels are "
            f"{texts[1]}. Folds of samples that are sorted by class need "
            "cv=StratifiedKFold(n), or GroupKFold with a group for each trial")
