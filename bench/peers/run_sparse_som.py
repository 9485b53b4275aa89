"""sparse-som: online and batch training on sparse samples."""

import numpy
import scipy.sparse
import sparse_som
from serve import Job


def prepare(case, name):
    data = scipy.sparse.csr_matrix(case.data, dtype=numpy.float32)
    kind = sparse_som.BSom if case.batch else sparse_som.Som
    state = {}

    def make():
        state["som"] = kind(case.rows, case.columns, case.features)

    make()

    # If creating the map does not count, training continues with the existing map, which takes as long.
    def train():
        if name != "sparse_streaming":
            make()
        if case.batch:
            state["som"].train(data, case.steps, case.radius_start, case.radius_end, std=1.0)
        else:
            state["som"].train(data, case.steps, case.radius_start, case.learning_rate_start,
                               case.radius_end, case.learning_rate_end, std=1.0)

    return Job(train, lambda: state["som"].codebook)
