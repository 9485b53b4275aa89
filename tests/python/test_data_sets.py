"""Data sets of other projects: LeRobotDataset v3 and zarr archives of the Open-X-Tactile layout.

The files of LeRobot are written with pyarrow in the documented layout: the package lerobot needs a later
Python. The archives are written with zarr.
"""

import json
import pickle
import shutil
import sys
import warnings
import zipfile

import numpy as np
import pytest

import pysomato

STATE = {"dtype": "float32", "shape": [2], "names": {"motors": ["shoulder", "elbow"]}}
FEATURES = {
    "observation.state": STATE,
    "observation.touch": {"dtype": "float32", "shape": [2, 3], "names": ["row", "column"]},
    "next.done": {"dtype": "bool", "shape": [1], "names": None},
    "observation.images.wrist": {"dtype": "video", "shape": [8, 8, 3], "names": None},
    "note": {"dtype": "string", "shape": [1], "names": None},
    **{name: {"dtype": "int64", "shape": [1], "names": None}
       for name in ("frame_index", "episode_index", "index", "task_index")},
    "timestamp": {"dtype": "float32", "shape": [1], "names": None},
}
LENGTHS = [4, 1, 3]


def state(episode):
    return np.random.default_rng(episode).random((LENGTHS[episode], 2), np.float32)


def touch(episode):
    return np.random.default_rng(10 + episode).random((LENGTHS[episode], 2, 3), np.float32)


def rows_of(episode, seconds=0.1):
    frames = LENGTHS[episode]
    return {"observation.state": state(episode).tolist(), "observation.touch": touch(episode).tolist(),
            "next.done": [False] * (frames - 1) + [True], "note": ["x"] * frames,
            "timestamp": [frame * seconds for frame in range(frames)],
            "frame_index": list(range(frames)), "episode_index": [episode] * frames,
            "index": list(range(frames)), "task_index": [episode % 2] * frames}


def write_lerobot(folder, info=(), rows=rows_of, length=None):
    """Three episodes: two in the first data file, one in the second."""
    pa = pytest.importorskip("pyarrow")
    from pyarrow import parquet

    (folder / "meta/episodes/chunk-000").mkdir(parents=True)
    (folder / "data/chunk-000").mkdir(parents=True)
    text = json.dumps({"codebase_version": "v3.0", "fps": 10, "features": FEATURES, **dict(info)})
    (folder / "meta/info.json").write_text(text)
    kinds = pa.schema([
        ("observation.state", pa.list_(pa.float32(), 2)),
        ("observation.touch", pa.list_(pa.list_(pa.float32()))), ("next.done", pa.bool_()),
        ("note", pa.string()), ("timestamp", pa.float32()),
        *((name, pa.int64()) for name in ("frame_index", "episode_index", "index", "task_index"))])
    for number, episodes in enumerate([[0, 1], [2]]):
        tables = [pa.Table.from_pydict(rows(episode), schema=kinds) for episode in episodes]
        parquet.write_table(pa.concat_tables(tables),
                            folder / f"data/chunk-000/file-{number:03d}.parquet")
    episodes = {"episode_index": [2, 0, 1], "tasks": [["lift"], ["lift"], ["push", "turn"]],
                "length": [3 if length is None else length, 4, 1], "data/chunk_index": [0, 0, 0],
                "data/file_index": [1, 0, 0], "dataset_from_index": [5, 0, 4],
                "dataset_to_index": [8, 4, 5]}
    parquet.write_table(pa.table(episodes), folder / "meta/episodes/chunk-000/file-000.parquet")
    return folder


def read_quietly(*arguments):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pysomato.LeftOutWarning)
        return pysomato.read(*arguments)


