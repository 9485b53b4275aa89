"""The Python package of Somato."""

import pysomato
from serve import Job


def prepare(case, name):
    state = {}

    def train():
        state["som"] = pysomato.SOM(
            case.rows, case.columns, training="batch", epochs=case.steps, radius_start=case.radius_start,
            radius_end=case.radius_end, radius_reached_at=max(1, case.steps - 1),  # in the last epoch
            initial_weights="samples", threads=case.threads).fit(case.data)

    return Job(train, lambda: state["som"].weights_)
