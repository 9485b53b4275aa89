"""Pictures of maps and of skins: SVG, and axes of matplotlib."""

import difflib
import html
import os
from pathlib import Path

import numpy as np

from . import _somato
from ._browser_pictures import converted
from ._panel_plots import PanelPlots, add_cells, axes_of
from .errors import OperatingSystemError, UsageError

# In the order of the program; the usual ones are drawn where no panels are named.
PANELS = ("u_matrix", "u_matrix_edges", "hits", "labels", "label_text", "pies", "components", "clusters",
          "dendrogram", "projection", "trajectory")
_USUAL = ("u_matrix", "hits", "labels", "components")
_OF_CLUSTERS = ("clusters", "dendrogram")


class Drawing:
    """An SVG picture, which a notebook shows.

    Attributes:
        svg: The picture: the same bytes for the same content on every machine.
    """

    def __init__(self, svg):
        self.svg = svg

    def save(self, path) -> None:
        """Writes the picture to a file: SVG, or with the extension .pdf or .png in this format.

        PDF and PNG, which has two pixels for each unit of the SVG, are drawn by the browser Chromium.

        Raises:
            UsageError: The name of the file has the extension of another format.
            OperatingSystemError: The file cannot be written, or there is no Chromium for PDF or PNG.
        """
        ending = Path(os.fspath(path)).suffix.lower()
        if ending in (".pdf", ".png"):
            _write(path, converted(self.svg, ending))
        else:
            write_text(path, self.svg, ".svg", ".pdf", ".png")

    def _repr_svg_(self):
        return self.svg

    def __repr__(self):
        return f"<Drawing of {len(self.svg)} bytes of SVG>"


class Page:
    """A page of HTML with all that it needs, which a notebook shows in a frame.

    Attributes:
        html: The page.
        height: The height of the frame in a notebook, in pixels.
    """

    def __init__(self, page, height=720):
        self.html = page
        self.height = height

    def save(self, path) -> None:
        """Writes the page to a file, which a browser opens.

        Raises:
            UsageError: The name of the file has the extension of another format.
            OperatingSystemError: The file cannot be written.
        """
        write_text(path, self.html, ".html")

    def _repr_html_(self):
        return (f'<iframe srcdoc="{html.escape(self.html)}" width="100%" height="{self.height}" '
                'style="border: 0"></iframe>')

    def __repr__(self):
        return f"<Page of {len(self.html)} bytes of HTML>"