def test_a_lerobot_data_set_is_a_recording(tmp_path):
    recording = read_quietly(write_lerobot(tmp_path / "set"))
    assert [channel["name"] for channel in recording.channels] == [
        "observation.state", "observation.touch", "next.done"]
    for episode in range(3):
        np.testing.assert_array_equal(recording["observation.state"][episode], state(episode))
        np.testing.assert_array_equal(recording["observation.touch"][episode], touch(episode))
    assert recording["next.done"][0].ravel().tolist() == [0, 0, 0, 1]
    assert recording.label("episode").tolist() == ["0", "1", "2"]
    assert recording.label("task").tolist() == ["lift", "push; turn", "lift"]
    assert recording.channels[0]["element_names"] == ["shoulder", "elbow"]
    assert recording.channels[1]["element_names"] == []  # names of axes
    assert recording.channels[1]["unit"] == ""
    assert recording.rates("observation.state") == [10, 10, 10]
    assert recording.sources[2].endswith("file-001.parquet, episode 2")
    recording.write(tmp_path / "set.mcap")
    assert pysomato.read(tmp_path / "set.mcap") == recording


def test_parts_that_are_left_out_are_named(tmp_path):
    folder = write_lerobot(tmp_path / "set")
    with pytest.warns(pysomato.LeftOutWarning, match=r"observation.images.wrist \(pictures\)"):
        recording = pysomato.read(folder)
    assert recording.left_out == {"observation.images.wrist": "pictures", "note": "no numbers"}


def test_frames_at_other_times_have_times(tmp_path):
    folder = write_lerobot(tmp_path / "set", rows=lambda episode: rows_of(episode, 0.11))
    recording = read_quietly(folder)
    np.testing.assert_allclose(recording.times("next.done")[0], [0, 0.11, 0.22, 0.33], rtol=1e-6)


@pytest.mark.parametrize("names, expected", [
    ({"b": 1, "a": 0}, ["a", "b"]), (["x", "y"], ["x", "y"]), (["x"], []), (None, [])])
def test_names_of_elements_have_several_forms(tmp_path, names, expected):
    features = {**FEATURES, "observation.state": {**STATE, "names": names}}
    recording = read_quietly(write_lerobot(tmp_path / "set", {"features": features}))
    assert recording.channels[0]["element_names"] == expected


def test_places_of_names_that_are_none_are_refused(tmp_path):
    for places in ({"a": 0, "b": 2}, {"a": 1, "b": 1}, {"a": 0}):
        features = {**FEATURES, "observation.state": {**STATE, "names": places}}
        with pytest.raises(pysomato.DataError, match="the places of the names of"):
            read_quietly(write_lerobot(tmp_path / str(len(places)) / str(places["a"]),
                                       {"features": features}))


def test_missing_numbers_are_missing_values(tmp_path):
    def rows(episode):
        changed = rows_of(episode)
        changed["observation.state"][0] = [float("nan"), 2.0]
        return changed

    recording = read_quietly(write_lerobot(tmp_path / "set", rows=rows))
    assert recording.valid("observation.state")[0].tolist() == [[0, 1], [1, 1], [1, 1], [1, 1]]
    assert recording.valid("observation.touch") == [None] * 3


@pytest.mark.parametrize("info, message", [
    ({"codebase_version": "v2.1"}, "v2.1, not v3.*convert_dataset_v21_to_v30"),
    ({"fps": 0}, "fps is 0"),
    ({"features": []}, "no features"),
    ({"features": {**FEATURES, "observation.state": {**STATE, "shape": [3]}}}, "not of the shape"),
    ({"features": {**FEATURES, "observation.touch": STATE}}, "'observation.touch' are not of the"),
    ({"features": {**FEATURES, "observation.state": {**STATE, "shape": ["2"]}}}, "info.json.*shape"),
    ({"features": {**FEATURES, "force": STATE}}, "file-000.parquet: there is no column 'force'"),
    ({"features": {"note": FEATURES["note"]}}, "nothing in it can be a channel"),
])
def test_wrong_descriptions_are_refused(tmp_path, info, message):
    with pytest.raises(pysomato.DataError, match=message):
        read_quietly(write_lerobot(tmp_path / "set", info))


