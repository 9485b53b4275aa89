"""Maps from and for other programs: weights, MiniSom, archives of numpy, codebooks."""

import json

import numpy as np
import pytest

import pysomato
from pysomato import SOM, DataError, UsageError


class MiniSomLike:
    """The public methods of a MiniSom of its version 2.3 that are used, by their documentation."""

    def __init__(self, weights, topology, distance=lambda x, w: np.linalg.norm(x - w, axis=-1)):
        self._weights = np.array(weights, float)
        self._distance = distance
        self.topology = topology

    def get_weights(self):
        return self._weights

    def activate(self, x):
        return self._distance(x, self._weights)

    def get_euclidean_coordinates(self):
        x, y = np.meshgrid(*map(np.arange, self._weights.shape[:2]), indexing="ij")
        x, y = x.astype(float), y.astype(float)
        if self.topology == "hexagonal":
            x[:, ::-2] -= 0.5  # the last line of equal y, and each second one before it
            y *= np.sqrt(3) / 2
        return x, y


@pytest.mark.parametrize("sides", [(3, 4), (4, 3), (1, 4), (4, 1), (2, 2)])
@pytest.mark.parametrize("topology", ["rectangular", "hexagonal"])
def test_a_minisom_has_the_same_places_and_winners_here(sides, topology):
    random = np.random.default_rng(1)
    minisom = MiniSomLike(random.normal(size=(*sides, 3)), topology)
    som = SOM.from_minisom(minisom)
    X = random.normal(size=(30, 3))
    flat = minisom.get_weights().reshape(-1, 3).astype(np.float32)
    theirs = np.linalg.norm(X[:, None] - flat[None], axis=2).argmin(axis=1)
    np.testing.assert_allclose(som.quantize(X), flat[theirs])
    places = np.stack([one.ravel() for one in minisom.get_euclidean_coordinates()], axis=1)[theirs]
    ours = som.positions_[som.predict(X)]
    np.testing.assert_allclose(distances_of(ours), distances_of(places), atol=1e-12)
    if topology == "rectangular":
        np.testing.assert_array_equal(som.predict(X), theirs)
    assert som.lattice == topology
    named = SOM.from_minisom(minisom, features=["a", "b", "c"])
    assert named.feature_names_in_.tolist() == ["a", "b", "c"]


def distances_of(places):
    return np.linalg.norm(places[:, None] - places[None], axis=2)


def test_the_distance_of_a_minisom_is_found_by_its_values():
    weights = np.random.default_rng(1).normal(size=(2, 3, 4))
    assert SOM.from_minisom(MiniSomLike(weights, "rectangular")).similarity == "euclidean"
    known = next(info["choices"] for info in pysomato._somato.som_parameters()
                 if info["name"] == "similarity")
    for name, distance in {"manhattan": lambda x, w: np.abs(x - w).sum(axis=-1),
                           "chebyshev": lambda x, w: np.abs(x - w).max(axis=-1),
                           "cosine": lambda x, w: 1 - (w * x).sum(axis=2) / (
                               np.linalg.norm(w, axis=2) * np.linalg.norm(x) + 1e-8)}.items():
        minisom = MiniSomLike(weights, "rectangular", distance)
        if name in known:
            assert SOM.from_minisom(minisom).similarity == name
        else:
            with pytest.raises(UsageError, match=f"'{name}' is unknown"):
                SOM.from_minisom(minisom)


def test_other_objects_and_distances_are_refused():
    weights = np.random.default_rng(1).normal(size=(2, 3, 4))
    for distance in (lambda x, w: (x - w).max(axis=-1), lambda x, w: np.full(w.shape[:2], 1.0)):
        minisom = MiniSomLike(weights, "rectangular", distance)
        with pytest.raises(UsageError, match="similarity="):
            SOM.from_minisom(minisom)
        assert SOM.from_minisom(minisom, similarity="euclidean").similarity == "euclidean"
    for other in (None, object(), MiniSomLike(weights, "round")):
        with pytest.raises(UsageError, match="other methods than a MiniSom"):
            SOM.from_minisom(other)


def test_weights_become_a_map(X):
    weights = np.arange(24.0).reshape(3, 4, 2)
    som = SOM.from_weights(weights, lattice="hexagonal", features=["thumb", "index"], threads=1)
    np.testing.assert_array_equal(som.weights_, weights.reshape(12, 2))
    assert (som.rows, som.columns, som.threads, som.n_features_in_) == (3, 4, 1, 2)
    same = SOM.from_weights(weights.reshape(12, 2), columns=4, lattice="hexagonal")
    np.testing.assert_array_equal(same.weights_, som.weights_)
    picture = som.draw("components").svg
    assert ">thumb<" in picture and ">index<" in picture  # titles of the planes


def test_weights_of_a_frame_have_names():
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"length": [1.0, 2.0], "mass": [3.0, 4.0]})
    assert SOM.from_weights(frame, rows=1).feature_names_in_.tolist() == ["length", "mass"]


@pytest.mark.parametrize(("weights", "error", "message"), [
    (np.zeros(3), DataError, "shape"), (np.zeros((0, 1, 1)), DataError, "shape"),
    ([[["text"]]], TypeError, "no array of numbers"), ([[[1.0]], [[1.0, 2.0]]], DataError, "numbers"),
    (np.full((1, 2, 1), 1j), TypeError, "no array of numbers"),
    (np.array([[["1"]]]), TypeError, "no array of numbers"),
    (np.full((1, 2, 1), np.nan), DataError, r"\(0, 0, 0\) is nan"),
    (np.full((1, 2, 1), 1e300), DataError, r"1e\+300"),
    (np.array([[[1.7e9], [1.7e9 + 1]]]), DataError, "loses precision"),
    (np.ma.masked_equal([[[1.0], [2.0]]], 2.0), DataError, "masked"),
    (np.zeros((2, 3)), UsageError, "rows and columns"),
])
def test_weights_that_are_no_map_are_named(weights, error, message):
    with pytest.raises(error, match=message):
        SOM.from_weights(weights)


