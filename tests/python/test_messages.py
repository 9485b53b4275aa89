"""Messages name arguments of Python, never flags of the program."""

import re
from inspect import signature

import numpy as np
import pytest

import pysomato
from pysomato import SOM, TMPSOM, OneHot, Recording, SOMClassifier, Spectrum, System, TensorProduct

FLAG = re.compile(r"(?<![\w-])--[a-z]")
WRONG = [None, True, False, -1, 0, 1.5, "x", "automatic", [1, 2], {"a": 1}, float("nan"), 10**20, 10**400]


def refusal(call, kinds=pysomato.Error):
    """The message of the error, or an empty text if there is none."""
    try:
        call()
    except kinds as error:
        assert not FLAG.search(str(error)), error
        return str(error)
    return ""


@pytest.mark.parametrize("estimator", [SOM, TMPSOM, OneHot, Spectrum, TensorProduct])
def test_of_estimators_name_the_parameter_as_python_writes_values(estimator, X, labels):
    names = [name for name in signature(estimator).parameters if name not in ("unlabelled", "verbose")]
    refused = 0
    for name in names:
        for value in WRONG:
            message = refusal(lambda: estimator(**{name: value}).fit(X, labels))
            assert not re.search(r'"automatic"|\bnot (true|false)\b', message), message
            refused += bool(message)
    assert refused > 4 * len(names)
    assert "not None" in refusal(lambda: SOM(epochs=None, training="batch").fit(X))
    assert "None is also accepted" in refusal(lambda: SOM(iterations="x").fit(X))
    assert "True or False, not 1" in refusal(lambda: SOM(normalize_input=1).fit(X))


@pytest.mark.filterwarnings("ignore")
def test_of_rows_and_labels(X, labels):
    som = SOM(3, 3, iterations=50).fit(X, labels)
    holes = np.where(np.arange(X.size).reshape(X.shape) == 5, np.nan, X)
    wrong = [None, 1, "x", [], {}, [[1]], [["a"]], X[0], X[:, :2], X[:0], holes, holes * np.inf, X.astype(float) * 1e38,
             X * 1j, X.astype("datetime64[s]"), [[1], [1, 2]], object()]
    for rows in wrong:
        for call in (SOM().fit, SOM(missing="mean").fit, SOMClassifier().fit, som.predict, som.transform,
                     som.partial_fit, TMPSOM().fit):
            refusal(lambda: call(rows), Exception)
        assert refusal(lambda: som.predict(rows), Exception)
        assert refusal(lambda: SOMClassifier().fit(X, rows), Exception)
    for panel in ("x", "components", 99, -1):
        assert refusal(lambda: som.plot(panel))
        assert panel == "components" or refusal(lambda: som.draw([panel]))


FILES = {
    "numbers.csv": "a,,b\n1,2,\n", "text.mcap": "not a recording", "empty.mcap": "",
    "keys.toml": "[study]\nprotocols = [\"test_data\"]\n[module.map]\ntype = \"som\"\ninput = \"touch\"\n",
    "automatic.toml": "[study]\nseeds = \"automatic\"\n", "channel.toml": "[[channel]]\n",
    "folder/some.csv": "a\n1\n", "folder/data.log": "1 2 3\n", "dump/data.log": "x\n", "dump/info.log": "Type: x;\n",
}


@pytest.fixture
def files(tmp_path):
    for name, text in FILES.items():
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
    return [*(tmp_path / name for name in FILES), tmp_path / "folder", tmp_path / "dump", tmp_path,
            tmp_path / "gone"]


def test_of_files(files):
    for path in files:
        if path.name == "empty.mcap":  # which may be a file of settings
            continue
        for call in (pysomato.read, pysomato.load, System, SOM.load, SOMClassifier.load,
                     lambda path: pysomato.read(path, "yarp"), lambda path: pysomato.read(path, "icub_grasp"),
                     lambda path: pysomato.explore("lucs3", objects=path, explorations=1),
                     lambda path: pysomato.explore("lucs3", settings=path, explorations=1)):
            if call is pysomato.read and path.suffix != ".mcap":  # it may be a table of numbers
                continue
            assert refusal(lambda: call(path)), path


def test_of_studies_and_simulations(files):
    recording = Recording.from_arrays({"object": ["a", "b"] * 3, "trial": [1, 1, 2, 2, 3, 3]},
                                      {"joints": list(np.random.default_rng(1).random((6, 3, 20)))})
    for settings in ({"protocols": ["test_data"]}, {"protocols": ["x"]}, {"seeds": None}, {"seeds": 0},
                     {"label": "x"}, {"unknown": 1}, {"folds": True}, {"sedes": 1}, {"missing": "mean"}):
        assert refusal(lambda: pysomato.study(recording, "icub_joints", **settings)), settings
    for settings in ({"seed": None}, {"label": 1}, {"budget": 0}, {"x": 1}):
        assert refusal(lambda: pysomato.suggest(recording, **settings)), settings
    for body, simulation in (("x", {}), ("lucs3", {"rate": None}), ("lucs3", {"x": 1}), ("texture", {"taxels": 2})):
        assert refusal(lambda: pysomato.explore(body, explorations=1, **simulation)), (body, simulation)


def test_of_the_program_that_the_package_runs(files, tmp_path):
    toml = tmp_path / "over.toml"
    toml.write_text("[sweep]\n")
    for over in (toml, tmp_path / "gone"):
        for system in ("icub_joints", files[3]):
            assert refusal(lambda: pysomato.sweep(system, over, tmp_path / "out", data=files[0]))
    assert refusal(lambda: pysomato.sweep("tensor_chain", toml, files[0], data=files[1]))
    assert pysomato._program._with_arguments("x: wrong; use --test-data, or omit --out (--part 1/2) a--b") == (
        "x: wrong; use test_data, or omit out (part 1/2) a--b")
