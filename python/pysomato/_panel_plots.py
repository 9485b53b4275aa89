"""Panels of maps on axes of matplotlib."""

import numpy as np

from . import _somato


class PanelPlots:
    """The panels of ``MapData`` that are more than the values of cells. Each takes the axes, the look, the clusters or
    None, and the place in messages."""

    def _plot_outlines(self, axes, clusters):
        from matplotlib.collections import LineCollection

        lines = _somato.outlines(self.map, clusters)
        for colour, width in (("white", 4), ("0.07", 1.8)):
            axes.add_collection(LineCollection(lines, colors=colour, linewidths=width, zorder=1.5))

    def _plot_labels(self, axes, *_):
        names, numbers = self.classes
        corners = self.map.cells()
        add_cells(axes, corners, facecolors="none", edgecolors="0.7")
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
        add_cells(axes, corners, facecolors="0.96", edgecolors="0.75")
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
                    distance = 0.6 * radius if end - begin < 360 else 0
                    at = centre + distance * np.array([np.cos(middle), np.sin(middle)])
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
        add_cells(axes, corners, facecolors="none", edgecolors="0.7")
        shown = list(dict.fromkeys(name for _, name in of_neuron))
        if not _fit_in_cells(axes, shown):
            # Numbers, which the legend explains.
            for number, name in enumerate(shown, 1):
                axes.plot([], [], linestyle="none", label=f"{number}  {name}")
            of_neuron = [(neuron, str(shown.index(name) + 1)) for neuron, name in of_neuron]
            _legend(axes)
        for neuron, name in of_neuron:
            axes.text(*corners[neuron].mean(axis=0), name, ha="center", va="center", fontsize="x-small",
                      parse_math=False, clip_on=True)
        axes.set_title("Label text")

    def _plot_edges(self, axes, *_):
        corners, values = _somato.edge_cells(self.map)
        cells = add_cells(axes, corners, array=values, edgecolors="face")
        centres = self.map.cells().mean(axis=1)
        axes.scatter(*centres.T, s=6, color="white", edgecolors="black", linewidths=0.4, zorder=2)
        axes.set_title("U-matrix with edges")
        axes.figure.colorbar(cells, ax=axes)

    def _plot_clusters(self, axes, look, clusters, where):
        corners = self.map.cells()
        add_cells(axes, corners, facecolors=[(*_rgb(number), 0.4) for number in clusters[0]], edgecolors="white")
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
        add_cells(axes, corners, array=self.map.u_matrix().ravel(), cmap="Greys", alpha=0.5, edgecolors="white")
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


def axes_of(ax):
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot  # only here, because the package works without it
    except ImportError as error:
        raise ImportError("plots need matplotlib: pip install 'pysomato[matplotlib]'; draw() works "
                          "without it") from error
    return matplotlib.pyplot.subplots()[1]


def add_cells(axes, corners, **style):
    """The cells of a map as one collection of polygons, the first row at the top."""
    from matplotlib.collections import PolyCollection

    cells = axes.add_collection(PolyCollection(corners, linewidths=0.3, **style))
    axes.set_xlim(corners[..., 0].min(), corners[..., 0].max())
    axes.set_ylim(corners[..., 1].max(), corners[..., 1].min())
    axes.set_aspect("equal")
    axes.set_axis_off()
    return cells


def _fit_in_cells(axes, names):
    """Whether names can be written side by side into cells, whose width is the unit of the axes."""
    extent = axes.get_window_extent()
    pixels = min(extent.width / abs(np.diff(axes.get_xlim())[0]), extent.height / abs(np.diff(axes.get_ylim())[0]))
    points = pixels * 72 / axes.figure.dpi
    return max(map(len, names), default=0) * 0.55 * 0.7 * _font_size() <= points


def _font_size():
    from matplotlib import rcParams

    return rcParams["font.size"]


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
