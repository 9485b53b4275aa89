"""The cells of the study: which sets, methods and clusterers there are, and how each cell is computed."""

import functools
import hashlib
import json
import time
import warnings
from pathlib import Path

import numpy as np
import sklearn

import pysomato

from . import block_folds, clusterers, data, methods
from .cells import Cell

VERSION = 2  # of the content of a cell; increase it when the content changes
CLUSTERED = (data.early_name(1.0, False), data.early_name(1.0, True))


@functools.cache
def library_hash():
    """The first digits of the SHA-256 of the installed package, on which all maps depend."""
    folder = Path(pysomato.__file__).parent
    digest = hashlib.sha256()
    files = sorted([*folder.glob("_somato*.so"), *folder.glob("*.py")])
    for file in filter(Path.is_file, files):  # a build keeps links to modules that were moved
        digest.update(file.read_bytes())
    return digest.hexdigest()[:12]


def stored_vectors(out, name):
    return Path(out, "vectors", f"{name}.npz")


def load_vectors(out, name):
    with np.load(stored_vectors(out, name)) as file:
        return data.Samples(file["vectors"], file["labels"])


def make_vectors(folder, out, names):
    """Reads sets and stores their vectors, which processes read; returns the samples by name."""
    made = {}
    for name in names:
        samples = data.SETS[name].read(Path(folder, data.SETS[name].place))
        stored_vectors(out, name).parent.mkdir(parents=True, exist_ok=True)
        np.savez(stored_vectors(out, name), vectors=samples.vectors, labels=samples.labels)
        made[name] = samples
    return made


def run_of_folds(method, samples, seed):
    """The accuracy over the samples of all folds, each tested once; the accuracy on the samples that were
    learned (`learned`); the mean number of vectors kept and of training samples, and the mean seconds of
    learning and naming, of a fold.
    """
    right, known, kept, trained, seconds = [], [], [], [], []
    for train, test in block_folds.divisions(method.folds(samples.labels)):
        named = np.concatenate([test, train])
        begin = time.process_time()
        found, vectors = method.classify(samples.vectors[train], samples.labels[train], samples.vectors[named], seed)
        seconds.append(time.process_time() - begin)
        is_right = found == samples.labels[named]
        right.append(is_right[:len(test)])
        known.append(is_right[len(test):])
        kept.append(int(vectors))
        trained.append(len(train))
    return {"seed": seed, "accuracy": float(np.concatenate(right).mean()),
            "learned": float(np.concatenate(known).mean()), "kept": float(np.mean(kept)),
            "trained": float(np.mean(trained)), "seconds": float(np.mean(seconds))}


def size_of(samples):
    return {"samples": len(samples.labels), "classes": len(np.unique(samples.labels)),
            "columns": samples.vectors.shape[1]}


def classification(out, set_name, method_name, seeds):
    """The content of a cell of a set and a method."""
    method, samples = methods.METHODS[method_name], load_vectors(out, set_name)
    used = range(1, seeds + 1) if method.is_random else [1]
    warnings.simplefilter("ignore", pysomato.LabelWarning)  # the empty hand of the iCub is a class called "none"
    return {**size_of(samples), "is_random": method.is_random,
            "runs": [run_of_folds(method, samples, seed) for seed in used]}


def clustering(out, set_name, clusterer_name, seeds):
    """The content of a cell of a set and a clusterer."""
    samples = load_vectors(out, set_name)
    vectors, _ = methods.standardized(samples.vectors, samples.vectors)
    cluster = clusterers.CLUSTERERS[clusterer_name].cluster
    return {**size_of(samples), "runs": [{"seed": seed, **clusterers.agreement(samples.labels, cluster(vectors, seed))}
                                         for seed in range(1, seeds + 1)]}


def identity(samples, entry, seeds):
    library = f"pysomato {library_hash()}" if entry.uses_somato else f"scikit-learn {sklearn.__version__}"
    return {"data": samples.hash(), "version": VERSION, "settings": entry.settings, "seeds": seeds,
            "folds": block_folds.FOLDS, "library": library}


def methods_of(set_name, chosen):
    """The chosen methods that a set is compared by."""
    return [name for name in chosen if data.SETS[set_name].group in methods.METHODS[name].groups]


def describe(out, seeds):
    """Writes the names and words of all sets, methods and clusterers, from which the page is made."""
    content = {
        "seeds": seeds, "folds": block_folds.FOLDS, "pysomato": pysomato.__version__,
        "scikit-learn": sklearn.__version__,
        "sets": [{"name": one.name, "text": one.text, "group": one.group} for one in data.SETS.values()],
        "methods": [{"name": one.name, "text": one.text, "settings": one.settings, "like": one.like,
                     "is_map": one.uses_somato, "groups": one.groups} for one in methods.METHODS.values()],
        "clustered": CLUSTERED,
        "clusterers": [{"name": one.name, "text": one.text} for one in clusterers.CLUSTERERS.values()]}
    Path(out).mkdir(parents=True, exist_ok=True)
    Path(out, "study.json").write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")


def cells(out, made, chosen, seeds):
    """All cells of the sets in `made` and of the chosen methods, and of the clusterers."""
    found = []
    for name, samples in made.items():
        for method in methods_of(name, chosen):
            found.append(Cell(Path(out, "accuracy", name, f"{method}.json"),
                              identity(samples, methods.METHODS[method], seeds),
                              classification, (out, name, method, seeds)))
        for clusterer in clusterers.CLUSTERERS.values() if name in CLUSTERED else ():
            found.append(Cell(Path(out, "clusters", name, f"{clusterer.name}.json"),
                              identity(samples, clusterer, seeds),
                              clustering, (out, name, clusterer.name, seeds)))
    return found
