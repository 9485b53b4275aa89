"""Pictures of maps and of skins: SVG, and axes of matplotlib."""

import difflib
import html
import os
from pathlib import Path

import numpy as np

from . import _somato
from ._browser_pictures import converted
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


class MapData:
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
        if self._has_labels() and self.rows is not None and (self.classes[1] >= 0).all():
            names, numbers = [str(name) for name in self.classes[0]], self.classes[1]
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
            return _somato.clusters(self.map, clusters)
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
        axes = _axes_of(ax)
        if not is_column and panel in plots:
            plots[panel](axes, look, clusters, where)
        else:
            values = (_somato.component_plane(self.map, int(panel)) if is_column
                      else self.map.u_matrix().ravel() if panel == "u_matrix" else self.hits)
            title = (self._column(panel) if is_column
                     else {"u_matrix": "U-matrix", "hits": "Hits"}[panel])
            cells = _add_cells(axes, self.map.cells(), array=np.asarray(values, float),
                               edgecolors="face")
            axes.set_title(title)
            axes.figure.colorbar(cells, ax=axes)
        if clusters is not None and panel not in ("dendrogram", "projection"):
            self._plot_outlines(axes, clusters[0])
        return axes

    def _plot_outlines(self, axes, clusters):
        from matplotlib.collections import LineCollection

        lines = _somato.outlines(self.map, clusters)
        for colour, width in (("white", 4), ("0.07", 1.8)):
            axes.add_collection(LineCollection(lines, colors=colour, linewidths=width, zorder=1.5))

    def _plot_labels(self, axes, *_):
        names, numbers = self.classes
        corners = self.map.cells()
        _add_cells(axes, corners, facecolors="none", edgecolors="0.7")
        centres = corners.mean(axis=1)
        for number, name in enumerate(names):
            neurons, samples = np.unique(self.winners[numbers == number], return_counts=True)
            # Classes of a neuron are side by side.
            shift = 0.6 * ((number + 1) / (len(names) + 1) - 0.5)
            axes.scatter(centres[neurons, 0] + shift, centres[neurons, 1], s=12 + 8 * samples,
                         label=str(name), zorder=2, **_mark(number))
        axes.set_title("Labels")
        _legend(axes)

    def _plot_pies(self, axes, look, *_):
        from matplotlib.patches import Wedge

        corners = self.map.cells()
        _add_cells(axes, corners, facecolors="0.96", edgecolors="0.75")
        names, winners, numbers = self._labelled()
        counts = np.zeros((len(corners), len(names)), int)
        np.add.at(counts, (winners, numbers), 1)
        samples = counts.sum(axis=1)
        for neuron, centre in enumerate(corners.mean(axis=1)):
            # Clockwise from the top; y increases downwards.
            ends = np.concatenate([[0], np.cumsum(counts[neuron])]) / max(samples[neuron], 1) * 360 - 90
            radius = 0.45 * (np.sqrt(samples[neuron] / samples.max()) if look.size_by_hits else 1)
            for number in np.flatnonzero(counts[neuron]):
                begin, end = ends[number], ends[number + 1]
                axes.add_patch(Wedge(centre, radius, begin, end, facecolor=_mark(number)["color"],
                                     edgecolor="0.13", linewidth=0.5, zorder=2))
                if end - begin >= 60:
                    middle = np.radians((begin + end) / 2)
                    at = centre + (0.6 * radius if end - begin < 360 else 0) * np.array([np.cos(middle), np.sin(middle)])
                    axes.plot(*at, marker=_mark(number)["marker"], color="white", markeredgecolor="0.13",
                              markersize=4, markeredgewidth=0.6, linestyle="none", zorder=3)
        for number, name in enumerate(names):
            axes.scatter([], [], label=name, **_mark(number))
        axes.set_title("Classes")
        _legend(axes)

    def _plot_text(self, axes, *_):
        corners = self.map.cells()
        if self._has_labels():
            names, winners, numbers = self._labelled()
            counts = np.zeros((len(corners), len(names)), int)
            np.add.at(counts, (winners, numbers), 1)
            of_neuron = [(neuron, names[counts[neuron].argmax()]) for neuron in np.flatnonzero(counts.sum(axis=1))]
        else:
            of_neuron = [(neuron, name) for neuron, name in enumerate(self.map.neuron_labels) if name is not None]
        _add_cells(axes, corners, facecolors="none", edgecolors="0.7")
        for neuron, name in of_neuron:
            axes.text(*corners[neuron].mean(axis=0), name, ha="center", va="center", fontsize="x-small",
                      parse_math=False, clip_on=True)
        axes.set_title("Label text")

    def _plot_edges(self, axes, *_):
        corners, values = _somato.edge_cells(self.map)
        cells = _add_cells(axes, corners, array=values, edgecolors="face")
        centres = self.map.cells().mean(axis=1)
        axes.scatter(*centres.T, s=6, color="white", edgecolors="black", linewidths=0.4, zorder=2)
        axes.set_title("U-matrix with edges")
        axes.figure.colorbar(cells, ax=axes)

    def _plot_clusters(self, axes, look, clusters, where):
        corners = self.map.cells()
        _add_cells(axes, corners, facecolors=[(*_rgb(number), 0.4) for number in clusters[0]], edgecolors="white")
        for number, centre in zip(clusters[0], corners.mean(axis=1), strict=True):
            axes.text(*centre, str(number + 1), ha="center", va="center", fontsize="x-small")
        axes.set_title("Clusters")

    def _plot_dendrogram(self, axes, look, clusters, where):
        from matplotlib.collections import LineCollection

        of_neuron, merges = clusters
        neurons = len(of_neuron)
        x, lines, within = _tree(of_neuron, merges)
        axes.add_collection(LineCollection(lines, colors=["0.07" if same else "0.5" for same in within], linewidths=1))
        for number in range(of_neuron.max() + 1):
            axes.text(np.mean([x[neuron] for neuron in np.flatnonzero(of_neuron == number)]), 0, str(number + 1),
                      ha="center", va="top")
        axes.set_xlim(-0.5, neurons - 0.5)
        axes.set_ylim(0, max(merges[:, 2].max(initial=0) * 1.05, 1e-12))
        axes.set_xticks([])
        axes.set(title="Dendrogram", ylabel="distance")
        axes.set_xlabel("clusters", labelpad=14)

    def _plot_projection(self, axes, look, clusters, where):
        from matplotlib.collections import LineCollection

        neurons, shares, pairs = _somato.projection(self.map)
        same = np.ones(len(pairs), bool) if clusters is None else clusters[0][pairs[:, 0]] == clusters[0][pairs[:, 1]]
        for chosen, style in ((same, "solid"), (~same, "dashed")):
            axes.add_collection(LineCollection(neurons[pairs[chosen]], colors="0.3", linewidths=0.8, linestyles=style))
        positions, names, numbers = self._projected()
        if names:
            for number, name in enumerate(names):
                axes.scatter(*positions[numbers == number].T, s=10, label=name, zorder=1.5, **_mark(number))
        elif len(positions):
            axes.scatter(*positions.T, s=10, color="0.6", zorder=1.5)
        axes.scatter(*neurons.T, s=16, color="white", edgecolors="0.07", zorder=2)
        if clusters is not None:
            for at, number in zip(neurons, clusters[0], strict=True):
                axes.annotate(str(number + 1), at, fontsize="xx-small", ha="center", va="center", zorder=3)
        axes.set(title="Projection", aspect="equal", xlabel=f"first component ({shares[0]:.0%} of the variance)",
                 ylabel=f"second component ({shares[1]:.0%})")
        axes.autoscale_view()
        if names:
            axes.legend(frameon=False)

    def _plot_trajectory(self, axes, look, clusters, where):
        winners, first = self._steps(look, where)
        corners = self.map.cells()
        centres = corners.mean(axis=1)
        _add_cells(axes, corners, array=self.map.u_matrix().ravel(), cmap="Greys", alpha=0.5, edgecolors="white")
        starts = np.flatnonzero(np.concatenate([[True], winners[1:] != winners[:-1]]))
        # Visits of a neuron are around its middle, so that their numbers can be read.
        visited = {}
        places = []
        for start in starts:
            angle = 2.4 * visited.setdefault(winners[start], 0)
            radius = 0.25 if visited[winners[start]] else 0.0
            visited[winners[start]] += 1
            places.append(centres[winners[start]] + radius * np.array([np.cos(angle), np.sin(angle)]))
        for begin, end in zip(places[:-1], places[1:], strict=True):
            axes.annotate("", end, begin, arrowprops={"arrowstyle": "-|>", "color": "0.07", "shrinkA": 5, "shrinkB": 5})
        for i, (start, place) in enumerate(zip(starts, places, strict=True)):
            is_last = i + 1 == len(starts)
            dark = i == 0 or is_last
            number = first + (len(winners) - 1 if is_last else start)
            axes.text(*place, str(number), ha="center", va="center", fontsize="xx-small",
                      color="white" if dark else "0.07",
                      bbox={"boxstyle": "square,pad=0.2" if is_last else "circle,pad=0.15",
                            "facecolor": "0.07" if dark else "white", "edgecolor": "0.07"})
        axes.set_title(f"Trajectory, samples {first} to {first + len(winners) - 1}")

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