class MapData(PanelPlots):
    """What is drawn of a map: its own values, and samples where they are known.

    Args:
        map: The map of the library.
        hits: Number of samples that each neuron wins, or None.
        winners: The winner of each sample, or None.
        classes: The names of the classes and the number of each sample's class, -1 for none; or None.
        rows: The samples as the map takes them, or None.
    """

    def __init__(self, map, hits=None, winners=None, classes=None, rows=None):  # noqa: A002
        self.map = map
        self.hits = hits
        self.winners = winners
        self.classes = classes
        self.rows = rows

    def draw(self, panels, title, look, where):
        """An SVG picture with the panels of these names; None: the usual ones for which there are data."""
        picture = _somato.MapPicture(self.map)
        names = self._known(panels, where)
        clusters = self._clusters(look, names, where)
        for panel in names:
            self._add(picture, panel, look, clusters, where)
        if clusters is not None:
            picture.outline(clusters[0])
        return Drawing(picture.svg(title))

    def _add(self, picture, panel, look, clusters, where):
        if panel == "u_matrix":
            picture.add_u_matrix()
        elif panel == "u_matrix_edges":
            picture.add_u_matrix_edges()
        elif panel == "hits":
            picture.add_hits(self.hits)
        elif panel == "label_text" and not self._has_labels():
            picture.add_label_text()
        elif panel in ("labels", "pies", "label_text"):
            names, winners, numbers = self._labelled()
            picture.add_labels(names, winners, numbers, panel, bool(look.size_by_hits))
        elif panel == "components":
            picture.add_components(_count(look.components, where), str(look.component_order),
                                   str(look.component_scale))
        elif panel == "clusters":
            picture.add_clusters(clusters[0])
        elif panel == "dendrogram":
            picture.add_dendrogram(clusters[0], _merges(clusters, where))
        elif panel == "projection":
            picture.add_projection(*self._projected())
        else:
            picture.add_trajectory(*self._steps(look, where))

    def _has_labels(self):
        return self.winners is not None and self.classes is not None

    def _labelled(self):
        """The names of the classes, and the winners and classes of the samples that have one."""
        names, numbers = self.classes
        known = numbers >= 0
        return [str(name) for name in names], self.winners[known], numbers[known]

    def _projected(self):
        """The positions of the samples, the names of the classes and the class of each; all classes or none."""
        positions = np.zeros((0, 2)) if self.rows is None else self.map.plane_positions(self.rows)
        names, numbers = ([], np.zeros(0, np.int64))
        if self._has_labels() and self.rows is not None:
            known = self.classes[1] >= 0  # samples without a label are not drawn
            names, numbers = [str(name) for name in self.classes[0]], self.classes[1][known]
            positions = np.ascontiguousarray(positions[known])
        return positions, names, numbers

    def _steps(self, look, where):
        """The winners of a trajectory, and the number of the first sample, from 1."""
        chosen = _rows_of(look.trajectory, len(self.winners), where)
        if len(chosen) > _somato.most_trajectory_samples:
            raise UsageError(f"a trajectory of {len(chosen)} samples cannot be followed", where,
                             f"choose up to {_somato.most_trajectory_samples}, such as trajectory=range(24)")
        return np.ascontiguousarray(self.winners[chosen.start:chosen.stop]), chosen.start + 1

    def _clusters(self, look, panels, where):
        """The cluster of each neuron and the linkage matrix or None; None without clusters."""
        clusters = look.clusters
        if clusters is None and any(panel in _OF_CLUSTERS for panel in panels):
            clusters = "ward"
        if clusters is None:
            return None
        if isinstance(clusters, str):
            return _somato.named_clusters(self.map, clusters)
        numbers = np.asarray(clusters)
        neurons = len(self.map.weights())
        if numbers.shape != (neurons,) or numbers.dtype.kind not in "iu" or numbers.min() < 0:
            raise UsageError("these are no clusters of the neurons", where,
                             f"pass a whole number from 0 for each of the {neurons} neurons, or the name of a method")
        return np.ascontiguousarray(numbers, np.int64), None

    def draw_skin(self, layout, neuron, title, where):
        """An SVG picture of the weights of one neuron, or of each, on the skin of a layout file."""
        if neuron is not None:
            neuron = self._neuron(neuron, where)
        return Drawing(_somato.weights_on_skin(self.map, os.fspath(layout), neuron, title))

    def plot_skin(self, layout, neuron, ax, where):
        """Draws the weights of one neuron, or the means of all, on axes of matplotlib."""
        inputs, x, y = _somato.places_of_inputs(self.map, os.fspath(layout))
        weights = self.map.weights()
        values = weights.mean(axis=0) if neuron is None else weights[self._neuron(neuron, where)]
        axes = axes_of(ax)
        points = axes.scatter(x, y, c=values[inputs], s=120)
        if not axes.yaxis_inverted():
            axes.invert_yaxis()
        axes.set(title="Mean weights" if neuron is None else f"Weights of neuron {neuron}",
                 xlabel="mm", ylabel="mm", aspect="equal")
        axes.figure.colorbar(points, ax=axes)
        return axes

    def _neuron(self, neuron, where):
        neurons = len(self.map.weights())
        if isinstance(neuron, (int, np.integer)) and 0 <= neuron < neurons:
            return int(neuron)
        raise UsageError(f"{neuron!r} is not the number of a neuron", where,
                         f"neurons are counted from 0 in rows, as in winners_; the map has {neurons}")

    def plot(self, panel, ax, look, where):
        """Draws one panel on axes of matplotlib; panel may be a column, by its name or number."""
        if isinstance(panel, str) and panel not in PANELS and panel in self.map.features:
            panel = self.map.features.index(panel)
        is_column = not isinstance(panel, str)
        if is_column:
            _check_column(panel, self.map, where)
        elif panel == "components":
            raise UsageError("axes show one component plane", where,
                             "give the name or number of its column")
        else:
            self._check(panel, where)
        clusters = self._clusters(look, [panel], where)
        plots = {"labels": self._plot_labels, "label_text": self._plot_text, "pies": self._plot_pies,
                 "u_matrix_edges": self._plot_edges, "clusters": self._plot_clusters,
                 "dendrogram": self._plot_dendrogram, "projection": self._plot_projection,
                 "trajectory": self._plot_trajectory}
        # What cannot be drawn is refused before there are new axes.
        if panel == "trajectory":
            self._steps(look, where)
        if panel == "dendrogram":
            _merges(clusters, where)
        axes = axes_of(ax)
        if not is_column and panel in plots:
            plots[panel](axes, look, clusters, where)
        else:
            values = (_somato.component_plane(self.map, int(panel)) if is_column
                      else self.map.u_matrix().ravel() if panel == "u_matrix" else self.hits)
            title = (self._column(panel) if is_column
                     else {"u_matrix": "U-matrix", "hits": "Hits"}[panel])
            cells = add_cells(axes, self.map.cells(), array=np.asarray(values, float),
                               edgecolors="face")
            axes.set_title(title)
            axes.figure.colorbar(cells, ax=axes)
        if clusters is not None and panel not in ("dendrogram", "projection"):
            self._plot_outlines(axes, clusters[0])
        return axes

    def _column(self, column):
        return self.map.features[column] if self.map.features else f"Component {column + 1}"

    def _known(self, panels, where):
        if panels is None:
            return [panel for panel in _USUAL if self._lack(panel) is None]
        named = [panels] if isinstance(panels, str) else list(panels)
        if not named:
            raise UsageError("a picture needs a panel", where, f"panels are: {', '.join(PANELS)}")
        for panel in named:
            self._check(panel, where)
        return named

    def _check(self, panel, where):
        if panel not in PANELS:
            columns = self.map.features if where.endswith(".plot") else []
            near = difflib.get_close_matches(str(panel), [*PANELS, *columns], n=1)
            advice = f"panels are: {', '.join(PANELS)}" + (", and the names of columns" if columns else "")
            raise UsageError(f"there is no panel '{panel}'", where,
                             f"did you mean '{near[0]}'? {advice}" if near else advice)
        lack = self._lack(panel)
        if lack is not None:
            raise UsageError(f"the panel '{panel}' needs {lack[0]}", where, lack[1])

    def _lack(self, panel):
        """What a panel lacks and how it is given, or None."""
        if panel == "hits" and self.hits is None:
            return "samples", "pass them as X"
        if panel == "trajectory" and (self.winners is None or not len(self.winners)):
            return "samples", "pass them as X"
        if panel in ("labels", "pies") and not self._has_labels():
            return "labelled samples", "pass them as X and y"
        if panel == "label_text" and not self._has_labels() and not self.map.class_names:
            return "labelled samples", "pass them as X and y"
        return None


