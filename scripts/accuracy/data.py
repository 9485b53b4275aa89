"""The shared data sets as vectors with labels, in recorded order."""

import csv
import hashlib
import math
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import numpy as np

import pysomato

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import fcps_report  # noqa: E402: its folder is that of the scripts

SHARES = (0.2, 0.3, 0.5, 1.0)  # of the frames of a grasp


@dataclass(frozen=True)
class Samples:
    """`vectors`: float64 of (samples, columns), in the units of the sensors; `labels`: texts of (samples,)."""
    vectors: np.ndarray
    labels: np.ndarray

    def hash(self):
        """The first digits of the SHA-256 of all values and labels."""
        digest = hashlib.sha256(np.ascontiguousarray(self.vectors).tobytes())
        digest.update("\0".join(self.labels).encode())
        return digest.hexdigest()[:12]


@dataclass(frozen=True)
class DataSet:
    """A data set: its name, its vector in words, the folder or file below the folder of all sets, the function
    that reads it, and the group of tables in which it appears."""
    name: str
    text: str
    place: str
    read: Callable
    group: str = "touch"


def ordered(vectors, labels, keys):
    """Samples in ascending order of their keys."""
    order = sorted(range(len(keys)), key=keys.__getitem__)
    return Samples(np.asarray(vectors, np.float64)[order], np.asarray(labels, str)[order])


def table(path):
    rows = pysomato.read(path, label_column="object", skip=["slipped"])
    return ordered([frames[0] for frames in rows["columns"]], rows.label("object"), range(len(rows)))


def outputs(recording, system, module):
    """The output of a module of a published study for each exploration, as a flat vector. The module and
    those before it must not learn from the data."""
    trained = pysomato.System(system).fit(recording, threads=1, progress=False)
    return [np.ravel(output) for output in trained.evaluate(recording, module, threads=1)]


def fabricslide(path):
    """In the order of the logger's clock, which the files contain."""
    recording = pysomato.read(path, format="fabricslide")
    clock = [int(Path(path, source).read_text(encoding="utf-8").splitlines()[1].split(",")[0])
             for source in files(path, recording)]
    return ordered(outputs(recording, "fabricslide", "spectrum"), recording.label("fabric"), clock)


def files(folder, recording):
    """The file of each exploration."""
    names = {path.name: path for path in Path(folder).rglob("*") if path.is_file()}
    return [names[Path(source).name] for source in recording.sources]


def hkust_press_slide(path):
    recording = pysomato.read(path, format="hkust_press_slide")
    return ordered(outputs(recording, "hkust_press", "curve"), recording.label("material"), range(len(recording)))


def acoustic_hardness(path):
    """In the order of time, which the index of the set contains; its files have random names."""
    recording = pysomato.read(path, format="acoustic_hardness")
    with open(Path(path, "index.tsv"), encoding="utf-8", newline="") as index:
        time = {Path(row["file"]).name: row["timestamp"] for row in csv.DictReader(index, delimiter="\t")}
    return ordered(outputs(recording, "acoustic_surface", "spectrum"), recording.label("material"),
                   [time[Path(source).name] for source in recording.sources])


def icub_recording(path):
    return pysomato.read(path, format="icub_grasp")


def icub_samples(recording, vectors):
    return ordered(vectors, recording.label("object"), range(len(recording)))


def icub_last(path):
    """The last frame of nine joints and 60 taxels."""
    recording = icub_recording(path)
    return icub_samples(recording, [np.concatenate([joints[-1], np.ravel(taxels[-1])])
                                    for joints, taxels in zip(recording["joints"], recording["taxels"])])


def icub_change(path):
    """The last frame minus the first."""
    recording = icub_recording(path)
    return icub_samples(recording, [np.concatenate([joints[-1] - joints[0], np.ravel(taxels[-1] - taxels[0])])
                                    for joints, taxels in zip(recording["joints"], recording["taxels"])])


def grasp_features(joints, taxels):
    """The 19 features of each frame by which the set's own script describes a grasp: nine joint angles,
    and the mean and the standard deviation (with n - 1) of the twelve taxels of each finger."""
    fingers = np.reshape(taxels, (len(taxels), 5, 12))
    return np.hstack([joints, fingers.mean(axis=2), fingers.std(axis=2, ddof=1)])


def frames_in(share, frames):
    """The number of frames in the first share of a grasp, at least one, as in `[altered.NAME]` of a study."""
    return max(1, math.ceil(share * frames))


def part_of_grasp(path, share, is_change):
    """The last frame of the first share of each grasp, as it is or minus the first frame of the grasp."""
    recording = icub_recording(path)
    vectors = []
    for joints, taxels in zip(recording["joints"], recording["taxels"]):
        features = grasp_features(joints.astype(np.float64), taxels.astype(np.float64))
        features = features[:frames_in(share, len(features))]
        vectors.append(features[-1] - features[0] * is_change)
    return icub_samples(recording, vectors)


def points(name):
    """Reads a point set of the FCPS, in the order of its lines."""
    def read(path):
        vectors = np.loadtxt(path)
        return ordered(vectors, fcps_report.labels_of(name), range(len(vectors)))
    return read


def early_name(share, is_change):
    return f"grasp_{share * 100:.0f}_{'change' if is_change else 'frame'}"


SETS = {data_set.name: data_set for data_set in (
    DataSet("bts3v2_palm_45", "72 electrodes of three fingertips, 41 objects", "bts3v2_palm_45/bts3v2_palm_45.csv",
            table),
    DataSet("bts3v2_palm_45_test", "the same, ten other objects", "bts3v2_palm_45/bts3v2_palm_45_test.csv", table),
    DataSet("icub_last", "nine joints and 60 taxels, last frame", "icub_grasp", icub_last),
    DataSet("icub_change", "the same, last frame minus first", "icub_grasp", icub_change),
    DataSet("fabricslide", "spectra of 16 taxels in cycles per mm (`studies/fabricslide.toml`)", "fabricslide",
            fabricslide),
    DataSet("hkust_press_slide", "20 points of the force of a press (`studies/hkust_press.toml`)",
            "hkust_press_slide", hkust_press_slide),
    DataSet("acoustic_hardness", "24 bands of an impact's sound (`studies/acoustic_surface.toml`)",
            "acoustic_hardness", acoustic_hardness),
    *(DataSet(name, "coordinates", f"fcps/{name}.data", points(name), "points") for name in fcps_report.LINES),
    *(DataSet(early_name(share, is_change), f"19 features after {share * 100:.0f} % of the frames", "icub_grasp",
              lambda path, share=share, is_change=is_change: part_of_grasp(path, share, is_change), "early")
      for is_change in (False, True) for share in SHARES))}
