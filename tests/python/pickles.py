"""Writes a pickle of estimators, or reads it with another version of Python and compares.

usage: pickles.py (--write | --read) FILE
"""

import argparse
import pickle
import warnings
from pathlib import Path

import numpy as np

import pysomato


def estimators(X):
    return [pysomato.SOM(4, 5, iterations=200).fit(X, np.arange(len(X)) % 3),
            pysomato.TMPSOM((4, 4), iterations=100).fit(X)]


def predictions(fitted, X):
    return [estimator.transform(X) for estimator in fitted]


def main():
    parser = argparse.ArgumentParser(description="Writes or reads a pickle of estimators.")
    action = parser.add_mutually_exclusive_group(required=True)
    action.add_argument("--write", type=Path)
    action.add_argument("--read", type=Path)
    options = parser.parse_args()
    X = np.random.default_rng(1).random((40, 6), np.float32)
    if options.write:
        fitted = estimators(X)
        options.write.write_bytes(pickle.dumps((fitted, predictions(fitted, X)), protocol=4))
        return
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # scikit-learn of another version
        fitted, expected = pickle.loads(options.read.read_bytes())
    for activity, again, trained in zip(expected, predictions(fitted, X), predictions(estimators(X), X)):
        np.testing.assert_array_equal(again, activity)
        np.testing.assert_array_equal(trained, activity)


if __name__ == "__main__":
    main()
