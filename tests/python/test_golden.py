"""Files of tests/golden, which commits since the first model format wrote, are read or refused with their version; files
of the next version of each format are refused, too."""

import csv
import json
import os
import pickle
import re
import shutil
import struct
import subprocess
import warnings
from pathlib import Path

import numpy as np
import pytest

import pysomato

google_crc32c = pytest.importorskip("google_crc32c")

GOLDEN = Path(__file__).resolve().parents[1] / "golden/files"
MAGIC = b"\x8fSOMATO\r\n\x1a\n\0"
NAMED = ["apple", "apple", "apple", "banana", "banana"]  # the rows of fruit.csv
OBJECTS = ["cup", "ball", "box"]
PART = "423b1b08f0818795.found"  # as version 0.1.0 named part-5-38dc3eb9.found


def golden(pattern):
    found = sorted(path.name for path in GOLDEN.glob(pattern))
    assert found, pattern
    return found


def run(*words, folder):
    return subprocess.run([os.environ["SOMATO_PROGRAM"], *map(str, words)], check=False, capture_output=True, text=True,
                          cwd=folder)


def crc32c(content):
    return google_crc32c.value(content)


# An independent reader of docs/formats/model-file.md.

def padded(count):
    return (count + 7) // 8 * 8


def parts_of(archive):
    """{name: text or array} of a model file."""
    assert archive.startswith(MAGIC)
    version, length, count, kind = struct.unpack_from("<IQII", archive, 12)
    assert (version, length) == (1, len(archive))
    assert crc32c(archive[:-4]) == struct.unpack("<I", archive[-4:])[0]
    place, parts = 32 + padded(kind), {}
    for _ in range(count):
        type_of, dimensions, name_length = struct.unpack_from("<HHI", archive, place)
        name = archive[place + 8:place + 8 + name_length].decode()
        place += 8 + padded(name_length)
        shape = struct.unpack_from(f"<{dimensions}Q", archive, place)
        place += 8 * dimensions
        letter = {1: "u1", 2: "<f4", 3: "<f8", 4: "<i8"}[type_of]
        values = np.frombuffer(archive, letter, int(np.prod(shape)), place)
        parts[name] = values.tobytes().decode() if type_of == 1 else values.reshape(shape)
        place += padded(values.nbytes)
    return parts


def checked(archive):
    """The archive with the checksum of its bytes."""
    return archive[:-4] + struct.pack("<I", crc32c(archive[:-4]))


def checked_line(text):
    return f"{crc32c(text.encode()):08x} {text}\n"


# Files that are read

@pytest.mark.parametrize("name", golden("som-*.somato"))
def test_maps_name_the_rows_that_they_learned(name, tmp_path):
    done = run("som", "map", GOLDEN / name, GOLDEN / "fruit.csv", "--label-column", "fruit", folder=tmp_path)
    rows = list(csv.DictReader(done.stdout.splitlines()))
    assert [row["label"] for row in rows] == NAMED
    parts = parts_of((GOLDEN / name).read_bytes())
    samples = np.loadtxt(GOLDEN / "fruit.csv", delimiter=",", skiprows=1, usecols=(0, 1))
    mean, scale = parts["standardization"]
    distances = np.linalg.norm((samples - mean)[:, None] / scale - parts["som.weights"], axis=2)
    np.testing.assert_array_equal([int(row["winner"]) for row in rows], distances.argmin(axis=1))
    np.testing.assert_allclose([float(row["distance"]) for row in rows], distances.min(axis=1), rtol=1e-5)


@pytest.mark.parametrize("name", golden("map-*.npz"))
def test_archives_for_other_programs_are_the_maps_of_their_commit(name, tmp_path):
    assert run("som", "import", GOLDEN / name, "-o", "again.map", folder=tmp_path).returncode == 0
    parts = parts_of((tmp_path / "again.map").read_bytes())
    with np.load(GOLDEN / name) as archive:
        np.testing.assert_array_equal(parts["som.weights"], archive["weights"].reshape(6, 2))
        np.testing.assert_array_equal(parts["labels"], archive["labels"].ravel())
        np.testing.assert_array_equal(parts["standardization"], [archive["mean"], archive["scale"]])


def winners_of(results):
    """Winners of `train_is_test` with the first seed, which the saved system has."""
    systems = results["systems"] if "systems" in results else results["parts"][0]["protocols"]
    return next(one["runs"][0]["winners"] for one in systems if one["protocol"] == "train_is_test")


