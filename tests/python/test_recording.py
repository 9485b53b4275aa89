"""Recordings: arrays, labels, files."""

import gc

import numpy as np
import pytest

import pysomato
from pysomato import Recording, read


@pytest.fixture
def arrays():
    random = np.random.default_rng(5)
    return {"touch": [random.random((frames, 2, 3), np.float32) for frames in (4, 1, 6)],
            "joints": [random.random((frames, 5), np.float32) for frames in (4, 1, 6)]}


@pytest.fixture
def recording(arrays):
    return Recording.from_arrays(
        {"object": ["ball", "cube", "ball"], "trial": [1, 2, 3]}, arrays,
        units={"touch": "N"}, rates={"touch": 100},
        times={"joints": [np.arange(frames) / 8 for frames in (4, 1, 6)]},
        element_names={"joints": ["a", "b", "c", "d", "e"]})


def expect_arrays(recording, arrays):
    for name, expected in arrays.items():
        found = recording[name]
        assert len(found) == len(expected)
        for mine, given in zip(found, expected):
            assert mine.dtype == np.float32
            np.testing.assert_array_equal(mine, given)


def test_arrays_come_back(recording, arrays):
    expect_arrays(recording, arrays)
    assert len(recording) == 3
    assert recording.channels[0] == {"name": "touch", "unit": "N", "element_names": [], "shape": [2, 3]}
    assert recording.channels[1]["element_names"] == ["a", "b", "c", "d", "e"]
    assert recording.rates("touch") == [100, 100, 100]
    np.testing.assert_allclose(recording.times("touch")[0], [0, 0.01, 0.02, 0.03], rtol=1e-12)
    np.testing.assert_array_equal(recording.times("joints")[2], np.arange(6) / 8)
    assert recording.valid("touch") == [None] * 3


def test_labels_are_a_frame(recording):
    pandas = pytest.importorskip("pandas")
    expected = pandas.DataFrame({"object": ["ball", "cube", "ball"], "trial": ["1", "2", "3"]})
    pandas.testing.assert_frame_equal(recording.labels, expected)
    assert recording.label("object").tolist() == ["ball", "cube", "ball"]
    again = Recording.from_arrays(recording.labels, {"touch": recording["touch"]})
    assert again.label("trial").tolist() == ["1", "2", "3"]


def test_files_come_back(recording, arrays, tmp_path):
    recording.write(tmp_path / "grasps.mcap")
    back = read(tmp_path / "grasps.mcap")
    expect_arrays(back, arrays)
    assert back == recording
    assert back != Recording.from_arrays({"object": [1, 2, 3]}, {"touch": arrays["touch"]})


def test_the_program_reads_what_is_written(recording, tmp_path, somato):
    recording.write(tmp_path / "grasps.mcap")
    printed = somato("inspect", tmp_path / "grasps.mcap")
    assert "explorations: 3" in printed
    assert "joints" in printed


def test_frames_are_views_that_keep_the_recording(recording, arrays):
    first, again = recording["touch"][0], recording["touch"][0]
    assert first.ctypes.data == again.ctypes.data
    with pytest.raises(ValueError, match="read-only"):
        first[0] = 0
    frames = Recording.from_arrays({"object": ["a"]}, {"touch": [arrays["touch"][0]]})["touch"][0]
    gc.collect()
    np.testing.assert_array_equal(frames, arrays["touch"][0])


def test_missing_values_and_sources_come_back(arrays, tmp_path):
    marks = [np.ones((4, 2, 3)), None, np.ones((6, 2, 3), bool)]
    marks[0][1, 0, 2] = 0
    arrays["touch"][0][1, 0, 2] = np.nan
    recording = Recording.from_arrays({"object": ["a", "b", "c"]}, {"touch": arrays["touch"]},
                                      valid={"touch": marks}, sources=["first", "second", "third"])
    assert recording.sources == ["first", "second", "third"]
    np.testing.assert_array_equal(recording.valid("touch")[0], marks[0])
    assert recording.valid("touch")[1] is None
    assert recording["touch"][0][1, 0, 2] == 0
    recording.write(tmp_path / "missing.mcap")
    assert read(tmp_path / "missing.mcap")["touch"][0][1, 0, 2] == 0
    with pytest.raises(pysomato.DataError, match="validity marks"):
        Recording.from_arrays({}, {"touch": arrays["touch"][1:2]}, valid={"touch": [np.ones((2, 6))]})


def test_names_that_are_missing_are_named(recording, arrays):
    with pytest.raises(pysomato.UsageError, match="did you mean 'touch'"):
        recording["tuoch"]
    with pytest.raises(pysomato.UsageError, match="labels are: object, trial"):
        recording.label("thing")
    with pytest.raises(pysomato.UsageError, match="channels are: touch, joints"):
        Recording.from_arrays({}, arrays, units={"tuoch": "N"})
    with pytest.raises(pysomato.UsageError, match="same length"):
        Recording.from_arrays({"object": ["ball"]}, arrays)


def test_contradictions_are_refused(arrays):
    arrays["touch"][1][0, 0, 0] = np.nan
    with pytest.raises(pysomato.DataError, match="touch"):
        Recording.from_arrays({}, {"touch": arrays["touch"]})


def test_files_that_are_no_recordings_are_refused(tmp_path):
    with pytest.raises(pysomato.OperatingSystemError, match="missing.mcap"):
        read(tmp_path / "missing.mcap")
    (tmp_path / "text.mcap").write_text("not a recording at all")
    with pytest.raises(pysomato.DataError, match="text.mcap"):
        read(tmp_path / "text.mcap")
    with pytest.raises(pysomato.UsageError, match="icub_grasp"):
        read(tmp_path, "icub_grasps")
