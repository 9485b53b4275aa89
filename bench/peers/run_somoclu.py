"""somoclu: batch training by OpenMP."""

import numpy
import somoclu
from serve import Job

EPOCHS_FOR_ONLINE = 50


def prepare(case, name):
    epochs = case.steps if case.batch else EPOCHS_FOR_ONLINE
    part = 1.0
    if case.sparse:  # its sparse kernel is not reached from Python
        epochs, part = 4, 4 / (case.steps if case.batch else 33)
    state = {}

    def make():
        return somoclu.Somoclu(
            case.columns, case.rows, compactsupport=False,
            initialcodebook=numpy.ascontiguousarray(case.initial, dtype=numpy.float32).copy(),
            gridtype="hexagonal" if case.hexagonal else "rectangular", std_coeff=1.0)

    def train():
        state["som"] = make()
        state["som"].train(case.data, epochs=epochs, radius0=case.radius_start,
                           radiusN=case.radius_end, scale0=1.0, scaleN=1.0)

    if name == "winners":
        som = make()
        som.update_data(case.data)
        som.codebook.shape = (case.rows, case.columns, case.features)
        return Job(lambda: som.get_bmus(som.get_surface_state(case.data)))
    return Job(train, lambda: state["som"].codebook, part)
