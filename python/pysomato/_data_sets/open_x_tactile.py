"""Zarr archives of the Open-X-Tactile layout: arrays of all frames in ``data``, and in
``meta/episode_ends`` the number of frames up to the end of each episode. An archive is a folder, or
a folder in a zip file.

Source of the layout: https://open-x-tactile.github.io
"""

import contextlib
import json
import os
import zipfile
from pathlib import Path

import numpy as np

from .channels import are_pictures, channels_of, imported
from ..errors import DataError, OperatingSystemError

_ENDS = "meta/episode_ends"
_DESCRIPTIONS = (".zarray", "zarr.json")  # of an array, in versions 2 and 3 of zarr
_TIMES = "timestamps"
_INSTRUCTION = "sub_task_instruction"


def recognizes(path):
    try:
        return _root_of(path) is not None
    except (OSError, zipfile.BadZipFile):
        return False


def read(path):
    """The arguments of Recording.from_arrays, and what is left out: the reason by the name."""
    zarr = imported("zarr", "zarr")
    try:
        root = _root_of(path)
        if root is None:
            raise DataError(f"there is no array {_ENDS}", path, "use an archive of Open-X-Tactile")
        _refuse_programs(path)
        with _opened(zarr, path, root) as group:
            return _Archive(group, path).read()
    except (DataError, MemoryError):
        raise
    except OSError as error:
        raise OperatingSystemError(error.strerror or str(error), path) from error
    except Exception as error:  # zarr and its codecs have no common class of errors
        raise DataError(f"the archive cannot be read: {error}", path,
                        "obtain it again") from error


def _refuse_programs(path):
    """Refuses the codec that runs programs of the archive: objects in Python's format pickle."""
    for name, text in _descriptions_in(path):
        if "pickle" in _codecs_in(json.loads(text)):
            raise DataError("objects in the format pickle could run any program", f"{path}, {name}",
                            "write them as texts of variable length")


def _descriptions_in(path):
    """Name and text of the descriptions of all arrays, also those collected in one file."""
    names = (*_DESCRIPTIONS, ".zmetadata")
    if os.path.isdir(path):
        for folder, _, files in os.walk(path):
            for name in set(files) & set(names):
                yield os.path.relpath(os.path.join(folder, name), path), \
                    Path(folder, name).read_text(encoding="utf-8")
        return
    with zipfile.ZipFile(path) as file:
        for name in file.namelist():
            if os.path.basename(name) in names:
                yield name, file.read(name).decode()


def _codecs_in(description):
    """All values of "id" and "name" in a description, which name codecs."""
    if isinstance(description, dict):
        own = {str(description[key]) for key in ("id", "name") if key in description}
        return own.union(*map(_codecs_in, description.values()))
    if isinstance(description, list):
        return set().union(*map(_codecs_in, description))
    return set()


def _root_of(path):
    """The folder with the archive in a zip file, or "" for its root and for a folder; None if there
    is no archive."""
    if os.path.isdir(path):
        is_archive = any((Path(path) / _ENDS / name).is_file() for name in _DESCRIPTIONS)
        return "" if is_archive else None
    if not zipfile.is_zipfile(path):
        return None
    with zipfile.ZipFile(path) as file:
        for name in file.namelist():
            array, described = os.path.split(name)
            if described in _DESCRIPTIONS and ("/" + array).endswith("/" + _ENDS):
                return array[:-len(_ENDS)].rstrip("/")
    return None


@contextlib.contextmanager
def _opened(zarr, path, root):
    """The root of the archive as a group of zarr."""
    if os.path.isdir(path):
        yield zarr.open_group(path, mode="r")
        return
    with zarr.storage.ZipStore(path, mode="r") as store:
        yield zarr.open_group(store, mode="r", path=root)


class _Archive:
    def __init__(self, group, path):
        self.group = group
        self.path = path
        self.left_out = {}

    def read(self):
        ends = self._ends()
        starts = [0, *ends[:-1]]
        arrays = self._arrays(ends[-1])
        times = self._in_episodes(arrays.pop(_TIMES, None), starts, ends)
        instructions = self._in_episodes(arrays.pop(_INSTRUCTION, None), starts, ends)
        episodes = range(len(ends))
        values = {name: self._in_episodes(array, starts, ends) for name, array in arrays.items()}
        arguments = channels_of(values, self.left_out, self.path,
                                [f"{self.path}, episode {episode}" for episode in episodes])
        labels = {"episode": list(episodes)}
        if instructions is not None:
            labels["task"] = [_task_of(texts) for texts in instructions]
        if times is not None:
            seconds = [np.asarray(one, np.float64).ravel() for one in times]
            arguments["times"] = dict.fromkeys(arguments["channels"], seconds)
        return {"labels": labels, **arguments}, self.left_out

    def _ends(self):
        ends = self._values_of(self.group[_ENDS], _ENDS)
        where = f"{self.path}, {_ENDS}"
        if ends.dtype.kind not in "ui" or ends.ndim != 1 or len(ends) == 0:
            raise DataError("the ends of episodes are not a list of integers", where,
                            "obtain the archive again")
        if ends[0] <= 0 or np.any(np.diff(ends.astype(np.int64)) <= 0):
            raise DataError("the ends of episodes do not grow", where, "obtain the archive again")
        return [int(end) for end in ends]

    def _arrays(self, frames):
        """The arrays of ``data`` with one row per frame, read; notes the others."""
        if "data" not in self.group:
            raise DataError("there is no group 'data'", self.path, "obtain the archive again")
        arrays = {}
        for name, array in sorted(self.group["data"].arrays()):
            if array.ndim == 0 or array.shape[0] != frames:
                self.left_out[name] = f"shape {list(array.shape)} for {frames} frames"
            elif are_pictures(array):
                self.left_out[name] = "pictures"
            else:
                arrays[name] = self._values_of(array, name)
        for name in sorted(self.group["data"].group_keys()):
            self.left_out[name] = "a group"
        return arrays

    def _values_of(self, array, name):
        try:
            return np.asarray(array[:])
        except MemoryError:
            raise
        except Exception as error:  # codecs have no common class of errors
            raise DataError(f"the array cannot be read: {error}", f"{self.path}, {name}",
                            "obtain the archive again") from error

    @staticmethod
    def _in_episodes(values, starts, ends):
        return None if values is None else [values[start:end] for start, end in zip(starts, ends)]


def _task_of(texts):
    """The instructions of an episode in the order of their first frames."""
    decoded = [text.decode() if isinstance(text, bytes) else str(text) for text in texts.ravel()]
    return "; ".join(dict.fromkeys(decoded))
