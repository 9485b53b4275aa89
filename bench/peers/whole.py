"""Finds the winners of samples on a trained map as a whole process: reads, searches and writes.

usage: whole.py PROGRAM TASK FOLDER THREADS

FOLDER holds samples.npy, and map.som with its weights in weights.npy, as `whole.py pysomato prepare` writes
them. Each program writes its winners to winners-PROGRAM.npy, and pysomato the result of TASK.
"""

import sys
from pathlib import Path

import numpy

ROWS, COLUMNS = 50, 50
PART = 4096  # samples that MiniSom takes at once: with all, its distances fill 6 GB
LEARNED, CLASSES = 5000, 10  # samples that the map learns, and their labels


def xpysom(samples, weights, threads):
    from xpysom import XPySom
    som = XPySom(ROWS, COLUMNS, samples.shape[1])
    som._weights = weights.reshape(ROWS, COLUMNS, -1)
    return numpy.array([row * COLUMNS + column for row, column in som.winner(samples)])


def minisom(samples, weights, threads):
    from minisom import MiniSom
    som = MiniSom(ROWS, COLUMNS, samples.shape[1])
    som._weights = weights.reshape(ROWS, COLUMNS, -1).astype(numpy.float64)
    parts = [samples[first:first + PART] for first in range(0, len(samples), PART)]
    return numpy.concatenate([numpy.argmin(som._distance_from_weights(part), axis=1) for part in parts])


def faiss(samples, weights, threads):
    import faiss as library
    library.omp_set_num_threads(threads)
    index = library.IndexFlatL2(samples.shape[1])
    index.add(weights)
    return index.search(samples, 1)[1][:, 0]


def search(program, folder, threads):
    found = program(numpy.load(folder / "samples.npy"), numpy.load(folder / "weights.npy"), threads)
    numpy.save(folder / f"winners-{program.__name__}.npy", numpy.asarray(found, numpy.int64))


def prepare(folder):
    """A map with labels, some of whose neurons have none."""
    import pysomato
    learned = numpy.load(folder / "samples.npy")[:LEARNED]
    som = pysomato.SOM(ROWS, COLUMNS, training="batch", epochs=5)
    som.fit(learned, [f"class {int(value * CLASSES)}" for value in learned[:, 0]])
    som.save(folder / "map.som")
    numpy.save(folder / "weights.npy", som.weights_)


def of_pysomato(task, folder, threads):
    import pysomato
    som = pysomato.SOM.load(folder / "map.som")
    som.set_params(threads=threads)
    found = getattr(som, task)(numpy.load(folder / "samples.npy"))
    numpy.save(folder / f"{task}-pysomato.npy", found.astype(str) if found.dtype == object else found)


def main():
    name, task, folder, threads = sys.argv[1:]
    folder = Path(folder)
    if name != "pysomato":
        search({"xpysom": xpysom, "minisom": minisom, "faiss": faiss}[name], folder, int(threads))
    elif task == "prepare":
        prepare(folder)
    else:
        of_pysomato(task, folder, int(threads))


if __name__ == "__main__":
    main()
