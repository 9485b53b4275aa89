"""FAISS: a search for the nearest of some points."""

import faiss
from serve import Job


def prepare(case, name):
    faiss.omp_set_num_threads(case.threads)
    index = faiss.IndexFlatL2(case.features)
    index.add(case.initial)
    return Job(lambda: index.search(case.data, 1))
