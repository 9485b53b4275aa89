"""LeRobotDataset v3: meta/info.json, meta/episodes and data in Parquet, several episodes per file.

Source of the layout: https://huggingface.co/docs/lerobot/lerobot-dataset-v3
"""

import json
import os
from pathlib import Path

import numpy as np

from .channels import channels_of, imported
from ..errors import DataError, OperatingSystemError

# The columns that number frames and episodes, and the times.
_COUNTERS = ("timestamp", "frame_index", "episode_index", "index", "task_index")

# Seconds by which LeRobot itself lets time stamps differ from the frame rate.
_TOLERANCE = 1e-4


def recognizes(path):
    return os.path.isdir(path) and os.path.isfile(os.path.join(path, "meta", "info.json"))


def read(path):
    """The arguments of Recording.from_arrays, and what is left out: the reason by the name."""
    return _Dataset(Path(path)).read()


class _Dataset:
    def __init__(self, folder):
        self.folder = folder
        self.parquet = imported("pyarrow.parquet", "lerobot")
        self.info_path = folder / "meta" / "info.json"
        self.info = self._read_info()
        self.latest = None  # the latest data file: path, table
        self.left_out = {}

    def read(self):
        features = self._features()
        episodes = self._episodes()
        values = {name: [] for name in features}
        times, sources = [], []
        for episode in episodes:
            path, rows = self._rows_of(episode, features)
            sources.append(f"{path}, episode {episode['episode_index']}")
            times.append(_values_of(rows, "timestamp", (1,), path).ravel().astype(np.float64))
            for name, (shape, _) in features.items():
                values[name].append(_values_of(rows, name, shape, path))
        arguments = channels_of(values, self.left_out, str(self.folder), sources)
        names = arguments["channels"]
        return {"labels": {"episode": [episode["episode_index"] for episode in episodes],
                           "task": [_task_of(episode) for episode in episodes]},
                "element_names": {name: features[name][1] for name in names},
                **self._rate_or_times(times, names), **arguments}, self.left_out

    def _read_info(self):
        where = str(self.info_path)
        try:
            info = json.loads(self.info_path.read_text(encoding="utf-8"))
        except OSError as error:
            raise OperatingSystemError(error.strerror or str(error), where) from error
        except ValueError as error:
            raise DataError(f"not JSON: {error}", where, "obtain the file again") from error
        if not isinstance(info, dict) or not isinstance(info.get("features"), dict):
            raise DataError("there are no features", where, "use a LeRobotDataset")
        version = str(info.get("codebase_version"))
        if not version.startswith("v3."):
            raise DataError(f"the version of the data set is {version}, not v3", where,
                            "convert it with convert_dataset_v21_to_v30 of LeRobot")
        rate = info.get("fps")
        if not isinstance(rate, (int, float)) or not 0 < rate < float("inf"):
            raise DataError(f"fps is {rate!r}, not a number of frames per second", where, "correct it")
        return info

    def _features(self):
        """Shape and element names of the features with numbers; notes the others."""
        features = {}
        for name, feature in self.info["features"].items():
            kind, shape = feature.get("dtype"), feature.get("shape")
            if kind in ("image", "video"):
                self.left_out[name] = "pictures"
            elif kind == "string":
                self.left_out[name] = "no numbers"
            elif name not in _COUNTERS:
                if not _is_shape(shape):
                    raise DataError(f"the shape of '{name}' is {shape!r}", str(self.info_path),
                                    "correct it")
                names = _element_names(feature.get("names"), shape)
                if names is None:
                    raise DataError(f"the places of the names of '{name}' are not those from 0 on",
                                    str(self.info_path), "correct them")
                features[name] = (tuple(shape), names)
        return features

    def _episodes(self):
        """The rows of meta/episodes in the order of their numbers."""
        folder = self.folder / "meta" / "episodes"
        needed = ["episode_index", "length", "data/chunk_index", "data/file_index"]
        episodes = []
        for path in sorted(folder.glob("*/*.parquet")):
            table = self._read_table(path, needed, ["tasks"])
            episodes += table.to_pylist()
        if not episodes:
            raise DataError("there are no episodes", str(folder), "obtain the whole data set")
        episodes.sort(key=lambda episode: episode["episode_index"])
        numbers = [episode["episode_index"] for episode in episodes]
        if len(set(numbers)) != len(numbers):
            raise DataError("an episode is listed twice", str(folder), "obtain the data set again")
        return episodes

    def _rows_of(self, episode, features):
        """The file of an episode, and its rows.

        Raises:
            DataError: Also of an episode without frames, for which there may be no file.
        """
        chunk, file = episode["data/chunk_index"], episode["data/file_index"]
        path = self.folder / "data" / f"chunk-{chunk:03d}" / f"file-{file:03d}.parquet"
        where = f"{path}, episode {episode['episode_index']}"
        if episode["length"] == 0:
            raise DataError("the episode is empty: its length in meta/episodes is 0", where,
                            "delete it with lerobot-edit-dataset --operation.type delete_episodes "
                            f"--operation.episode_indices '[{episode['episode_index']}]'")
        if self.latest is None or self.latest[0] != path:
            columns = ["episode_index", "frame_index", "timestamp", *features]
            self.latest = (path, self._read_table(path, columns))
        table = self.latest[1]
        rows = table.filter(table["episode_index"].to_numpy() == episode["episode_index"])
        if rows.num_rows != episode["length"]:
            raise DataError(f"there are {rows.num_rows} frames, but {episode['length']} are listed",
                            where, "obtain the data set again")
        if not np.array_equal(rows["frame_index"].to_numpy(), np.arange(rows.num_rows)):
            raise DataError("frame_index does not count from 0", where, "obtain the data set again")
        return path, rows

    def _read_table(self, path, columns, optional=()):
        """These columns of a Parquet file."""
        if not path.is_file():
            raise DataError("the file is missing", str(path), "obtain the whole data set")
        try:
            file = self.parquet.ParquetFile(path)
            known = file.schema_arrow.names
            missing = next((name for name in columns if name not in known), None)
            if missing is None:
                return file.read([*columns, *(name for name in optional if name in known)])
        except OSError as error:  # also of a damaged file
            raise DataError(f"the file cannot be read: {error}", str(path),
                            "obtain the file again") from error
        except ValueError as error:
            raise DataError(f"not Parquet: {error}", str(path), "obtain the file again") from error
        raise DataError(f"there is no column '{missing}'", str(path), "obtain the file again")

    def _rate_or_times(self, times, channels):
        """The rate, if all frames are at multiples of its inverse, or else their times."""
        rate = float(self.info["fps"])
        if all(np.abs(seconds - np.arange(len(seconds)) / rate).max() <= _TOLERANCE
               for seconds in times):
            return {"rates": dict.fromkeys(channels, rate)}
        return {"times": dict.fromkeys(channels, times)}