@pytest.mark.parametrize(("name", "results", "data"), [
    ("system-c4220103.somato", "results-1-c4220103.json", "../../../examples/synthetic_grasps"),
    ("system-0c407452.somato", "results-4-0c407452.json", "grasps.mcap"),
    ("system-38dc3eb9.somato", "results-4-38dc3eb9.json", "grasps.mcap")])
def test_systems_find_the_winners_of_their_study(name, results, data, tmp_path):
    shutil.copy(GOLDEN / "recording-38dc3eb9.mcap", tmp_path / "grasps.mcap")
    recording = tmp_path / "grasps.mcap" if data.endswith(".mcap") else GOLDEN / data
    done = run("apply", GOLDEN / name, recording, folder=tmp_path)
    found = [int(row["winner"]) for row in csv.DictReader(done.stdout.splitlines())]
    assert found == winners_of(json.loads((GOLDEN / results).read_text())), done.stderr


@pytest.mark.parametrize("name", golden("recording-*.mcap"))
def test_recordings_have_the_values_of_their_formula(name):
    recording = pysomato.read(GOLDEN / name)
    assert recording.label("object").tolist() == OBJECTS * 2
    assert recording.label("trial").tolist() == ["1"] * 3 + ["2"] * 3
    frames = np.arange(4)[:, None]
    for exploration in range(6):
        value = exploration % 3 * 10 + frames + np.arange(5) / 8 + exploration // 3 / 4
        np.testing.assert_allclose(recording["joints"][exploration], value[:, :2], rtol=1e-6)  # in radians in the file
        np.testing.assert_array_equal(recording["touch"][exploration], value[:, 2:].astype(np.float32))
        np.testing.assert_array_equal(recording.times("touch")[exploration], np.arange(4) / 4)
    assert [channel["unit"] for channel in recording.channels] == ["deg", "N"]


@pytest.mark.parametrize("name", golden("results-4-*.json"))
def test_results_make_a_report_with_their_accuracy(name, tmp_path):
    done = run("report", GOLDEN / name, "-o", "report.html", folder=tmp_path)
    if "was built without" in done.stderr:
        pytest.skip("the program has no pages")
    assert done.stdout.startswith("report.html: 1 system, 0 claims"), done.stderr
    values = json.loads((GOLDEN / name).read_text())["parts"][0]["protocols"][0]["metrics"]["quantization_error"]["values"]
    assert all(repr(value) in (tmp_path / "report.html").read_text() for value in values)


def quantization_errors(folder):
    results = json.loads((folder / "out/results.json").read_text())
    return results["parts"][0]["protocols"][0]["metrics"]["quantization_error"]["values"]


def test_a_journal_of_this_format_is_continued(tmp_path):
    shutil.copy(GOLDEN / "recording-38dc3eb9.mcap", tmp_path / "grasps.mcap")
    journal = (GOLDEN / "journal-8-38dc3eb9.journal").read_text()
    expected = json.loads((GOLDEN / "results-4-38dc3eb9.json").read_text())
    values = expected["parts"][0]["protocols"][0]["metrics"]["quantization_error"]["values"]
    line = next(line for line in journal.splitlines() if '"training":1,' in line)
    distance = re.search('"summed_distance":([^,]*)', line).group(1)
    changed = line[9:].replace(distance, str(2 * float(distance)))
    for text, factor in ((journal, 1), (journal.replace(line + "\n", checked_line(changed)), 2)):
        shutil.rmtree(tmp_path / "out", ignore_errors=True)
        (tmp_path / "out").mkdir()
        (tmp_path / "out/unfinished.journal").write_text(text)
        done = run("run", GOLDEN / "study.toml", "--data", "grasps.mcap", "--out", "out", folder=tmp_path)
        assert done.returncode == 0, done.stderr
        found = quantization_errors(tmp_path)
        assert found == pytest.approx([values[0], values[1] * factor]) or found == pytest.approx([values[0] * factor, values[1]])
        assert sum(found) != pytest.approx(sum(values)) or factor == 1


def sweep(folder, part=None, name=PART):
    shutil.copy(GOLDEN / "recording-38dc3eb9.mcap", folder / "grasps.mcap")
    kept = folder / "out/parts/1-of-1"
    kept.mkdir(parents=True, exist_ok=True)
    if part is not None:
        (kept / name).write_text(part)
    return run("sweep", GOLDEN / "system.toml", "--over", GOLDEN / "over.toml", "--data", "grasps.mcap", "--out", "out",
               folder=folder)


