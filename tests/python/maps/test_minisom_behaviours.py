"""Behaviours that the test suites of MiniSom and kohonen (R) check, from their definitions.

docs/som-behaviours.md lists them with the differences of definition; its table names these tests.
"""

import pickle

import numpy as np
import pytest

from pysomato import SOM, DataError, SOMClassifier, UsageError


def map_of(weights, **parameters):
    """A map with one number for each neuron, in rows and columns."""
    return SOM.from_weights(np.array(weights, float)[:, :, None], **parameters)


@pytest.fixture
def marked():
    """A map of 5 x 5 neurons with weight 0, except two."""
    weights = np.zeros((5, 5))
    weights[2, 3], weights[1, 1] = 5, 2
    return map_of(weights)


def learned_share(steps, sample=1.0, **parameters):
    """The share of the way to the sample that each neuron of a row goes in the last of some steps."""
    steady = {"rows": 1, "columns": 7, "iterations": 4, "initial_weights": "range"} | parameters
    som = SOM(**steady).partial_fit([[0.0]] * max(1, steps))
    assert not som.weights_.any()  # the samples before are all 0
    return som.partial_fit([[sample]]).weights_[:, 0] / sample


# Schedules


@pytest.mark.parametrize("step", range(6))
def test_a_linear_learning_rate_has_equal_differences(step):
    share = learned_share(step, learning_rate_start=0.9, learning_rate_end=0.1, radius_end=0.5)
    step = max(1, step)
    assert share[0] == pytest.approx(max(0.1, 0.9 - 0.8 * step / 4), rel=1e-5)


@pytest.mark.parametrize("step", range(1, 6))
def test_an_exponential_learning_rate_has_equal_ratios(step):
    share = learned_share(step, learning_rate_start=0.8, learning_rate_end=0.05, radius_end=0.5,
                          learning_rate_schedule="exponential")
    assert share[0] == pytest.approx(max(0.05, 0.8 * (1 / 16) ** (step / 4)), rel=1e-5)


def test_a_constant_learning_rate_does_not_decay():
    share = learned_share(9, learning_rate_schedule="constant", learning_rate_start=0.4, radius_end=0.5)
    assert share[0] == pytest.approx(0.4, rel=1e-6)


@pytest.mark.parametrize("shape", ["linear", "exponential"])
def test_the_radius_follows_its_schedule(shape):
    share = learned_share(2, radius_schedule=shape, radius_start=4.0, radius_end=1.0,
                          learning_rate_schedule="constant", learning_rate_start=1.0)
    radius = {"linear": 2.5, "exponential": 2.0}[shape]
    np.testing.assert_allclose(share, np.exp(-np.arange(7) ** 2 / (2 * radius**2)), rtol=1e-5)


def test_unknown_schedules_neighbourhoods_and_distances_are_refused(X):
    for wrong in ({"learning_rate_schedule": "strawberry"}, {"radius_schedule": "strawberry"},
                  {"neighbourhood": "boooom"}, {"similarity": "ridethewave"}, {"lattice": "round"}):
        with pytest.raises(UsageError, match="must be one of"):
            SOM(2, 2, **wrong).fit(X)


# Neighbourhoods


@pytest.mark.parametrize("lattice", ["rectangular", "hexagonal"])
def test_a_gaussian_is_greatest_at_the_winner(lattice):
    weights = np.full((5, 5), 1.0)
    weights[2, 2] = 2.0
    som = map_of(weights, lattice=lattice, radius_schedule="constant", radius_start=1.3,
                 learning_rate_schedule="constant", learning_rate_start=0.5)
    before = som.weights_.copy()
    after = som.partial_fit([[3.0]]).weights_
    share = ((after - before) / (3.0 - before)).ravel() / 0.5
    squares = ((som.positions_ - som.positions_[12]) ** 2).sum(axis=1)
    assert share.argmax() == 12 and share[12] == pytest.approx(1.0)
    np.testing.assert_allclose(share, np.exp(-squares / (2 * 1.3**2)), rtol=1e-5, atol=1e-6)


@pytest.mark.parametrize(("radius", "learns"), [(0.5, 1), (1.0, 5), (1.5, 9), (2.0, 13)])
def test_a_bubble_is_a_disc_with_its_border(radius, learns):
    weights = np.zeros((5, 5))
    weights[2, 2] = 1.0
    som = map_of(weights, neighbourhood="bubble", radius_schedule="constant", radius_start=radius,
                 learning_rate_schedule="constant", learning_rate_start=1.0)
    after = som.partial_fit([[3.0]]).weights_
    assert np.isin(after, [0.0, 3.0]).all()  # all of the way, or none
    assert (after == 3.0).sum() == learns


# Distances and winners


