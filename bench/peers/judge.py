"""Prints the quantization error of a map: the mean distance of samples from their winners.

usage: judge.py WEIGHTS.npy SAMPLES.npy
"""

import sys

import numpy

BLOCK = 500

weights = numpy.load(sys.argv[1]).astype(numpy.float64)
samples = numpy.load(sys.argv[2], mmap_mode="r")
squares = (weights * weights).sum(axis=1)
total = 0.0
for start in range(0, len(samples), BLOCK):
    block = samples[start:start + BLOCK].astype(numpy.float64)
    winners = (squares - 2 * block @ weights.T).argmin(axis=1)
    total += numpy.linalg.norm(block - weights[winners], axis=1).sum()
print(total / len(samples))