def test_wrong_files_are_refused(tmp_path):
    folder = write_lerobot(tmp_path / "set", length=2)
    with pytest.raises(pysomato.DataError, match="episode 2: there are 3 frames, but 2 are listed"):
        read_quietly(folder)
    data = folder / "data/chunk-000/file-000.parquet"
    data.write_bytes(data.read_bytes()[:200])
    with pytest.raises(pysomato.DataError, match="file-000.parquet"):
        read_quietly(folder)
    data.unlink()
    with pytest.raises(pysomato.DataError, match="file-000.parquet: the file is missing"):
        read_quietly(folder)
    shutil.rmtree(folder / "meta/episodes")
    with pytest.raises(pysomato.DataError, match="no episodes"):
        read_quietly(folder)
    (folder / "meta/info.json").write_text("{")
    with pytest.raises(pysomato.DataError, match="info.json: not JSON"):
        read_quietly(folder)


def test_an_empty_episode_is_named(tmp_path):
    def rows(episode):
        return {name: values[:0] for name, values in rows_of(episode).items()} if episode == 2 else (
            rows_of(episode))

    folder = write_lerobot(tmp_path / "set", rows=rows, length=0)
    with pytest.raises(pysomato.DataError,
                       match=r"file-001.parquet, episode 2: the episode is empty.*delete_episodes"):
        read_quietly(folder)
    (folder / "data/chunk-000/file-001.parquet").unlink()
    with pytest.raises(pysomato.DataError, match="episode 2: the episode is empty"):
        read_quietly(folder)


def test_frames_in_another_order_are_refused(tmp_path):
    def rows(episode):
        return {**rows_of(episode), "frame_index": list(range(1, LENGTHS[episode] + 1))}

    with pytest.raises(pysomato.DataError, match="frame_index does not count from 0"):
        read_quietly(write_lerobot(tmp_path / "set", rows=rows))


def test_without_pyarrow_or_zarr_the_message_says_what_to_install(tmp_path, monkeypatch):
    folder, archive = write_lerobot(tmp_path / "set"), write_archive(tmp_path / "task.zarr")
    monkeypatch.setitem(sys.modules, "pyarrow.parquet", None)
    with pytest.raises(ImportError, match=r"needs pyarrow: pip install 'pysomato\[lerobot\]'"):
        pysomato.read(folder)
    monkeypatch.setitem(sys.modules, "zarr", None)
    with pytest.raises(ImportError, match=r"needs zarr: pip install 'pysomato\[zarr\]'"):
        pysomato.read(archive)


TACTILE = np.random.default_rng(3).random((8, 5, 10, 12), np.float32)
JOINTS = np.random.default_rng(4).random((8, 12))
SECONDS = np.array([0.0, 0.1, 0.2, 0.0, 0.1, 0.2, 0.3, 0.5])
TASKS = ["reach", "grasp", "grasp", "place", "place", "place", "place", "place"]


def write_archive(path, ends=(3, 8), **changed):
    """Two episodes of three and five frames, in version 2 of the format."""
    zarr = pytest.importorskip("zarr")
    data = {"right_tactile_data_fingertips": TACTILE, "right_hand_joints": JOINTS,
            "timestamps": SECONDS, "camera_main_rgb": np.zeros((8, 4, 4, 3), np.uint8),
            "right_tactile_area": np.arange(5), "clock": np.arange(8) + 2**40, **changed}
    root = zarr.open_group(str(path), mode="w", zarr_format=2)
    root.create_array("meta/episode_ends", data=np.asarray(ends))
    for name, values in data.items():
        root.create_array(f"data/{name}", data=values, chunks=(min(3, len(values)), *values.shape[1:]))
    texts = root.create_array("data/sub_task_instruction", shape=(8,), chunks=(3,), dtype=str)
    texts[:] = np.array(TASKS)
    return path


def zipped(folder, path, compression=zipfile.ZIP_STORED):
    with zipfile.ZipFile(path, "w", compression) as file:
        for one in sorted(folder.rglob("*")):
            file.write(one, one.relative_to(folder.parent))
    return path


