"""The codes against their definitions in numpy."""

from inspect import signature

import numpy as np
import pytest

import pysomato
from pysomato import OneHot, Spectrum, TensorProduct, _somato


@pytest.mark.parametrize("code, declared, own", [
    (OneHot, _somato.one_hot_parameters(), set()),
    (Spectrum, _somato.spectrum_parameters(), set()),
])
def test_parameters_have_the_names_of_the_library(code, declared, own):
    assert set(signature(code).parameters) - own == {info["name"] for info in declared}


def test_spectrum_has_the_defaults_of_the_library():
    for info in _somato.spectrum_parameters():
        default = signature(Spectrum).parameters[info["name"]].default
        text = info["default"]
        expected = {'"automatic"': None, "true": True, "false": False}.get(text, text.strip('"'))
        assert default == (expected if isinstance(default, (str, bool, type(None))) else float(text))


def test_one_hot_marks_the_bin(X):
    code = OneHot(elements=4).fit(X)
    coded = code.transform(X).reshape(60, 7, 4)
    assert coded.dtype == np.float32
    np.testing.assert_array_equal(coded.sum(axis=2), 1)
    share = (X - X.min(axis=0)) / (X.max(axis=0) - X.min(axis=0))
    expected = np.minimum((share * 4).astype(int), 3)
    clear = np.abs(share * 4 - np.round(share * 4)) > 1e-4  # of an edge
    np.testing.assert_array_equal(coded.argmax(axis=2)[clear], expected[clear])
    assert clear.mean() > 0.9


def test_one_hot_takes_ranges():
    rows = np.array([[0.0, 5.0], [10.0, 6.0]])
    coded = OneHot(low=[0, 5], high=[10, 7], elements=2).fit_transform(rows)
    assert coded.tolist() == [[1, 0, 1, 0], [0, 1, 0, 1]]
    code = OneHot(low=0, high=10, elements=2)
    with pytest.raises(pysomato.DataError, match="row 1, joint 2"):
        code.fit(rows).transform([[1, 1], [1, 11]])
    assert code.set_params(outside="clamp").transform([[-1, 11]]).tolist() == [[1, 0, 0, 1]]
    with pytest.raises(pysomato.UsageError, match="low"):
        OneHot(low=[1, 2, 3]).fit(rows)
    with pytest.raises(pysomato.DataError, match="column 1"):
        OneHot().fit([[0, 5], [1, 5]])
    with pytest.raises(pysomato.UsageError, match="elements"):
        OneHot(elements=0).fit(rows)


def test_tensor_products_are_outer_products(X):
    product = TensorProduct([2, 5]).fit_transform(X)
    np.testing.assert_array_equal(product.reshape(60, 2, 5), X[:, :2, None] * X[:, None, 2:])
    three = TensorProduct([2, 1, 4]).fit_transform(X)
    expected = X[:, :2, None, None] * X[:, None, 2:3, None] * X[:, None, None, 3:]
    np.testing.assert_array_equal(three, expected.reshape(60, 8))
    np.testing.assert_array_equal(TensorProduct().fit_transform(X), X)
    with pytest.raises(pysomato.UsageError, match="7 columns"):
        TensorProduct([2, 4]).fit(X)


def test_bins_are_those_of_a_fourier_transform():
    rows = np.random.default_rng(2).normal(size=(3, 64))
    code = Spectrum(bands=0, window="rectangular", segment_length=64, transform_length=64,
                    remove_mean=False, quantity="power")
    power = 2 * np.abs(np.fft.rfft(rows.astype(np.float32))) ** 2 / 64**2
    found = code.fit_transform(rows)
    np.testing.assert_allclose(found[:, 1:-1], power[:, 1:found.shape[1] - 1], rtol=1e-5)


def test_a_sine_is_in_its_band():
    time = np.arange(1000) / 1000
    frames = np.stack([3 * np.sin(2 * np.pi * 55 * time), np.sin(2 * np.pi * 155 * time)], axis=1)
    code = Spectrum(bands=50)
    spectra = code.of(frames, rate=1000)
    assert spectra.shape == (2, 50)
    assert spectra.argmax(axis=1).tolist() == [5, 15]  # bands of 10 Hz
    assert spectra[0].max() == pytest.approx(3 / np.sqrt(2), rel=0.02)
    rows = Spectrum(1000, bands=50).fit_transform(frames.T)
    np.testing.assert_array_equal(rows, spectra)


def test_wrong_spectra_are_named(X):
    with pytest.raises(pysomato.DataError, match="rate"):
        Spectrum().fit(X)
    with pytest.raises(pysomato.UsageError, match="overlap"):
        Spectrum(1000, overlap=2).fit(X)
