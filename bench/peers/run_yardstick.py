"""Only the product of two matrices, as BLAS does it, 256 rows at a time: a lower bound for a search."""

import numpy
from serve import Job

BLOCK = 256
LARGEST = 20_000  # samples of a product; more take as much longer


def prepare(case, name):
    data = case.data[:LARGEST]
    weights = numpy.ascontiguousarray(case.initial.T)
    out = numpy.empty((BLOCK, case.neurons), dtype=numpy.float32)

    def multiply():
        for start in range(0, len(data), BLOCK):
            block = data[start:start + BLOCK]
            numpy.matmul(block, weights, out=out[:len(block)])

    return Job(multiply, None, len(data) / len(case.data))