def expect_archive(recording):
    assert len(recording) == 2
    for episode, frames in enumerate((slice(0, 3), slice(3, 8))):
        for name, expected in (("right_tactile_data_fingertips", TACTILE),
                               ("right_hand_joints", JOINTS.astype(np.float32))):
            np.testing.assert_array_equal(recording[name][episode], expected[frames])
            np.testing.assert_array_equal(recording.times(name)[episode], SECONDS[frames])
    assert recording.label("task").tolist() == ["reach; grasp", "place"]
    assert recording.label("episode").tolist() == ["0", "1"]
    assert recording.left_out == {
        "camera_main_rgb": "pictures", "clock": "integers beyond single precision",
        "right_tactile_area": "shape [5] for 8 frames"}


def test_an_archive_is_a_recording(tmp_path):
    with pytest.warns(pysomato.LeftOutWarning, match=r"camera_main_rgb \(pictures\)"):
        recording = pysomato.read(write_archive(tmp_path / "task.zarr"))
    expect_archive(recording)
    recording.write(tmp_path / "task.mcap")
    assert pysomato.read(tmp_path / "task.mcap") == recording


def test_an_archive_in_a_zip_file_is_the_same_recording(tmp_path):
    folder = write_archive(tmp_path / "task.zarr")
    expect_archive(read_quietly(zipped(folder, tmp_path / "task.zarr.zip")))
    expect_archive(read_quietly(zipped(folder, tmp_path / "packed.zip", zipfile.ZIP_DEFLATED),
                                "open_x_tactile"))


@pytest.mark.parametrize("ends, message", [
    ((3, 3), "do not grow"), ((3, 2, 8), "do not grow"), ((0, 8), "do not grow"),
    ((3.0, 8.0), "not a list of integers"),
    ((3, 9), "nothing in it can be a channel"),
])
def test_wrong_ends_of_episodes_are_refused(tmp_path, ends, message):
    with pytest.raises(pysomato.DataError, match=message):
        read_quietly(write_archive(tmp_path / "task.zarr", ends))


def test_values_beyond_single_precision_are_refused(tmp_path):
    joints = JOINTS.copy()
    joints[4, 2] = 1e40
    archive = write_archive(tmp_path / "task.zarr", right_hand_joints=joints)
    with pytest.raises(pysomato.DataError, match=r"episode 1, right_hand_joints: .*frame 1, element 2"):
        read_quietly(archive)


def test_damaged_archives_are_refused(tmp_path):
    folder = write_archive(tmp_path / "task.zarr")
    chunk = next((folder / "data/right_hand_joints").glob("1.*"))
    chunk.write_bytes(b"nothing")
    with pytest.raises(pysomato.DataError, match="right_hand_joints: the array cannot be read"):
        read_quietly(folder)
    shutil.rmtree(folder / "data")
    with pytest.raises(pysomato.DataError, match="no group 'data'"):
        read_quietly(folder)
    archive = zipped(folder, tmp_path / "task.zip")
    archive.write_bytes(archive.read_bytes()[:-30])
    with pytest.raises(pysomato.DataError, match="task.zip"):
        read_quietly(archive, "open_x_tactile")
    with pytest.raises(pysomato.DataError, match="no array meta/episode_ends"):
        read_quietly(tmp_path, "open_x_tactile")


class Program:
    """An object whose pickle writes a file."""

    def __init__(self, path):
        self.path = path

    def __reduce__(self):
        return (open, (str(self.path), "w"))


@pytest.mark.parametrize("packed", [False, True])
def test_programs_in_archives_do_not_run(tmp_path, packed):
    folder = write_archive(tmp_path / "task.zarr")
    array = folder / "data/right_hand_joints"
    description = json.loads((array / ".zarray").read_text())
    (array / ".zarray").write_text(json.dumps({**description, "compressor": {"id": "pickle"}}))
    for chunk in array.glob("[0-9]*"):
        chunk.write_bytes(pickle.dumps(Program(tmp_path / "ran")))
    archive = zipped(folder, tmp_path / "task.zip") if packed else folder
    with pytest.raises(pysomato.DataError, match="right_hand_joints/.zarray: objects in the format"):
        read_quietly(archive)
    assert not (tmp_path / "ran").exists()
