"""Initial weights on a plane, neighbourhoods and automatic length against numpy."""

import numpy as np
import pytest

from pysomato import SOM
from pysomato.errors import UsageError


def plane_of(rows):
    """The mean and the two largest principal components times their standard deviations."""
    rows = rows.astype(np.float64)
    mean = rows.mean(axis=0)
    _, values, vectors = np.linalg.svd(rows - mean, full_matrices=False)
    components = vectors[:2] * (values[:2] / np.sqrt(len(rows)))[:, None]
    places = np.abs(components).argmax(axis=1)
    signs = np.sign(components[np.arange(len(components)), places])
    return mean, components * np.where(signs == 0, 1, signs)[:, None]


def positions_of(rows, columns, lattice):
    row, column = np.divmod(np.arange(rows * columns), columns)
    x = column + (row % 2 / 2 if lattice == "hexagonal" else 0)
    return x.astype(float), row * (np.sqrt(0.75) if lattice == "hexagonal" else 1.0)


def along(place, count):
    return np.zeros_like(place) if count == 1 else 2 * place / place.max() - 1


def start_of(samples, rows, columns, lattice="rectangular"):
    mean, components = plane_of(samples)
    x, y = positions_of(rows, columns, lattice)
    factors = [along(x, columns), along(y, rows)]
    if rows > columns:
        factors.reverse()
    return mean + sum(f[:, None] * c[None] for f, c in zip(factors, components, strict=False))


def correlated(samples, columns, seed=0):
    random = np.random.default_rng(seed)
    mixing = random.normal(size=(columns, columns)) * np.geomspace(1, 0.01, columns)[:, None]
    rows = random.normal(size=(samples, columns)) @ mixing + random.normal(size=columns) * 5
    return rows.astype(np.float32)


def initial(rows, columns, **parameters):
    return SOM(rows, columns, initial_weights="linear", training="batch", epochs=0, **parameters)


@pytest.mark.parametrize("samples, columns", [(200, 6), (120, 70), (40, 41), (30, 90), (2, 5)])
@pytest.mark.parametrize("grid", [(7, 4), (4, 7), (5, 5), (1, 6), (6, 1)])
def test_linear_weights_are_the_plane_of_a_singular_value_decomposition(samples, columns, grid):
    X = correlated(samples, columns)
    for lattice, topology in (("rectangular", "plane"), ("hexagonal", "plane"), ("rectangular", "torus")):
        som = initial(*grid, lattice=lattice, topology=topology).fit(X)
        scale = np.abs(X - X.mean(axis=0)).max()
        np.testing.assert_allclose(som.weights_, start_of(X, *grid, lattice), atol=2e-5 * scale)


def test_linear_weights_of_a_dot_product_map_have_length_1():
    X = correlated(60, 5)
    som = initial(3, 4, similarity="dot_product").fit(X)
    samples = X / np.linalg.norm(X, axis=1, keepdims=True)
    expected = start_of(samples, 3, 4)
    expected /= np.linalg.norm(expected, axis=1, keepdims=True)
    np.testing.assert_allclose(som.weights_, expected, atol=2e-5)


def test_linear_weights_of_sparse_rows_are_those_of_dense_ones():
    sparse = pytest.importorskip("scipy.sparse")
    X = correlated(80, 30)
    X[np.random.default_rng(1).random(X.shape) < 0.8] = 0
    whole = initial(4, 5).fit(X).weights_
    np.testing.assert_array_equal(initial(4, 5).fit(sparse.csr_array(X)).weights_, whole)


def test_linear_weights_and_batch_training_do_not_depend_on_the_seed():
    X = correlated(50, 4)
    weights = [SOM(4, 3, initial_weights="linear", training="batch", random_state=seed).fit(X).weights_
               for seed in (1, 2)]
    np.testing.assert_array_equal(*weights)


SHAPES = {
    "gaussian": lambda q: np.exp(-(q**2) / 2),
    "bubble": lambda q: q <= 1,
    "cut_gaussian": lambda q: np.where(q <= 1, np.exp(-(q**2) / 2), 0),
    "triangular": lambda q: np.maximum(0, 1 - q),
    "epanechnikov": lambda q: np.maximum(0, 1 - q**2),
}


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("lattice", ["rectangular", "hexagonal"])
def test_an_epoch_makes_weights_the_means_by_the_neighbourhood(shape, lattice):
    X = correlated(60, 4)
    rows, columns, radius = 5, 4, 2.2
    parameters = {"lattice": lattice, "neighbourhood": shape, "radius_start": radius,
                  "radius_schedule": "constant", "initial_weights": "linear", "training": "batch"}
    before = SOM(rows, columns, epochs=0, **parameters).fit(X)
    x, y = positions_of(rows, columns, lattice)
    distances = np.hypot(x[:, None] - x[before.winners_], y[:, None] - y[before.winners_])
    factors = SHAPES[shape](distances / radius).astype(float)
    expected = factors @ X.astype(np.float64) / factors.sum(axis=1, keepdims=True)
    after = SOM(rows, columns, epochs=1, **parameters).fit(X)
    np.testing.assert_allclose(after.weights_, expected, atol=1e-4)


