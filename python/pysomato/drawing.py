"""Pictures of maps and of skins: SVG, and axes of matplotlib."""

import difflib
import html
import os
from pathlib import Path

import numpy as np

from . import _somato
from ._browser_pictures import converted
from .errors import OperatingSystemError, UsageError

PANELS = ("u_matrix", "hits", "labels", "components")


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


class MapData:
    """What is drawn of a map: its own values, and samples where they are known.

    Args:
        map: The map of the library.
        hits: Number of samples that each neuron wins, or None.
        winners: The winner of each sample, or None.
        classes: The names of the classes and the number of each sample's class, -1 for none; or None.
    """

    def __init__(self, map, hits=None, winners=None, classes=None):  # noqa: A002
        self.map = map
        self.hits = hits
        self.winners = winners
        self.classes = classes

    def draw(self, panels, title, components, where):
        """An SVG picture with the panels of these names; None: all for which there are data."""
        picture = _somato.MapPicture(self.map)
        for panel in self._known(panels, where):
            if panel == "u_matrix":
                picture.add_u_matrix()
            elif panel == "hits":
                picture.add_hits(self.hits)
            elif panel == "labels":
                names, numbers = self.classes
                known = numbers >= 0
                picture.add_labels([str(name) for name in names], self.winners[known], numbers[known])
            else:
                picture.add_components(_count(components, where))
        return Drawing(picture.svg(title))

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
        axes = _axes_of(ax)
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

    def plot(self, panel, ax, where):
        """Draws the cells of one panel on axes of matplotlib; panel may be a column, by its name or number."""
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
        axes = _axes_of(ax)
        if panel == "labels":
            self._plot_labels(axes)
        else:
            values = (_somato.component_plane(self.map, int(panel)) if is_column
                      else self.map.u_matrix().ravel() if panel == "u_matrix" else self.hits)
            title = (self._column(panel) if is_column
                     else {"u_matrix": "U-matrix", "hits": "Hits"}[panel])
            cells = _add_cells(axes, self.map.cells(), array=np.asarray(values, float),
                               edgecolors="face")
            axes.set_title(title)
            axes.figure.colorbar(cells, ax=axes)
        return axes

    def _plot_labels(self, axes):
        names, numbers = self.classes
        corners = self.map.cells()
        _add_cells(axes, corners, facecolors="none", edgecolors="0.7")
        centres = corners.mean(axis=1)
        for number, name in enumerate(names):
            neurons, samples = np.unique(self.winners[numbers == number], return_counts=True)
            # Classes of a neuron are side by side.
            shift = 0.6 * ((number + 1) / (len(names) + 1) - 0.5)
            axes.scatter(centres[neurons, 0] + shift, centres[neurons, 1], s=12 + 8 * samples,
                         label=str(name), zorder=2)
        axes.set_title("Labels")
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=4, frameon=False)

    def _column(self, column):
        return self.map.features[column] if self.map.features else f"Component {column + 1}"

    def _known(self, panels, where):
        if panels is None:
            return [panel for panel in PANELS if self._lack(panel) is None]
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
        if panel == "labels" and (self.winners is None or self.classes is None):
            return "labelled samples", "pass them as X and y"
        return None


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


def _axes_of(ax):
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot  # only here, because the package works without it
    except ImportError as error:
        raise ImportError("plots need matplotlib: pip install 'pysomato[matplotlib]'; draw() works "
                          "without it") from error
    return matplotlib.pyplot.subplots()[1]


def _add_cells(axes, corners, **style):
    """The cells of a map as one collection of polygons, the first row at the top."""
    from matplotlib.collections import PolyCollection

    cells = axes.add_collection(PolyCollection(corners, linewidths=0.3, **style))
    axes.set_xlim(corners[..., 0].min(), corners[..., 0].max())
    axes.set_ylim(corners[..., 1].max(), corners[..., 1].min())
    axes.set_aspect("equal")
    axes.set_axis_off()
    return cells


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
