"""Sweeps run the program of the package."""

import json

import numpy as np
import pytest

import pysomato
from pysomato import Recording, sweep

SYSTEM = """
[study]
name = "press"
label = "material"
protocols = ["train_is_test"]

[module.depth]
type = "channel"
channel = "depth"

[module.reading]
type = "last"
input = "depth"

[module.map]
type = "som"
input = "reading"
rows = 3
columns = 3
iterations = 100

[[claim]]
text = "All materials are named."
metric = "accuracy"
at_least = 0.9
"""

OVER = """
[sweep]
design = "one_at_a_time"
pairs = 2
recordings = 1

[unknown.side]
key = ["module.map.rows", "module.map.columns"]
values = [1, 4]
text = "The papers do not give it."
"""


@pytest.fixture
def files(tmp_path):
    (tmp_path / "press.toml").write_text(SYSTEM)
    (tmp_path / "over.toml").write_text(OVER)
    return tmp_path


@pytest.fixture
def recording():
    depths = np.arange(8) % 4
    return Recording.from_arrays({"material": [f"m{depth}" for depth in depths]},
                                 {"depth": [np.array([[0.0], [float(depth)]]) for depth in depths]})


def test_results_are_those_of_the_program(files, recording, somato):
    pytest.importorskip("pandas")
    found = sweep(files / "press.toml", files / "over.toml", files / "mine", data=recording)
    recording.write(files / "recording.mcap")
    somato("sweep", files / "press.toml", "--over", files / "over.toml", "--out", files / "theirs",
           "--data", files / "recording.mcap")
    assert found.results == json.loads((files / "theirs/sweep.json").read_text())
    assert found._repr_svg_() == (files / "theirs/sweep.svg").read_text()


def test_results_are_frames(files, recording):
    pytest.importorskip("pandas")
    found = sweep(files / "press.toml", files / "over.toml", files / "out", data=recording, threads=1)
    claim = "All materials are named."
    points = found.points
    assert points.side.isna().tolist() == [True, False, False]
    assert points.side.tolist()[1:] == [1, 4]
    assert points[claim].tolist()[1] == 0  # a single neuron cannot name four materials
    assert found.claims.claim.tolist() == [claim]
    assert found.claims.mean_share[0] == pytest.approx(points[claim].mean())
    assert found.effects.unknown.tolist() == ["side"]
    assert found.effects.change[0] == pytest.approx(points[claim].max() - points[claim].min())


def test_wrong_files_are_named(files, recording):
    with pytest.raises(pysomato.UsageError, match="over.toml:7.*did you mean 'rows'"):
        (files / "over.toml").write_text(OVER.replace("map.rows", "map.row"))
        sweep(files / "press.toml", files / "over.toml", files / "out", data=recording)
    with pytest.raises(pysomato.Error, match="none.toml"):
        sweep(files / "press.toml", files / "none.toml", files / "out", data=recording)
