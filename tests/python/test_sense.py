"""The sensors of simulated bodies are played as in the program."""

import warnings

import numpy as np
import pytest

import pysomato
from pysomato import explore, read, sense


@pytest.fixture(scope="module")
def presses():
    return explore("hardness", explorations=2, seed=5, true_values=True)


def readings(recording):
    """Everything but the sources, which state that sensors are played."""
    names = [channel["name"] for channel in recording.channels]
    return (recording.channels, [recording.label(name).tolist() for name in ("material", "hardness", "trial")],
            {name: [frames.tolist() for frames in recording[name]] for name in names})


def test_the_settings_of_the_exploration_give_its_readings(presses):
    assert readings(sense(presses)) == readings(explore("hardness", explorations=2, seed=5))
    assert readings(sense(presses, seed=5, true_values=True)) == readings(presses)
    assert readings(sense(presses, seed=6)) != readings(sense(presses))
    assert sense(presses, seed=6, threads=1) == sense(presses, seed=6, threads=3)


def test_the_source_states_that_sensors_are_played(presses):
    assert sense(presses).sources == [source + ", sensors played, seed 5" for source in presses.sources]


def test_a_warning_says_that_default_sensors_are_not_those_of_the_exploration(tmp_path, presses):
    settings = tmp_path / "settings.toml"
    settings.write_text("[hardness_probe]\npotentiometer_bits = 12\nstroke = 60.0\n[simulation]\ntrue_values = true\n")
    coarse = explore("hardness", explorations=1, settings=settings)
    with pytest.warns(pysomato.SettingsWarning, match="other sensors.*give the settings of the exploration$") as caught:
        played = sense(coarse, potentiometer_bits=12)
    assert caught[0].filename == __file__
    assert not any(channel["name"].startswith("true_") for channel in played.channels)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        again = sense(coarse, settings=settings)
        kept = sense(coarse, settings=settings, true_values=True)
        sense(presses)
    assert [channel["name"] for channel in again.channels] == ["potentiometer"]
    assert readings(kept) == readings(coarse)


def test_sensors_are_played_as_by_the_program(somato, tmp_path, presses):
    somato("explore", "--body", "hardness", "--explorations", 2, "--seed", 5, "--true-values", "true",
           "-o", tmp_path / "presses.mcap")
    somato("sense", tmp_path / "presses.mcap", "--seed", 8, "--potentiometer-bits", 8, "--press-spread", 0.1,
           "--objects", "felt,rubber", "--explorations", 1, "-o", tmp_path / "played.mcap")
    played = sense(presses, seed=8, potentiometer_bits=8, press_spread=0.1, objects=["felt", "rubber"], explorations=1)
    assert played == read(tmp_path / "played.mcap")
    assert played.label("material").tolist() == ["felt", "rubber"]


def test_readings_follow_from_the_true_values(presses):
    """The formula of the converter, in numpy."""
    sticks = np.array([np.float64(stick).sum() for stick in presses["true_stick"]])
    played = sense(presses, potentiometer_noise=0.0, potentiometer_bits=10, potentiometer_path=40.0)
    np.testing.assert_array_equal(np.concatenate(played["potentiometer"], axis=None),
                                  np.round(sticks * (1023 / 40.0)))


def test_settings_files_of_the_exploration_count(tmp_path, presses):
    settings = tmp_path / "settings.toml"
    settings.write_text("[hardness_probe]\nforce = 2.0\npotentiometer_bits = 8\n[simulation]\njoint_noise = 3.0\n")
    assert sense(presses, settings=settings) == sense(presses, potentiometer_bits=8)


@pytest.mark.parametrize("arguments, message", [
    ({"objects": ["fell"]}, "did you mean 'felt'"),
    ({"objects": "felt"}, "list of names"),
    ({"explorations": 3}, "has 2 explorations, not 3"),
    ({"joint_noise": 0.1}, "joint_noise|no effect"),
    ({"potentiometer_bit": 8}, "did you mean 'potentiometer_bits'"),
    ({"potentiometer_bits": 0}, "'potentiometer_bits' must be"),
    ({"force": 2.0}, "force"),
])
def test_wrong_arguments_are_named(presses, arguments, message):
    with pytest.raises(pysomato.UsageError, match=message):
        sense(presses, **arguments)


def test_recordings_without_true_values_are_refused(presses):
    with pytest.raises(pysomato.UsageError, match="no true values.*true_values = true"):
        sense(sense(presses))
