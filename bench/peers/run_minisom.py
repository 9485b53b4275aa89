"""MiniSom: numpy, a sample at a time."""

import numpy
from minisom import MiniSom
from serve import Job

PART_OF_SAMPLES = 100  # of batch training, whose time is proportional to the samples
PART_OF_STEPS = 100


def prepare(case, name):
    data = case.data
    part = 1.0
    steps = case.steps
    if case.batch and name != "winners" and not case.whole:
        data = data[:max(10, len(data) // PART_OF_SAMPLES)]
        part = len(data) / len(case.data)
    elif case.sparse:
        steps = max(2, case.steps // PART_OF_STEPS)
        part = steps / case.steps
    state = {}

    def make():
        som = MiniSom(case.rows, case.columns, case.features, sigma=case.radius_start,
                      learning_rate=1.0 if case.batch else case.learning_rate_start,
                      decay_function=(lambda rate, step, steps: rate) if case.batch
                      else "linear_decay_to_zero",
                      sigma_decay_function="linear_decay_to_one",
                      topology="hexagonal" if case.hexagonal else "rectangular")
        som._weights = case.initial.reshape(case.rows, case.columns, case.features).astype(
            numpy.float64)
        return som

    def train():
        state["som"] = make()
        if case.batch:
            state["som"].train_batch_offline(data, steps)
        else:
            state["som"].train(data, steps, random_order=True)

    if name == "winners":
        som = make()
        return Job(lambda: som.quantization(case.data))
    return Job(train, lambda: state["som"].get_weights(), part)
