"""The program reads the files of SciPy as SciPy does."""

import numpy as np
import pytest
import scipy.io
import scipy.io.wavfile
import scipy.sparse

import pysomato


def sparse(X):
    """Some rows of X, two thirds of whose elements are zero."""
    return np.where(np.arange(X.size).reshape(X.shape) % 3 == 0, X, 0)


WRITERS = {
    "csr": lambda path, rows: scipy.sparse.save_npz(path, scipy.sparse.csr_matrix(rows)),
    "csc": lambda path, rows: scipy.sparse.save_npz(path, scipy.sparse.csc_matrix(rows), False),
    "coo": lambda path, rows: scipy.sparse.save_npz(path, scipy.sparse.coo_matrix(rows)),
    "npz": lambda path, rows: np.savez_compressed(path, rows=rows),
    "mat": lambda path, rows: scipy.io.savemat(path, {"rows": rows, "note": "text"}),
    "packed mat": lambda path, rows: scipy.io.savemat(path, {"rows": rows}, do_compression=True),
    "sparse mat": lambda path, rows: scipy.io.savemat(path, {"rows": scipy.sparse.csc_matrix(rows)}),
}


@pytest.mark.parametrize("write", WRITERS.values(), ids=WRITERS)
def test_rows_are_those_of_the_array(somato, tmp_path, X, write):
    rows = sparse(X.astype(np.float64) / 3)
    np.save(tmp_path / "rows.npy", rows)
    path = tmp_path / "rows.npz"
    with path.open("wb") as file:
        write(file, rows)
    maps = []
    for data in (tmp_path / "rows.npy", path):
        somato("som", "train", data, "-o", tmp_path / "a.map", "--rows", 3, "--columns", 3,
               "--iterations", 50)
        maps.append((tmp_path / "a.map").read_bytes())
    assert maps[0] == maps[1]


@pytest.mark.parametrize("kind", [np.uint8, np.int16, np.int32, np.float32, np.float64])
def test_samples_are_those_of_the_sound(somato, tmp_path, kind):
    random = np.random.default_rng(1)
    shares = random.uniform(-1, 1, (500, 2))
    whole = np.issubdtype(kind, np.integer)
    scale = 2.0 ** (8 * np.dtype(kind).itemsize - 1) if whole else 1.0
    middle = 128 if kind == np.uint8 else 0
    samples = (shares * (scale - 1) + middle).astype(kind)
    scipy.io.wavfile.write(tmp_path / "cork_1.wav", 8000, samples)
    somato("import", "wav", tmp_path, "-o", tmp_path / "a.mcap", "--files", "{material}_{trial}.wav")
    sound = pysomato.read(tmp_path / "a.mcap")["sound"][0]
    expected = ((samples.astype(np.float64) - middle) / scale).astype(np.float32)
    assert np.array_equal(sound, expected)