def test_distances_are_those_of_definitions():
    som = SOM.from_weights(np.ones((2, 2, 2)))
    np.testing.assert_allclose(som.distances([[0.0, 0.0]]), [[np.sqrt(2)] * 4])
    random = np.random.default_rng(5)
    som = SOM.from_weights(random.normal(size=(3, 4, 6)))
    x = random.normal(size=(9, 6))
    between = np.linalg.norm(x[:, None] - som.weights_[None], axis=2)
    np.testing.assert_allclose(som.distances(x), between, rtol=1e-6)


def test_the_activation_is_least_at_the_winner(marked):
    assert marked.distances([[5.0]]).argmin() == 13
    assert marked.transform([[5.0]]).argmax() == 13
    assert marked.transform([[5.0]]).max() == 1.0


def test_a_winner_is_a_row_and_a_column(marked):
    assert divmod(int(marked.predict([[4.9]])[0]), marked.columns) == (2, 3)
    assert divmod(int(marked.predict([[2.2]])[0]), marked.columns) == (1, 1)
    assert marked.predict([[0.0]])[0] == 0  # the first of 23 equal neurons


def test_rows_of_another_length_are_refused(marked):
    with pytest.raises(ValueError, match="2 features"):
        marked.predict([[1.0, 2.0]])
    with pytest.raises(ValueError, match="2 features"):
        marked.partial_fit([[1.0, 2.0]])


# What samples win


def test_quantization_gives_the_weights_of_winners(marked):
    np.testing.assert_array_equal(marked.quantize([[4.0], [2.0]]), [[5.0], [2.0]])


def test_the_quantization_error_is_the_mean_distance_of_winners(marked):
    assert marked.score([[5.0], [2.0]]) == 0.0
    assert marked.score([[4.0], [1.0]]) == -1.0


def test_the_activation_response_counts_winners(marked):
    response = np.bincount(marked.predict([[5.0], [2.0], [5.5]]), minlength=25).reshape(5, 5)
    assert response[2, 3] == 2 and response[1, 1] == 1 and response.sum() == 3


def test_samples_are_listed_by_their_winners(marked):
    samples = marked.samples_of_neurons([[5.0], [2.0], [5.1]])
    assert {neuron: rows.tolist() for neuron, rows in samples.items()} == {13: [0, 2], 6: [1]}


def test_labels_are_counted_by_winners(marked):
    labels, counts = marked.class_counts([[5.0], [2.0], [5.2], [1.9]], ["a", "b", "b", None])
    assert labels.tolist() == ["a", "b"]
    assert counts[13].tolist() == [1, 1] and counts[6].tolist() == [0, 1] and counts.sum() == 3
    with pytest.raises(DataError, match="inconsistent"):
        marked.class_counts([[5.0]], ["a", "b"])


def test_samples_and_labels_of_fit_are_known(X, labels):
    som = SOM(3, 3, iterations=100).fit(X, labels)
    names, counts = som.class_counts()
    np.testing.assert_array_equal(counts.sum(axis=1), som.hits_)
    for neuron, rows in som.samples_of_neurons().items():
        assert (som.winners_[rows] == neuron).all()
        assert [(labels[rows] == name).sum() for name in names] == counts[neuron].tolist()
    loaded = SOM.from_weights(som.weights_.reshape(3, 3, -1))
    with pytest.raises(UsageError, match="pass X"):
        loaded.samples_of_neurons()
    with pytest.raises(UsageError, match="pass y"):
        som.class_counts(X)


# The topographic error


def topographic_error(weights, sample, **parameters):
    """That of one sample: 0 if its two best neurons share an edge, otherwise 1."""
    som = map_of(weights, **parameters)
    best = np.argsort(som.distances([[sample]])[0], kind="stable")[:2]
    between = np.linalg.norm(som.positions_[best[0]] - som.positions_[best[1]])
    _, error, _, _ = som.map_.quality(_rows([[sample]]), 1)
    if parameters.get("topology") != "torus":
        assert error == (not np.isclose(between, 1.0))
    return error


def _rows(X):
    from pysomato import _somato

    return _somato.SampleRows(np.array(X, np.float32), "refuse", False)


@pytest.mark.parametrize(("weights", "sample", "error"), [
    ([[0, 1], [8, 9]], 0.4, 0),  # side by side
    ([[0, 8], [1, 9]], 0.4, 0),  # one above the other
    ([[0, 8], [9, 1]], 0.4, 1),  # they touch at a corner only
    ([[0, 1, 8, 9, 7]], 0.4, 0),
    ([[0, 8, 1, 9, 7]], 0.4, 1),
    ([[0, 8, 9, 7, 1]], 0.4, 1),
])
def test_neighbours_share_an_edge_on_small_maps(weights, sample, error):
    assert topographic_error(weights, sample) == error


