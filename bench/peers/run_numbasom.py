"""numbasom: compiled loops, a sample at a time."""

import numpy
from numbasom import SOM
from numbasom.core import project_on_lattice
from serve import Job

STEPS = {"dense_batch": 2000, "sparse_uniform_start": 50}
SEARCHES = 5000


def prepare(case, name):
    data = case.data.astype(numpy.float64)
    all_steps = case.steps * case.samples if case.batch else case.steps
    steps = min(STEPS.get(name, all_steps), all_steps)
    som = SOM((case.rows, case.columns))
    som.train(data[:10], 2)  # compiles
    state = {}

    def train():
        state["weights"] = som.train(data, steps)

    if name == "winners":
        lattice = case.initial.reshape(case.rows, case.columns, case.features).astype(numpy.float64)
        part = min(SEARCHES, case.samples)
        project_on_lattice(data[:10], lattice)  # compiles
        return Job(lambda: project_on_lattice(data[:part], lattice), None, part / case.samples)
    return Job(train, lambda: state["weights"], steps / all_steps)