def test_numpy_opens_an_exported_map_without_pickle(X, labels, tmp_path):
    som = SOM(3, 4, lattice="hexagonal", iterations=100).fit(X, labels)
    som.export(tmp_path / "map.npz")
    with np.load(tmp_path / "map.npz", allow_pickle=False) as file:
        arrays = dict(file)
    np.testing.assert_array_equal(arrays["weights"], som.weights_.reshape(3, 4, 7))
    np.testing.assert_array_equal(arrays["positions"].reshape(12, 2), som.positions_)
    parameters = json.loads(str(arrays["parameters"]))
    assert parameters["lattice"] == "hexagonal" and parameters["rows"] == 3
    names = [str(arrays["class_names"][label]) if label >= 0 else None for label in arrays["labels"].flat]
    votes = som.class_counts()[1]
    assert names == [str(som.classes_[row.argmax()]) if row.any() else None for row in votes]
    np.savez(tmp_path / "again.npz", **arrays)
    for again in (SOM.load(tmp_path / "map.npz"), SOM.load(tmp_path / "again.npz")):
        np.testing.assert_array_equal(again.weights_, som.weights_)
        np.testing.assert_array_equal(again.classify(X), som.classify(X))
        assert again.get_params() == SOM._of(som.map_).get_params()


def test_an_exported_map_is_that_of_the_program(somato, X, labels, tmp_path):
    table = "\n".join(",".join(map(str, row)) + "," + label for row, label in zip(X * 3 + 1e6, labels))
    (tmp_path / "rows.csv").write_text(table)
    model, archive, again = (tmp_path / name for name in ("a.somato", "a.npz", "b.somato"))
    somato("som", "train", tmp_path / "rows.csv", "--label-column", 8, "--standardize", "-o", model)
    somato("som", "export", model, "-o", archive)
    somato("som", "import", archive, "-o", again)
    assert again.read_bytes() == model.read_bytes()
    winners = [somato("som", "map", path, tmp_path / "rows.csv", "--label-column", 8)
               for path in (model, again)]
    assert winners[0] == winners[1]
    with np.load(archive) as file:
        scaled = (np.loadtxt(tmp_path / "rows.csv", delimiter=",", usecols=range(7)) - file["mean"]) / file["scale"]
        weights = file["weights"].reshape(-1, 7)
    first = [int(line.split(",")[1]) for line in winners[0].splitlines()[1:]]
    between = np.linalg.norm(scaled[:, None] - weights[None], axis=2)
    np.testing.assert_array_equal(first, between.argmin(axis=1))


def test_a_map_of_weights_is_read_drawn_and_measured(somato, X, tmp_path):
    np.save(tmp_path / "w.npy", np.random.default_rng(1).normal(size=(3, 4, 7)))
    np.save(tmp_path / "rows.npy", X)
    model = tmp_path / "w.somato"
    somato("som", "import", tmp_path / "w.npy", "--lattice", "hexagonal", "-o", model)
    somato("som", "map", model, tmp_path / "rows.npy")
    somato("som", "plot", model, "-o", tmp_path / "w.svg")
    measures = somato("som", "quality", model, tmp_path / "rows.npy")
    error = -SOM.load(tmp_path / "w.npy", lattice="hexagonal").score(X)
    assert f"quantization_error {error:.6g}" in measures


def test_a_codebook_is_loaded_with_a_warning_for_what_is_left_out(tmp_path):
    codebook = "2 hexa 2 1 gaussian\n#n length mass\n1 2 apple green\n3 4\n"
    (tmp_path / "map.cod").write_text(codebook)
    with pytest.warns(pysomato.LeftOutWarning, match="several labels"):
        som = SOM.load(tmp_path / "map.cod")
    assert som.feature_names_in_.tolist() == ["length", "mass"] and som.lattice == "hexagonal"
    pandas = pytest.importorskip("pandas")
    assert som.classify(pandas.DataFrame({"length": [3.0], "mass": [4.0]})).tolist() == ["apple"]


def test_damaged_files_are_named(X, tmp_path):
    SOM(2, 2, iterations=20).fit(X).export(tmp_path / "map.npz")
    whole = (tmp_path / "map.npz").read_bytes()
    (tmp_path / "cut.npz").write_bytes(whole[:-40])
    with pytest.raises(DataError, match="cut.npz"):
        SOM.load(tmp_path / "cut.npz")
    (tmp_path / "name.npz").write_bytes(whole.replace(b"positions.npy", b"positi\xd1ns.npy"))
    with pytest.raises(DataError, match="unknown array"):  # its name is no text
        SOM.load(tmp_path / "name.npz")
    with np.load(tmp_path / "map.npz") as file:
        arrays = dict(file)
    arrays["weights"] = arrays["weights"].astype(object)
    np.savez(tmp_path / "objects.npz", **arrays)
    with pytest.raises(DataError, match="weights"):
        SOM.load(tmp_path / "objects.npz")
    with pytest.raises(UsageError, match="no effect"):
        SOM.load(tmp_path / "map.npz", lattice="hexagonal")
    with pytest.raises(UsageError, match="SOM.from_weights"):
        SOM.load(tmp_path / "map.npz", layers={"left": 2})