def test_the_ends_of_a_torus_are_neighbours():
    assert topographic_error([[0, 8, 9, 7, 1]], 0.4, topology="torus") == 0
    assert topographic_error([[0, 8, 1, 9, 7]], 0.4, topology="torus") == 1


@pytest.mark.parametrize(("second", "error"), [
    ((1, 0), 0), ((1, 1), 1), ((0, 1), 0), ((0, 2), 1), ((2, 0), 1)])
def test_an_even_row_has_its_neighbours_on_the_left_of_odd_rows(second, error):
    weights = np.full((3, 3), 99.0)
    weights[0, 0], weights[second] = 0, 1
    # Row 1 is shifted to the right: of (0, 0), only (1, 0) touches.
    assert topographic_error(weights, 0.4, lattice="hexagonal") == error


@pytest.mark.parametrize(("second", "error"), [((0, 1), 0), ((0, 2), 0), ((2, 1), 0), ((2, 2), 0),
                                               ((1, 0), 0), ((1, 2), 0), ((0, 0), 1), ((2, 0), 1)])
def test_a_hexagon_in_an_odd_row_has_six_neighbours(second, error):
    weights = np.full((3, 3), 99.0)
    weights[1, 1], weights[second] = 0, 1
    assert topographic_error(weights, 0.4, lattice="hexagonal") == error


# The distance map


def test_the_distance_map_of_a_chequerboard_is_even():
    som = map_of([[1, 0, 1], [0, 1, 0], [1, 0, 1]])
    np.testing.assert_allclose(som.u_matrix(), np.ones((3, 3)))  # all edges have the length 1
    assert not map_of(np.ones((3, 3))).u_matrix().any()


def test_the_distance_map_of_two_columns():
    som = SOM.from_weights([[[1.0, 0.0], [0.0, 1.0]], [[1.0, 0.0], [0.0, 1.0]]])
    np.testing.assert_allclose(som.u_matrix(), np.full((2, 2), np.sqrt(2) / 2))  # of two edges, one
    som = SOM.from_weights(som.weights_.reshape(2, 2, 2), lattice="hexagonal")
    # Neurons 1 and 2 have three neighbours, since row 1 is shifted to the right.
    root = np.sqrt(2)
    np.testing.assert_allclose(som.u_matrix(), [[root / 2, 2 * root / 3], [2 * root / 3, root / 2]])


# Training


def test_an_update_moves_the_winner_by_the_learning_rate():
    som = map_of([[0, 10]], radius_schedule="constant", radius_start=0.0,
                 learning_rate_schedule="constant", learning_rate_start=0.25)
    np.testing.assert_allclose(som.partial_fit([[8.0]]).weights_, [[0], [9.5]])
    np.testing.assert_allclose(som.partial_fit([[4.0]]).weights_, [[1], [9.5]])


@pytest.mark.parametrize("parameters", [
    {"iterations": 40}, {"iterations": 40, "draws": "without_replacement"},
    {"training": "batch", "epochs": 5}])
def test_training_reduces_the_quantization_error_and_repeats(X, parameters):
    first = SOM(4, 4, random_state=3, **parameters).fit(X)
    again = SOM(4, 4, random_state=3, **parameters).fit(X)
    other = SOM(4, 4, random_state=4, **parameters).fit(X)
    np.testing.assert_array_equal(first.weights_, again.weights_)
    assert (first.weights_ != other.weights_).any()
    start = SOM(4, 4, random_state=3).partial_fit(X[:2])
    assert first.quantization_error_ < -start.score(X)


def test_draws_without_replacement_take_each_sample_once_in_each_pass():
    """With a rate of 1 and one neuron, the weight is the last sample that was drawn."""
    X = np.arange(5.0)[:, None]
    last = []
    for iterations in range(1, 11):
        som = SOM(1, 1, iterations=iterations, draws="without_replacement", radius_end=0.0,
                  learning_rate_schedule="constant", learning_rate_start=1.0).fit(X)
        last.append(float(som.weights_[0, 0]))
    assert sorted(last[:5]) == sorted(last[5:]) == list(range(5))
    assert last[:5] != last[5:]  # each pass has an order of its own


def test_samples_in_their_order_are_learned_by_partial_fit():
    som = SOM(1, 1, iterations=5, learning_rate_schedule="constant", learning_rate_start=1.0)
    for x in [3.0, 1.0, 2.0]:
        assert som.partial_fit([[x]]).weights_[0, 0] == x


def test_batch_training_takes_means_of_neighbourhoods():
    som = SOM(1, 2, training="batch", epochs=9, radius_schedule="constant", radius_start=0.0,
              initial_weights="samples", random_state=2).fit([[0.0], [10.0], [11.0]])
    samples = np.array([0.0, 10.0, 11.0])
    for neuron, rows in som.samples_of_neurons().items():  # a fixed point, as of k-means
        assert som.weights_[neuron, 0] == pytest.approx(samples[rows].mean())