def test_a_mexican_hat_pushes_distant_neurons_away():
    X = np.array([[1.0, 0.0], [1.0, 0.0]], dtype=np.float32)  # one sample, twice
    parameters = {"neighbourhood": "mexican_hat", "radius_start": 1.5, "radius_schedule": "constant",
                  "learning_rate_start": 0.2, "learning_rate_schedule": "constant",
                  "initial_weights": "uniform"}
    before = SOM(1, 6, iterations=0, **parameters).fit(X)
    after = SOM(1, 6, iterations=1, **parameters).fit(X)
    q = np.abs(np.arange(6) - before.winners_[0]) / 1.5
    gains = 0.2 * (1 - q**2) * np.exp(-(q**2) / 2)
    expected = before.weights_ + gains[:, None] * (X[0] - before.weights_)
    np.testing.assert_allclose(after.weights_, expected, atol=1e-6)
    with pytest.raises(UsageError, match="mexican_hat"):
        SOM(training="batch", neighbourhood="mexican_hat").fit(X)


def steps_by_definition(error_after, first, step, tolerance, patience, most):
    best, without, steps = None, 0, first
    for check in range(most):
        steps = first + check * step
        error = error_after(steps)
        better = best is None or error < (1 - tolerance) * best
        best, without = (error, 0) if better else (best, without + 1)
        if without == patience:
            break
    return steps


@pytest.mark.parametrize("patience, most", [(1, 100), (3, 100), (3, 2)])
def test_training_ends_when_the_error_no_longer_improves(patience, most):
    X = correlated(40, 3)
    automatic = {"tolerance": 0.002, "patience": patience, "most_checks": most}
    batch = {"training": "batch", "radius_reached_at": 3}
    steps = steps_by_definition(
        lambda epochs: SOM(5, 5, epochs=epochs, **batch).fit(X).quantization_error_, 3, 1, 0.002,
        patience, most)
    som = SOM(5, 5, epochs=3, **batch, **automatic).fit(X)
    assert som.steps_ == steps + 1
    same = SOM(5, 5, epochs=steps + 1, **batch).fit(X)
    np.testing.assert_array_equal(som.weights_, same.weights_)

    online = {"radius_reached_at": 50, "learning_rate_reached_at": 50}
    steps = steps_by_definition(
        lambda iterations: SOM(5, 5, iterations=iterations, **online).fit(X).quantization_error_, 50,
        len(X), 0.002, patience, most)
    som = SOM(5, 5, iterations=50, **online, **automatic).fit(X)
    assert som.steps_ == steps
    assert som.samples_seen_ == steps
    np.testing.assert_array_equal(som.weights_, SOM(5, 5, iterations=steps, **online).fit(X).weights_)


def test_steps_of_a_fixed_length_are_those_of_the_parameters():
    X = correlated(40, 3)
    assert SOM(2, 2, iterations=70).fit(X).steps_ == 70
    assert SOM(2, 2, training="batch", epochs=4).fit(X).steps_ == 4


def test_patience_without_tolerance_has_no_effect():
    with pytest.raises(UsageError, match="tolerance is 0"):
        SOM(patience=5).fit(correlated(10, 2))


def test_partial_fit_begins_no_map_of_automatic_length():
    with pytest.raises(UsageError, match="each sample once"):
        SOM(tolerance=0.1).partial_fit(correlated(10, 2))


def test_the_program_prints_the_number_of_steps(somato, tmp_path):
    X = correlated(40, 3)
    np.save(tmp_path / "rows.npy", X)
    for flags, name, parameters in (
            (["--training", "batch", "--epochs", "3"], "epochs", {"training": "batch", "epochs": 3}),
            (["--iterations", "60"], "iterations", {"iterations": 60})):
        path = tmp_path / "map.somato"
        text = somato("som", "train", tmp_path / "rows.npy", "-o", path, "--rows", "4", "--columns", "4",
                      "--initial-weights", "linear", "--tolerance", "0.001", *flags)
        som = SOM(4, 4, initial_weights="linear", tolerance=0.001, **parameters).fit(X)
        assert f"{name} {som.steps_}\n" in text
        som.save(tmp_path / "mine.somato")
        assert (tmp_path / "mine.somato").read_bytes() == path.read_bytes()
        assert SOM.load(path).weights_.shape == (16, 3)
