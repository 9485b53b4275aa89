"""fastersom: batch training by PyTorch."""

import fastersom
import torch
from serve import Job

EPOCHS_FOR_ONLINE = 50


def prepare(case, name):
    torch.set_num_threads(case.threads)
    data = torch.from_numpy(case.data)
    initial = torch.from_numpy(case.initial)
    epochs = case.steps if case.batch else EPOCHS_FOR_ONLINE
    state = {}

    def train():
        state["som"] = fastersom.SOM(
            case.rows, case.columns, n_epochs=epochs, sigma_initial=case.radius_start,
            sigma_final=case.radius_end, init=initial, device="cpu").fit(data)

    if name == "winners":
        som = fastersom.SOM.from_weights(initial, case.rows, case.columns, device="cpu")
        return Job(lambda: som.predict(data))
    return Job(train, lambda: state["som"].weights_)
