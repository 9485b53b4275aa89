"""Simulated bodies explore as in the program."""

import inspect
import os
import select
from pathlib import Path

import numpy as np
import pytest

import pysomato
from pysomato import explore, read

OBJECTS = Path(__file__).parents[2] / "objects"
TABLE = """
[object]
tin = { shape = "cylinder", diameter = 60, height = 120, material = "wood" }
brick = { shape = "block", width = 50, depth = 50, height = 120, material = "plastic" }
"""


@pytest.fixture
def objects(tmp_path):
    path = tmp_path / "two.toml"
    path.write_text(TABLE)
    return path


def explored_by_program(somato, path, *flags):
    somato("explore", "-o", path, *flags)
    return read(path)


def test_a_hand_explores_as_in_the_program(somato, tmp_path, objects):
    mine = explore("lucs3", objects=objects, explorations=2, seed=5, threads=2, taxels=True)
    theirs = explored_by_program(somato, tmp_path / "hand.mcap", "--body", "lucs3", "--objects", objects,
                                 "--explorations", 2, "--seed", 5, "--taxels", "true")
    assert mine == theirs
    assert mine.label("object").tolist() == ["tin", "tin", "brick", "brick"]
    assert mine.sources == theirs.sources
    assert mine != explore("lucs3", objects=objects, explorations=2, seed=6, taxels=True)


def test_probes_explore_their_materials(somato, tmp_path):
    settings = tmp_path / "settings.toml"
    settings.write_text("[hardness_probe]\nforce_noise = 0.0\n")
    mine = explore("hardness", explorations=3, settings=settings)
    assert mine == explored_by_program(somato, tmp_path / "press.mcap", "--body", "hardness",
                                       "--explorations", 3, "--settings", settings)
    assert len(mine) == 24


def test_own_tables_have_names(somato, tmp_path):
    assert "lucs3_new" in pysomato.object_tables()
    assert explore("hardness", objects="lucs2", explorations=1) == explored_by_program(
        somato, tmp_path / "press.mcap", "--body", "hardness", "--explorations", 1, "--objects",
        OBJECTS / "lucs2.toml")


def test_arrays_of_an_exploration_can_be_learned(objects):
    grasps = explore("lucs3", objects=objects, explorations=2)
    X = np.array([frames[-1] for frames in grasps["joints"]])
    assert pysomato.SOM(3, 3, iterations=50).fit(X, grasps.label("object")).score(X) <= 0


def test_a_device_is_not_reached(tmp_path):
    """Python explores with simulated bodies only: no function takes a device, and no line is opened."""
    host, line = os.openpty()
    path = tmp_path / "hand.toml"
    path.write_text(f'name = "one finger"\nexplore = "holding"\n[servos]\nbus = "sts"\nport = "{os.ttyname(line)}"\n'
                    '[servo.finger]\nchannel = 1\nzero = 2048\nscale = 11.4\nleast = 0\nmost = 90\n'
                    '[sensor.joints]\nfrom = "servos"\nservos = ["finger"]\n')
    for arguments in ({"body": str(path)}, {"body": "lucs3", "objects": path}, {"body": "lucs3", "settings": path},
                      {"body": "lucs3", "device": str(path)}):
        with pytest.raises(pysomato.Error):
            explore(**arguments)
    functions = inspect.getmembers(pysomato, inspect.isfunction)
    assert [name for name, function in functions if "device" in inspect.signature(function).parameters] == []
    assert select.select([host], [], [], 0)[0] == []


@pytest.mark.parametrize("arguments, message", [
    ({"body": "lucs4"}, "did you mean 'lucs2'|did you mean 'lucs3'"),
    ({"body": "lucs2", "objects": "lucs2_new"}, "lucs"),
    ({"body": "lucs2", "taxels": True}, "no effect on the body lucs2"),
    ({"body": "hardness", "placement_noise": 0.0}, "no effect on the body hardness"),
    ({"body": "lucs3", "placement_nose": 0.0}, "did you mean 'placement_noise'"),
    ({"body": "lucs3", "placement_noise": -1.0}, "explore: 'placement_noise' must be"),
    ({"body": "lucs3", "explorations": 0}, "explore\\(explorations\\)"),
    ({"body": "lucs3", "longest": 0}, "explore\\(longest\\)"),
    ({"body": "lucs3", "threads": 0}, "explore\\(threads\\)"),
])
def test_wrong_arguments_are_named(arguments, message):
    with pytest.raises(pysomato.UsageError, match=message):
        explore(**arguments)


def test_explorations_that_fail_are_named(objects):
    with pytest.raises(pysomato.DataError, match="every exploration failed.*tin"):
        explore("lucs3", objects=objects, explorations=1, settings=never_closing(objects))


def never_closing(objects):
    """Settings with less time than a hand needs to close."""
    path = objects.with_name("settings.toml")
    path.write_text("[closing]\nlongest = 0.2\n")
    return path


class Stopped(Exception):
    pass


def test_the_progress_is_shown_and_can_stop(objects):
    explorer = pysomato._somato.Explorer.build("lucs3", str(objects), None, {}, 1)
    shown = []
    recording, failures = explorer.explore(2, 600, 1, lambda *numbers: shown.append(numbers))
    assert (len(recording), failures, shown[-1]) == (4, [], (4, 4))

    def stop(*_):
        raise Stopped

    with pytest.raises(Stopped):
        explorer.explore(10**6, 600, 2, stop)
