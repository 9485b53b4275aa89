"""Folds that keep neighbouring explorations together, and folds that do not."""

import numpy as np

FOLDS = 5


def positions_in_class(labels):
    """The position of each sample among those of its class, and the size of its class."""
    labels = np.asarray(labels)
    position, size = np.empty(len(labels), int), np.empty(len(labels), int)
    for name in np.unique(labels):
        members = np.flatnonzero(labels == name)
        position[members], size[members] = np.arange(len(members)), len(members)
    return position, size


def blocks(labels, folds=FOLDS):
    """The fold of each sample: the samples of a class, in recorded order, are divided into
    consecutive blocks of equal size. A class with fewer samples than folds is absent from some folds.
    """
    position, size = positions_in_class(labels)
    return position * folds // size


def interleaved(labels, folds=FOLDS):
    """The fold of each sample: the k-th sample of each class belongs to fold k modulo the number of folds."""
    return positions_in_class(labels)[0] % folds


def divisions(fold_of_sample):
    """The training and the test samples of each fold, as arrays of indices. A fold without training or
    test samples is left out.
    """
    for fold in np.unique(fold_of_sample):
        test = np.flatnonzero(fold_of_sample == fold)
        train = np.flatnonzero(fold_of_sample != fold)
        if len(train):
            yield train, test