class Look:
    """How panels are drawn; the arguments of ``SOM.draw`` with these names."""

    def __init__(self, *, components=12, component_order="columns", component_scale="own", size_by_hits=False,
                 clusters=None, trajectory=None):
        self.components = components
        self.component_order = component_order
        self.component_scale = component_scale
        self.size_by_hits = size_by_hits
        self.clusters = clusters
        self.trajectory = trajectory


def _rows_of(chosen, count, where):
    """A range of rows: all, or those of a slice or range without steps."""
    if chosen is None:
        return range(count)
    if isinstance(chosen, slice):
        chosen = range(count)[chosen]
    if isinstance(chosen, range) and chosen.step == 1 and 0 <= chosen.start < chosen.stop <= count:
        return chosen
    raise UsageError(f"{chosen!r} are no consecutive rows", where,
                     f"use a range such as range(12, 24); there are {count} rows, counted from 0")


def _merges(clusters, where):
    if clusters[1] is None or len(clusters[1]) + 1 != len(clusters[0]):
        raise UsageError("a dendrogram needs hierarchical clusters", where, "use clusters='ward'")
    return clusters[1]


def skin(title, description, frames, limits, where, layout=None):
    """An SVG picture of frames of a channel.

    Args:
        title: Above the picture.
        description: Name, unit, element names and shape of the channel.
        frames: Tuples (title, values, valid or None).
        limits: The values with the first and the last colour.
        where: The place in messages.
        layout: A layout file, or None.
    """
    least, greatest = (float(limit) for limit in limits)
    if not (np.isfinite(least) and np.isfinite(greatest) and least <= greatest):
        raise UsageError(f"({least}, {greatest}) are no limits of colours", where,
                         "give two finite numbers, the lesser one first")
    picture = _somato.Skin(title, description["element_names"], description["shape"],
                           description["unit"], least, greatest)
    if layout is not None:
        picture.place(os.fspath(layout), description["name"])
    for name, values, valid in frames:
        marks = np.ones(0, np.uint8) if valid is None else np.ascontiguousarray(valid).ravel()
        picture.add_frame(name, np.ascontiguousarray(values).ravel(), marks)
    return Drawing(picture.svg())


def _check_column(column, map, where):  # noqa: A002
    if isinstance(column, (int, np.integer)) and 0 <= column < map.input_size:
        return
    raise UsageError(f"{column!r} is not the number of a column", where,
                     f"columns are counted from 0; the map has {map.input_size}")


def _count(number, where):
    if isinstance(number, (int, np.integer)) and number >= 1:
        return int(number)
    raise UsageError(f"{number!r} is not a number of component planes", where, "use at least 1")


def write_text(path, text, ending, *others):
    """Writes a text to a file with an extension, or with none; ``others`` are mentioned in the error."""
    path = Path(os.fspath(path))
    if path.suffix.lower() not in (ending, ""):
        raise UsageError(f"the content is {ending[1:].upper()}, not {path.suffix[1:]}", str(path),
                         f"use the extension {' or '.join([ending, *others])}")
    _write(path, text.encode())


def _write(path, content):
    try:
        Path(os.fspath(path)).write_bytes(content)
    except OSError as error:
        raise OperatingSystemError(error.strerror or str(error), str(path)) from error
