"""XPySom: batch training by numpy."""

from serve import Job
from xpysom import XPySom

EPOCHS_FOR_ONLINE = 50


def prepare(case, name):
    epochs = case.steps if case.batch else EPOCHS_FOR_ONLINE
    part = 1.0
    if case.sparse:  # no sparse form: an epoch gives the time of all
        epochs, part = 4, 4 / (case.steps if case.batch else 33)
    state = {}

    def train():
        som = XPySom(case.rows, case.columns, case.features, sigma=case.radius_start,
                     sigmaN=case.radius_end, learning_rate=1, learning_rateN=1,
                     decay_function="linear", std_coeff=1.0,
                     topology="hexagonal" if case.hexagonal else "rectangular")
        som._weights = case.initial.reshape(case.rows, case.columns, case.features)
        som.train(case.data, epochs)
        state["weights"] = som.get_weights()

    def search():
        som.quantization(case.data)

    if name == "winners":
        som = XPySom(case.rows, case.columns, case.features)
        som._weights = case.initial.reshape(case.rows, case.columns, case.features)
        return Job(search)
    return Job(train, lambda: state["weights"], part)