def _task_of(episode):
    """The tasks of an episode; an episode may have several."""
    return "; ".join(episode.get("tasks") or [])


def _is_shape(shape):
    return (isinstance(shape, list) and bool(shape)
            and all(isinstance(length, int) and length > 0 for length in shape))


def _element_names(names, shape):
    """The names of the elements; an empty list if there are none, or names of axes; None if they
    have wrong places.

    They are a list, a list in a dictionary (``{"motors": [...]}``) or a dictionary of places.
    """
    if isinstance(names, dict):
        values = list(names.values())
        if len(values) == 1 and isinstance(values[0], list):
            names = values[0]
        elif values and all(type(place) is int for place in values):
            if sorted(values) != list(range(int(np.prod(shape)))):
                return None
            names = sorted(names, key=names.get)
        else:
            return []
    if not isinstance(names, list) or len(names) != int(np.prod(shape)):
        return []
    return [str(name) for name in names]


def _values_of(table, name, shape, path):
    """The values of a column as an array of (rows,) and the shape of a frame.

    Raises:
        DataError: The values have another shape.
    """
    column = table[name].combine_chunks()
    rows = len(column)
    # A feature of one element may be stored as a number.
    lengths = shape if _is_list(column) or shape != (1,) else ()
    fits = True
    for length in lengths:
        fits = _is_list(column) and column.null_count == 0 and np.all(_lengths_of(column) == length)
        if not fits:
            break
        column = column.flatten()
    if not fits or _is_list(column):
        raise DataError(f"the values of '{name}' are not of the shape {list(shape)}", str(path),
                        "compare the file with meta/info.json")
    return np.asarray(column.to_numpy(zero_copy_only=False)).reshape(rows, *shape)


def _is_list(column):
    return hasattr(column, "value_lengths")


def _lengths_of(column):
    return column.value_lengths().to_numpy(zero_copy_only=False)
