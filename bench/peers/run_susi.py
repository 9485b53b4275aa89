"""susi: numpy, a sample at a time; its batch training needs neurons^2 x samples numbers."""

from serve import Job
from susi import SOMClustering

STEPS = {"dense_batch": 100, "few_samples": 100}
SEARCHES = 1000


def prepare(case, name):
    all_steps = case.steps * case.samples if case.batch else case.steps
    steps = all_steps if case.whole else STEPS.get(name, 1)
    state = {}

    def make(steps):
        return SOMClustering(case.rows, case.columns, n_iter_unsupervised=steps,
                             learning_rate_start=case.learning_rate_start,
                             learning_rate_end=case.learning_rate_end, n_jobs=case.threads)

    # Its fit() ends with a search for all its samples: few, so that it does not affect the time.
    def train():
        state["som"] = make(steps)
        state["som"].fit(case.data if case.whole else case.data[:100])

    if name == "winners":
        som = make(1).fit(case.data[:10])
        som.unsuper_som_ = case.initial.reshape(case.rows, case.columns, case.features)
        part = min(SEARCHES, case.samples)
        return Job(lambda: som.get_bmus(case.data[:part]), None, part / case.samples)
    return Job(train, lambda: state["som"].unsuper_som_, min(1.0, steps / all_steps))
