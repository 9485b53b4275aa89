"""Classifiers that are compared. Each learns a training part and names the samples of a test part.

A method is a function of (vectors, labels, test vectors, seed), which returns the labels that it gives to
the test vectors and the number of vectors of the samples' length that it keeps for this. It sees vectors in
the units of the sensors, so that means and deviations are those of the training part.
"""

import inspect
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import numpy as np
from sklearn.discriminant_analysis import LinearDiscriminantAnalysis
from sklearn.neighbors import KNeighborsClassifier
from sklearn.preprocessing import StandardScaler
from sklearn.svm import SVC

import pysomato

from . import block_folds

SEEDS = 20
CANDIDATES = tuple((metric, scale) for metric in ("euclidean", "manhattan") for scale in ("raw", "standardized"))
GROWING = """[study]
name = "growing"
label = "label"
protocols = ["train_is_test"]

[module.columns]
type = "channel"
channel = "columns"

[module.vector]
type = "last"
input = "columns"

[module.map]
type = "growing_when_required"
input = "vector"
activity_threshold = 0.4
habituation_threshold = 2.0
insertion_share = 1.0
"""
BY_NAMES = "by_names = true\n"  # of growing_when_required
SHARED = (GROWING.replace("activity_threshold = 0.4", "activity_threshold = 0.22") + BY_NAMES
          + 'most_share = 0.3\nsimilarity = "manhattan"\nrefine = "glvq"\n')


class MissingFeature(Exception):
    """The installed pysomato lacks what a method requires."""


@dataclass(frozen=True)
class Method:
    """`classify` as above, and its settings, on which stored cells depend.

    `text` names it in tables. `is_random`: the seed affects the result. `like`: the nearest neighbour with
    the distance and the scale of a map. `groups`: the groups of sets that it is used for. `check` raises
    MissingFeature.
    """
    name: str
    text: str
    settings: str
    classify: Callable
    is_random: bool = False
    uses_somato: bool = False
    like: str = ""
    groups: tuple = ("touch", "points")
    folds: Callable = block_folds.blocks
    check: Callable = lambda: None


def standardized(train, test):
    """Both parts with the means and deviations of the training part; constant columns become 0."""
    scaler = StandardScaler().fit(train)
    return scaler.transform(train), scaler.transform(test)


def scaled(train, test, scale):
    return standardized(train, test) if scale == "standardized" else (train, test)


# Nearest neighbours

def neighbour(metric, scale):
    def classify(train, labels, test, seed):
        train, test = scaled(train, test, scale)
        found = KNeighborsClassifier(1, metric=metric, algorithm="brute").fit(train, labels).predict(test)
        return found, len(train)
    return classify


def accuracy_within(classify, train, labels, seed):
    """The accuracy of a method on block folds of the training part."""
    right = [classify(train[inner], labels[inner], train[held], seed)[0] == labels[held]
             for inner, held in block_folds.divisions(block_folds.blocks(labels))]
    return np.concatenate(right).mean()


def chosen_candidate(train, labels):
    """The distance and the scale with the highest accuracy inside the training part; the first in a tie."""
    accuracies = [accuracy_within(neighbour(*candidate), train, labels, 0) for candidate in CANDIDATES]
    return CANDIDATES[int(np.argmax(accuracies))]


def best_neighbour(train, labels, test, seed):
    return neighbour(*chosen_candidate(train, labels))(train, labels, test, seed)


