"""The estimator TMPSOM against the equations in numpy, and against a system with such a module."""

import pickle
from inspect import signature

import numpy as np
import pytest

import pysomato
from pysomato import TMPSOM, Recording, _somato, study


def test_parameters_have_the_names_and_defaults_of_the_library():
    parameters = {name: parameter for name, parameter in signature(TMPSOM).parameters.items()
                  if name not in ("seed", "verbose")}
    parameters["seed"] = parameters.pop("random_state")  # its name in scikit-learn
    declared = _somato.t_mpsom_parameters()
    assert list(parameters) == [info["name"] for info in declared]
    for info in declared:
        if info["name"] in ("shape", "input_sizes", "input_axes"):
            continue  # lists, which are derived from the columns
        default, text = parameters[info["name"]].default, info["default"]
        assert default == (None if text == '"automatic"' else
                           text.strip('"') if text.startswith('"') else float(text))


def normalized(values):
    return values / np.linalg.norm(values, axis=-1, keepdims=True)


def arbor(extent, elements, sigma):
    u, k = np.arange(1, extent + 1)[:, None], np.arange(1, elements + 1)[None]
    return np.exp(-((u - k * extent / elements) ** 2) / (2 * sigma**2))


def activity_of(weights, inputs):
    """y and normalized inputs of a map of 3 x 4 neurons with the arbors' width 1.5."""
    places = np.array([(row, column) for row in range(3) for column in range(4)])
    parts = []
    for axis, (w, x) in enumerate(zip(weights, inputs)):
        A = arbor((3, 4)[axis], len(x), 1.5)[places[:, axis]]
        parts.append((A * w * normalized(x)).sum(axis=1))
    return parts[0] * parts[1], places


def test_learning_follows_the_equations():
    rows = np.random.default_rng(4).random((6, 9), np.float32)
    som = TMPSOM((3, 4), input_sizes=[4, 5], arbor_sigma=1.5, neighbourhood_sigma=0.8, iterations=10,
                 learning_rate_start=0.5, learning_rate_end=0.1, seed=3)
    first = _somato.TMpsom.initial(som._map_parameters(rows))
    weights = [first.weights(i).astype(np.float64) for i in range(2)]
    for t, row in enumerate(rows.astype(np.float64)):
        inputs = row[:4], row[4:]
        y, places = activity_of(weights, inputs)
        squares = ((places[:, None] - places[None]) ** 2).sum(axis=2)
        spread = np.exp(-squares / (2 * 0.8**2)) @ y
        gain = (0.5 - 0.4 * t / 10) * spread / spread.max()
        weights = [normalized(w + gain[:, None] * (normalized(x) - w)) for w, x in zip(weights, inputs)]
    som = pickle.loads(pickle.dumps(som.partial_fit(rows[:2]))).partial_fit(rows[2:])
    assert som.samples_seen_ == 6
    for i in range(2):
        np.testing.assert_allclose(som.weights(i), weights[i], rtol=1e-4, atol=1e-6)
    expected, _ = activity_of(weights, (rows[0, :4].astype(float), rows[0, 4:].astype(float)))
    np.testing.assert_allclose(som.transform(rows[:1])[0], expected, rtol=1e-4)
    assert som.predict(rows[:1])[0] == expected.argmax()


STUDY = """
[study]
name = "two_inputs"
protocols = ["train_is_test"]
seeds = 1
first_seed = 5

[module.joints]
type = "channel"
channel = "joints"

[module.wrist]
type = "channel"
channel = "wrist"

[module.joints_at_the_end]
type = "last"
input = "joints"

[module.wrist_at_the_end]
type = "last"
input = "wrist"

[module.both]
type = "t_mpsom"
inputs = ["joints_at_the_end", "wrist_at_the_end"]
shape = [3, 4]
iterations = 200

[module.map]
type = "som"
input = "both"
rows = 2
columns = 2
iterations = 20
"""


def test_a_system_learns_the_same_map(tmp_path):
    random = np.random.default_rng(6)
    channels = {"joints": random.random((12, 1, 4), np.float32), "wrist": random.random((12, 1, 5), np.float32)}
    recording = Recording.from_arrays({"object": ["ball", "cube"] * 6}, channels)
    (tmp_path / "study.toml").write_text(STUDY)
    study(recording, tmp_path / "study.toml").system.save(tmp_path / "system.somato")
    saved = (tmp_path / "system.somato").read_bytes()
    rows = np.concatenate([channels["joints"][:, 0], channels["wrist"][:, 0]], axis=1)
    som = TMPSOM((3, 4), input_sizes=[4, 5], iterations=200, seed=5).fit(rows)
    for i in range(2):
        assert som.weights(i).tobytes() in saved
    other = TMPSOM((3, 4), input_sizes=[4, 5], iterations=200, seed=6).fit(rows)
    assert other.weights(0).tobytes() not in saved


@pytest.mark.parametrize("settings, message", [
    ({"input_sizes": [3, 3]}, "6 elements, but the data 7 columns"),
    ({"input_axes": [0, 0]}, "axis"),
    ({"combination": "product"}, "combination"),
    ({"shape": (2,) * 8}, "8 axes"),
    ({"learning_rate_start": 2}, "learning_rate_start"),
])
def test_wrong_parameters_are_named(X, settings, message):
    with pytest.raises(pysomato.Error, match=message):
        TMPSOM(**settings).fit(X)
