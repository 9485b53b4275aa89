"""torchsom: training by small batches with a learning rate, in PyTorch."""

import torch
from serve import Job
from torchsom import SOM

EPOCHS_FOR_ONLINE = 50
BATCH = 1024


def prepare(case, name):
    torch.set_num_threads(case.threads)
    data = torch.from_numpy(case.data)
    epochs = case.steps if case.batch else EPOCHS_FOR_ONLINE
    state = {}

    def make():
        som = SOM(case.rows, case.columns, case.features, epochs=max(epochs, 1), batch_size=BATCH,
                  sigma=case.radius_start, learning_rate=1.0,
                  topology="hexagonal" if case.hexagonal else "rectangular",
                  lr_decay_function="lr_linear_decay_to_zero",
                  sigma_decay_function="sig_linear_decay_to_one", device="cpu")
        som.weights.data = torch.from_numpy(
            case.initial.reshape(case.rows, case.columns, case.features).copy())
        som._search_strategy.rebuild_index(som.weights)
        return som

    def train():
        state["som"] = make()
        state["som"].fit(data, verbose=False)

    if name == "winners":
        som = make()
        return Job(lambda: som.identify_bmus(data))
    return Job(train, lambda: state["som"].weights.detach().numpy())