def half_of_samples(train, labels, test, seed):
    """The same, which keeps a random half of the samples of each class, at least one."""
    random = np.random.default_rng(seed)
    kept = np.concatenate([random.permutation(np.flatnonzero(labels == name))[:max(1, np.sum(labels == name) // 2)]
                           for name in np.unique(labels)])
    kept.sort()
    return neighbour(*chosen_candidate(train, labels))(train[kept], labels[kept], test, seed)


# Other classifiers

def linear_discriminant(train, labels, test, seed):
    train, test = standardized(train, test)
    model = LinearDiscriminantAnalysis(solver="lsqr", shrinkage="auto").fit(train, labels)
    return model.predict(test), len(model.means_)


def support_vectors(train, labels, test, seed):
    train, test = standardized(train, test)
    model = SVC(C=10.0, kernel="rbf", gamma="scale").fit(train, labels)
    return model.predict(test), len(model.support_vectors_)


# Maps

def neurons(model):
    return len(model.positions_)


def som(most_share=None, **parameters):
    """A map of standardized vectors with the defaults of pysomato, except for `parameters`. With
    `most_share` it has at most this share of the training samples as neurons."""
    def classify(train, labels, test, seed):
        train, test = standardized(train, test)
        sides = {} if most_share is None else sides_within(most_share, len(train))
        model = pysomato.SOMClassifier(**sides, **parameters, random_state=seed, threads=1)
        model.fit(train.astype(np.float32), labels)
        return model.predict(test.astype(np.float32)), neurons(model) + hasattr(model, "relevances_")
    return classify


def sides_within(share, samples):
    """Rows and columns of the greatest approximately square map with at most so many neurons, with the
    iterations and the final radius of a map of automatic size."""
    most = max(2, int(share * samples))
    rows = max(1, int(np.sqrt(most)))
    columns = most // rows
    return {"rows": rows, "columns": columns, "iterations": max(20000, 100 * rows * columns), "radius_end": 0.5}


def rows_of(vectors, labels):
    """A recording as a table of numbers gives it: an exploration of one frame for each row."""
    return pysomato.Recording.from_table(vectors.astype(np.float32), labels=labels)


def study_of(recording, system, seed):
    """A system that has learned all explorations of a recording."""
    return pysomato.study(recording, system, threads=1, progress=False, protocols=["train_is_test"], seeds=1,
                          first_seed=seed)


_suggestions = {}  # by the values of the vectors: labels do not affect a suggestion, and seeds neither


def suggestion(values, recording):
    if values not in _suggestions:
        _suggestions[values] = pysomato.suggest(recording, label="label", threads=1, progress=False)
    return _suggestions[values]


def suggested(train, labels, test, seed):
    """The system that `suggest` writes for the training part, which it sees as a table, in the sensors' units."""
    recording = rows_of(train, labels)
    outcome = study_of(recording, suggestion(train.tobytes(), recording), seed)
    answers = outcome.system.answers(rows_of(test, np.full(len(test), "unknown")), threads=1)
    return answers["nearest"].to_numpy(), neurons(outcome.som)


def growing(text):
    def classify(train, labels, test, seed):
        train, test = standardized(train, test)
        grown = grown_map(text, train, labels, seed)
        return grown.classify(test.astype(np.float32)), neurons(grown)
    return classify


def system_of(text):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "system.toml")
        file.write_text(text, encoding="utf-8")
        return pysomato.System(file)


def grown_map(text, train, labels, seed):
    """The map of a system like GROWING that has learned the rows of `train`, named by their labels. It may
    have as many neurons as rows."""
    system = system_of(f"{text}most_neurons = {len(train)}\n")
    return study_of(rows_of(train, labels), system, seed).som


def needs_keys(text):
    """Keys of modules are checked when a system is trained."""
    def check():
        try:
            grown_map(text, np.eye(4), np.array(["a", "a", "b", "b"]), 1)
        except pysomato.UsageError as error:
            raise MissingFeature(f"growing_when_required of pysomato {pysomato.__version__}: {error}") from error
    return check


def needs(parameter):
    """A check that SOM has this parameter."""
    def check():
        if parameter not in inspect.signature(pysomato.SOM.__init__).parameters:
            raise MissingFeature(f"pysomato {pysomato.__version__} has no SOM({parameter}=...)")
    return check


ALL = ("touch", "points", "early")
EUCLIDEAN, MANHATTAN = "euclidean_standardized", "manhattan_standardized"
HALF = "at most half as many neurons as samples"
METHODS = {method.name: method for method in (
    Method("default", "map", "SOMClassifier(), standardized", som(),
           is_random=True, uses_somato=True, like=EUCLIDEAN, groups=ALL),
    Method("manhattan", "map, Manhattan", 'SOMClassifier(similarity="manhattan"), standardized',
           som(similarity="manhattan"), is_random=True, uses_somato=True, like=MANHATTAN),
    Method("measured", "map of measured size, Manhattan",
           'SOMClassifier(size="measured", similarity="manhattan"), standardized',
           som(size="measured", similarity="manhattan"), is_random=True, uses_somato=True, like=MANHATTAN,
           check=needs("size")),
    Method("suggested", "system of `suggest`", "suggest(label=...), raw", suggested,
           is_random=True, uses_somato=True, groups=("touch",)),
    Method("refined", "map, refined", f'SOMClassifier(refine="glvq"), {HALF}, standardized', som(0.5, refine="glvq"),
           is_random=True, uses_somato=True, like=EUCLIDEAN, groups=ALL, check=needs("refine")),
    Method("refined_manhattan", "map, Manhattan, refined",
           f'SOMClassifier(refine="glvq", similarity="manhattan"), {HALF}, standardized',
           som(0.5, refine="glvq", similarity="manhattan"),
           is_random=True, uses_somato=True, like=MANHATTAN, check=needs("refine")),
    Method("relevance", "map, relevances", f'SOMClassifier(refine="grlvq"), {HALF}, standardized',
           som(0.5, refine="grlvq"), is_random=True, uses_somato=True, like=EUCLIDEAN,
           check=needs("refine_relevance_rate")),
    Method("relevance_manhattan", "map, Manhattan, relevances",
           f'SOMClassifier(refine="grlvq", similarity="manhattan"), {HALF}, standardized',
           som(0.5, refine="grlvq", similarity="manhattan"),
           is_random=True, uses_somato=True, like=MANHATTAN, check=needs("refine_relevance_rate")),
    Method("growing", "growing map",
           f"growing_when_required as in docs/continual.md, most_neurons = samples, standardized\n{GROWING}",
           growing(GROWING), is_random=True, uses_somato=True, like=EUCLIDEAN, groups=ALL),
    Method("growing_by_names", "growing map, by names", f"the same with {BY_NAMES}{GROWING}",
           growing(GROWING + BY_NAMES), is_random=True, uses_somato=True, like=EUCLIDEAN, groups=ALL,
           check=needs_keys(GROWING + BY_NAMES)),
    Method("growing_refined", "growing map, by names, refined",
           f"at most 30 % of each class, Manhattan, refined, most_neurons = samples, standardized\n{SHARED}",
           growing(SHARED), is_random=True, uses_somato=True, like=MANHATTAN, check=needs_keys(SHARED)),
    Method("best_neighbour", "best nearest neighbour", "distance and scale chosen inside the training part",
           best_neighbour, groups=ALL),
    *(Method(f"{metric}_{scale}", f"nearest neighbour, {metric.capitalize()}, {scale}", "KNeighborsClassifier(1)",
             neighbour(metric, scale)) for metric, scale in CANDIDATES),
    Method("half_of_samples", "best nearest neighbour, random half", "a random half of each class", half_of_samples,
           is_random=True),
    Method("linear_discriminant", "linear discriminant",
           'LinearDiscriminantAnalysis(solver="lsqr", shrinkage="auto"), standardized', linear_discriminant),
    Method("support_vectors", "SVM", 'SVC(C=10, kernel="rbf", gamma="scale"), standardized', support_vectors,
           groups=ALL),
    Method("best_neighbour_interleaved", "best nearest neighbour, interleaved folds",
           "distance and scale chosen inside the training part, by blocks", best_neighbour,
           groups=("touch",), folds=block_folds.interleaved))}