def test_a_part_of_this_format_is_used_under_the_name_that_0_1_0_gave_it(tmp_path):
    part = (GOLDEN / "part-5-38dc3eb9.found").read_text()
    changed = part[9:].rstrip("\n").replace('["classes_separated",[3.0]', '["classes_separated",[1.5]')
    assert sweep(tmp_path, checked_line(changed)).returncode == 0
    values = [value for point in json.loads((tmp_path / "out/sweep.json").read_text())["points"]
              for value in point["claims"][0]["values"]]
    assert 1.5 in values


def test_recordings_have_the_names_that_0_1_0_gave_them(tmp_path):
    done = run("reproduce", GOLDEN / "press.toml", "--pairs", "1", "--recordings", "1", "--out", "out", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    if "MuJoCo 3.17.0" not in pysomato.read(next((tmp_path / "out/recordings").glob("*.mcap"))).sources[0]:
        pytest.skip("another engine explores other recordings")
    assert [path.name for path in (tmp_path / "out/recordings").glob("*.mcap")] == ["hardness-9d300f85-2011.mcap"]


@pytest.mark.parametrize("name", golden("checkpoint-*.somato"))
def test_a_training_continues_from_its_checkpoint(name, tmp_path):
    archive = bytearray((GOLDEN / name).read_bytes())
    parts = parts_of(bytes(archive))
    done = int(parts["epochs"][0])
    place = archive.find(b"epochs\0\0") + 8 + 8
    assert struct.unpack_from("<q", archive, place)[0] == done > 1
    struct.pack_into("<q", archive, place, 100_000_000)  # so that none is left
    (tmp_path / "checkpoint").write_bytes(checked(bytes(archive)))
    again = run("som", "train", GOLDEN / "fruit.csv", "--label-column", "fruit", "--standardize", "--training", "batch",
                "--rows", "2", "--columns", "3", "--epochs", "100000000", "--checkpoint", "checkpoint", "-o", "a.map",
                folder=tmp_path)
    assert again.returncode == 0, again.stderr
    np.testing.assert_array_equal(parts_of((tmp_path / "a.map").read_bytes())["som.weights"], parts["som.weights"])


@pytest.mark.parametrize("name", golden("estimators-*.pickle"))
def test_pickles_predict_what_they_predicted(name):
    X = np.loadtxt(GOLDEN / "fruit.csv", delimiter=",", skiprows=1, usecols=(0, 1)).astype(np.float32)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # scikit-learn of another version
        som, classifier = pickle.loads((GOLDEN / name).read_bytes())
    assert som.predict(X).tolist() == [2, 2, 2, 3, 3]  # as printed by the program that wrote them
    assert classifier.predict(X).tolist() == NAMED
    np.testing.assert_allclose(som.weights_.reshape(6, 2)[[0, 5]], [[144.55298, 143.14226], [177.78725, 87.751396]], rtol=1e-6)


# Files of other versions: the table of formats. `read` gives what the program or the package says about the file.

def said_about_journal(path, folder):
    shutil.copy(GOLDEN / "recording-38dc3eb9.mcap", folder / "grasps.mcap")
    (folder / "out").mkdir(exist_ok=True)
    shutil.copy(path, folder / "out" / ("unfinished" + path.suffix))
    return run("run", GOLDEN / "study.toml", "--data", "grasps.mcap", "--out", "out", folder=folder).stderr


def said_about_pickle(path, _):
    with pytest.raises(pysomato.Error) as caught:
        pickle.loads(path.read_bytes())
    return str(caught.value)


READERS = {
    "som": lambda path, folder: run("som", "map", path, GOLDEN / "fruit.csv", folder=folder).stderr,
    "system": lambda path, folder: run("apply", path, GOLDEN / "recording-38dc3eb9.mcap", folder=folder).stderr,
    "checkpoint": lambda path, folder: run("som", "train", GOLDEN / "fruit.csv", "--label-column", "fruit", "--training",
                                           "batch", "--checkpoint", path, "-o", "a.map", folder=folder).stderr,
    "map": lambda path, folder: run("som", "import", path, "-o", "a.map", folder=folder).stderr,
    "recording": lambda path, folder: run("inspect", path, folder=folder).stderr,
    "results": lambda path, folder: run("report", path, "-o", "a.html", folder=folder).stderr,
    "reproduction": lambda path, folder: run("report", path, "-o", "a.html", folder=folder).stderr,
    "inference": lambda path, folder: run("report", path, "-o", "a.html", folder=folder).stderr,
    "journal": said_about_journal,
    "part": lambda path, folder: sweep(folder, path.read_text()).stderr,
    "estimators": said_about_pickle,
}
SUPPORTED = {"som": 1, "system": 1, "checkpoint": 1, "map": 1, "recording": 1, "results": 4, "reproduction": 4,
             "inference": 1, "journal": 8, "part": 5, "estimators": 1}
ADVICE = {"results": "of this version again", "reproduction": "of this version again",
          "journal": "complete that study with that version", "part": "complete the sweep with that version"}


def earlier():
    """(file, format, version) of the golden files of earlier versions."""
    named = [(name, re.fullmatch(r"([a-z]+)-(\d+)-.*", name)) for name in golden("*-*")]
    all_files = [(name, found.group(1), int(found.group(2))) for name, found in named if found]
    return [one for one in all_files if one[2] < SUPPORTED[one[1]]]


@pytest.mark.parametrize(("name", "format_name", "version"), earlier())
def test_earlier_versions_are_refused_with_their_version_and_advice(name, format_name, version, tmp_path):
    said = READERS[format_name](GOLDEN / name, tmp_path)
    assert f"earlier version of Somato (format {version}, supported is {SUPPORTED[format_name]})" in said
    assert ADVICE[format_name] in said


def archive_of_next_version(archive):
    (length,) = struct.unpack_from("<Q", archive, 16)
    version = struct.pack("<I", struct.unpack_from("<I", archive, 12)[0] + 1)
    return checked(archive[:12] + version + archive[16:length]) + archive[length:]


def recording_of_next_version(content):
    profile = struct.pack("<I", 6) + b"somato"
    assert content[17:27] == profile  # after the magic and the head of the first record
    (length,) = struct.unpack_from("<Q", content, 9)
    return content[:9] + struct.pack("<Q", length + 2) + struct.pack("<I", 8) + b"somato 2" + content[27:]


def map_of_next_version(path):
    with np.load(GOLDEN / "map-38dc3eb9.npz") as archive:
        np.savez(path, **{**archive, "file_format": np.array("somato map 2")})
    return path.read_bytes()


def line_of_next_version(content, key):
    first, rest = content.decode().split("\n", 1)
    text = re.sub(rf'"{key}":(\d+)', lambda found: f'"{key}":{int(found.group(1)) + 1}', first[9:])
    return (checked_line(text) + rest).encode()


def json_of_next_version(content):
    return re.sub(rb'"version": ?(\d+)', lambda found: b'"version":%d' % (int(found.group(1)) + 1), content, count=1)


def pickle_of_next_version(content):
    place = content.find(MAGIC)
    return content[:place] + archive_of_next_version(content[place:])


NEXT = {
    "som-38dc3eb9.somato": archive_of_next_version,
    "system-38dc3eb9.somato": archive_of_next_version,
    "checkpoint-38dc3eb9.somato": archive_of_next_version,
    "map-38dc3eb9.npz": None,
    "recording-38dc3eb9.mcap": recording_of_next_version,
    "results-4-38dc3eb9.json": json_of_next_version,
    "inference-1-38dc3eb9.json": json_of_next_version,
    "journal-8-38dc3eb9.journal": lambda content: line_of_next_version(content, "somato_journal"),
    "part-5-38dc3eb9.found": lambda content: line_of_next_version(content, "somato_part"),
    "estimators-da67c697.pickle": pickle_of_next_version,
}


@pytest.mark.parametrize("name", NEXT)
def test_the_next_version_of_each_format_is_refused_with_advice(name, tmp_path):
    format_name = name.split("-")[0]
    folder = tmp_path / "files"
    folder.mkdir()
    path = folder / ("inference.json" if format_name == "inference" else name)
    path.write_bytes(NEXT[name]((GOLDEN / name).read_bytes()) if NEXT[name] else map_of_next_version(path))
    said = READERS[format_name](path, tmp_path)
    supported = SUPPORTED[format_name]
    assert f"newer version of Somato (format {supported + 1}, supported is {supported})" in said
    assert "update Somato" in said


def test_every_format_has_a_next_version():
    assert {name.split("-")[0] for name in NEXT} == SUPPORTED.keys() - {"reproduction"}
    assert READERS.keys() == SUPPORTED.keys()