def test_initial_weights_are_samples():
    som = SOM(2, 2, initial_weights="samples", learning_rate_schedule="constant",
              learning_rate_start=1e-9).partial_fit([[1.0, 0.0], [0.0, 5.0]])
    assert {tuple(row) for row in np.round(som.weights_, 5).tolist()} <= {(1.0, 0.0), (0.0, 5.0)}


# Files


def test_a_map_is_the_same_after_a_pickle(marked):
    again = pickle.loads(pickle.dumps(marked))
    np.testing.assert_array_equal(again.weights_, marked.weights_)
    assert again.get_params() == marked.get_params()


# kohonen: grids, map(), predict() and NA


def hexagon_positions(rows, columns):
    row, column = np.divmod(np.arange(rows * columns), columns)
    return np.column_stack([column + 0.5 * (row % 2), row * np.sqrt(3) / 2])


@pytest.mark.parametrize(("rows", "columns"), [(4, 5), (6, 3), (2, 2)])
@pytest.mark.parametrize("lattice", ["rectangular", "hexagonal"])
def test_distances_on_a_torus_are_those_of_the_nearest_copy(rows, columns, lattice):
    """What a sample teaches a neuron shows its distance from the winner on the map."""
    if lattice == "hexagonal":
        places, sides = hexagon_positions(rows, columns), np.array([columns, rows * np.sqrt(3) / 2])
    else:
        places = np.column_stack(np.divmod(np.arange(rows * columns), columns)[::-1]).astype(float)
        sides = np.array([columns, rows], float)
    copies = np.array([[i, j] for i in (-1, 0, 1) for j in (-1, 0, 1)]) * sides
    for winner in range(rows * columns):
        weights = np.zeros(rows * columns)
        weights[winner] = 1.0
        som = map_of(weights.reshape(rows, columns), lattice=lattice, topology="torus",
                     radius_schedule="constant", radius_start=1.0,
                     learning_rate_schedule="constant", learning_rate_start=1.0)
        np.testing.assert_allclose(som.positions_, places)
        after = som.partial_fit([[2.0]]).weights_[:, 0].astype(float)
        share = (after - weights) / (2.0 - weights)
        between = places[winner] - places[:, None] - copies
        squares = (between**2).sum(axis=2).min(axis=1)
        np.testing.assert_allclose(share, np.exp(-squares / 2), rtol=1e-4, atol=1e-6)


def test_an_odd_number_of_hexagonal_rows_is_no_torus():
    with pytest.raises(UsageError, match="even number of rows"):
        map_of(np.ones((3, 2)), lattice="hexagonal", topology="torus")


def test_new_data_are_mapped_to_the_nearest_neurons(X):
    som = SOM(4, 4, iterations=100).fit(X[:40])
    between = np.linalg.norm(X[40:, None] - som.weights_[None], axis=2)
    np.testing.assert_array_equal(som.predict(X[40:]), between.argmin(axis=1))
    np.testing.assert_allclose(som.distances(X[40:]).min(axis=1), between.min(axis=1), rtol=1e-5)


def test_values_that_are_not_known_do_not_count_for_winners(X):
    som = SOM(4, 4, iterations=100, missing="nearest").fit(X)
    gaps = X.astype(float)
    gaps[np.random.default_rng(2).random(gaps.shape) < 0.3] = np.nan
    gaps[np.isnan(gaps).all(axis=1), 0] = 1.0
    squares = np.nansum((gaps[:, None] - som.weights_[None]) ** 2, axis=2)
    winners = som.predict(gaps)
    np.testing.assert_allclose(squares[np.arange(len(X)), winners], squares.min(axis=1), rtol=1e-5)


def test_values_that_are_not_known_are_refused_unless_a_treatment_is_chosen(X):
    gaps = X.copy()
    gaps[3, 2] = np.nan
    with pytest.raises(DataError, match="row 3, column 2"):
        SOM(2, 2).fit(gaps)
    empty = X.copy()
    empty[3] = np.nan
    for missing in ("mean", "nearest"):
        assert SOM(2, 2, iterations=50, missing=missing).fit(gaps).winners_.shape == (60,)
        with pytest.raises(DataError, match="row 3"):  # nothing is known of it
            SOM(2, 2, missing=missing).fit(empty)


def test_classes_of_new_data_are_predicted(X, labels):
    classifier = SOMClassifier(4, 4, iterations=400).fit(X[:40], labels[:40])
    assert (classifier.predict(X[40:]) == labels[40:]).mean() > 0.8
    shares = classifier.predict_proba(X[40:])
    np.testing.assert_allclose(shares.sum(axis=1), 1.0)
    assert shares.shape == (20, 4)
