"""sklearn-minisom: MiniSom behind the interface of scikit-learn, a sample at a time."""

from serve import Job
from sklearn_minisom import SklearnMinisom


def prepare(case, name):
    state = {}

    def train():
        state["som"] = SklearnMinisom(
            case.rows, case.columns, sigma=case.radius_start, learning_rate=case.learning_rate_start,
            decay_function="linear_decay_to_zero", sigma_decay_function="linear_decay_to_one",
            num_iteration=case.steps * case.samples, random_order=True, random_seed=1).fit(case.data)

    return Job(train, lambda: state["som"].som.get_weights())