# The marks of classes in src/maps/svg/colours.cc: the colours of Okabe and Ito, and shapes.
_COLOURS = ("#0072b2", "#e69f00", "#009e73", "#d55e00", "#56b4e9", "#cc79a7", "#f0e442", "#000000")
_SHAPES = ("o", "s", "^", "D", "v", "P", "X", "*")


def _mark(number):
    return {"color": _COLOURS[number % 8], "marker": _SHAPES[(number + number // 8) % 8]}


def _rgb(number):
    return tuple(int(_COLOURS[number % 8][i:i + 2], 16) / 255 for i in (1, 3, 5))


def _tree(of_neuron, merges):
    """The place of each neuron from left to right, the lines of all merges, and whether each joins one cluster."""
    neurons = len(of_neuron)
    leaves, open_nodes = [], [2 * neurons - 2]
    while open_nodes:
        node = open_nodes.pop()
        if node < neurons:
            leaves.append(node)
        else:
            open_nodes += [int(merges[node - neurons, 1]), int(merges[node - neurons, 0])]
    x = {neuron: place for place, neuron in enumerate(leaves)}
    nodes = [(x[neuron], 0.0) for neuron in range(neurons)]
    cluster = list(of_neuron)
    lines, within = [], []
    for first, second, height, _ in merges:
        first, second = int(first), int(second)
        lines.append([nodes[first], (nodes[first][0], height), (nodes[second][0], height), nodes[second]])
        nodes.append(((nodes[first][0] + nodes[second][0]) / 2, height))
        same = cluster[first] is not None and cluster[first] == cluster[second]
        cluster.append(cluster[first] if same else None)
        within.append(same)
    return x, lines, within


def _legend(axes):
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=4, frameon=False)


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
