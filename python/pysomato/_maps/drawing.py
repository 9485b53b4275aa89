"""Pictures of a map."""

from .._inputs.rows import check_fitted
from ..drawing import Drawing, Look, MapData
from ..errors import UsageError


class MapDrawing:
    """The pictures of ``SOM``, whose methods these are."""

    def draw(self, panels=None, X=None, y=None, *, title="SOM", components=12, component_order="columns",
             component_scale="own", size_by_hits=False, clusters=None, trajectory=None,
             layout=None, neuron=None) -> Drawing:
        """The pictures that ``somato som plot`` draws, as SVG, which a notebook shows.

        Args:
            panels: A name or a list of names: ``u_matrix`` (mean distances of neighbours),
                ``u_matrix_edges`` (also the distance of each two neighbours), ``hits`` (samples that
                each neuron wins), ``labels`` (the winners of labelled samples), ``label_text`` (the
                name of most samples of each neuron), ``pies`` (the share of each class),
                ``components`` (the weights of each column), ``clusters`` (of the neurons),
                ``dendrogram`` (their merges), ``projection`` (the grid, and the samples X, in the
                plane of the first two principal components of the weights) and ``trajectory`` (the
                winners of consecutive samples). None: ``u_matrix``, ``hits``, ``labels`` and
                ``components`` if there are data for them.
            X: Samples for panels that need them, such as the frames of an exploration for
                ``trajectory``; None: those of ``fit``.
            y: Their labels.
            title: The title of the picture.
            components: Maximum number of component planes.
            component_order: ``"columns"``, or ``"likeness"``: correlated planes follow each other.
            component_scale: ``"own"``: colours have the range of each plane; ``"common"``: that of all.
            size_by_hits: Whether the area of a pie is proportional to its samples.
            clusters: Clusters that are outlined in all panels: ``"ward"``, ``"k_means"`` or
                ``"watershed"``, with a number as in ``"ward:4"`` or one that is chosen; or an array
                with the number of each neuron's cluster, from 0. None: none, and ``"ward"`` for the
                panels ``clusters`` and ``dendrogram``.
            trajectory: The rows that ``trajectory`` connects, as a range or slice of at most 1000
                rows; None: all. The numbers in the picture begin at 1, as those of the program.
            layout: The path of a layout file: the weights of each neuron are drawn on this skin
                instead of panels.
            neuron: With a layout, the number of the only neuron to draw, as in ``winners_``.

        Raises:
            UsageError: A panel is unknown, or its data are missing; the layout does not fit the
                columns.
        """
        if _on_skin(layout, neuron, (panels, X, y), "SOM.draw"):
            return self._data(None, None).draw_skin(layout, neuron, title, "SOM.draw")
        look = Look(components=components, component_order=component_order, component_scale=component_scale,
                    size_by_hits=size_by_hits, clusters=clusters, trajectory=trajectory)
        return self._data(X, y).draw(panels, title, look, "SOM.draw")

    def plot(self, panel=None, X=None, y=None, *, ax=None, size_by_hits=False, clusters=None,
             trajectory=None, layout=None, neuron=None):
        """Draws one panel on axes of matplotlib (``pip install 'pysomato[matplotlib]'``).

        Args:
            panel: As for ``draw``; instead of ``components`` a column: its name, or its number from 0.
                None: ``u_matrix``.
            X: As for ``draw``.
            y: As for ``draw``.
            ax: The axes; None: those of a new figure.
            size_by_hits: As for ``draw``.
            clusters: As for ``draw``.
            trajectory: As for ``draw``.
            layout: The path of a layout file: weights are drawn on this skin instead of a panel.
            neuron: With a layout, the number of the neuron, as in ``winners_``; None: the means of
                all neurons.

        Returns:
            The axes. A unit is the width of a cell, and the first row is at the top; with a layout
            it is 1 mm, and for ``projection`` that of the weights.

        Raises:
            ImportError: matplotlib is not installed.
            UsageError: The panel is unknown, or its data are missing.
        """
        if _on_skin(layout, neuron, (panel, X, y), "SOM.plot"):
            return self._data(None, None).plot_skin(layout, neuron, ax, "SOM.plot")
        look = Look(size_by_hits=size_by_hits, clusters=clusters, trajectory=trajectory)
        return self._data(X, y).plot("u_matrix" if panel is None else panel, ax, look, "SOM.plot")

    def _repr_svg_(self):
        if not hasattr(self, "map_"):
            return None
        panels = ["u_matrix", "hits"] if hasattr(self, "hits_") else "u_matrix"
        return self.draw(panels).svg

    @property
    def _repr_html_(self):
        # A notebook prefers HTML, which describes the parameters, to the picture of a trained map.
        if hasattr(self, "map_"):
            raise AttributeError("a trained map is drawn")
        return super()._repr_html_

    def _repr_mimebundle_(self, **kwargs):
        picture = self._repr_svg_()
        if picture is None:
            return super()._repr_mimebundle_(**kwargs)
        return {"text/plain": repr(self), "image/svg+xml": picture}

    def _data(self, X, y):
        """What is drawn: the samples of X, or else those of fit."""
        check_fitted(self, "map_")
        if X is None:
            if y is not None:
                raise UsageError("there are labels without samples", "SOM(y)", "pass X as well")
            numbers = getattr(self, "_classes_of_samples", None)
            classes = None if numbers is None else (self.classes_, numbers)
            return MapData(self.map_, getattr(self, "hits_", None), getattr(self, "winners_", None),
                           classes)
        X = self._checked(X)
        _, _, hits, winners = self.map_.quality(X, self._threads())
        labels = None if y is None else self._labels(y, X)
        return MapData(self.map_, hits, winners,
                       None if labels is None or not labels.known.any()
                       else (labels.names, labels.numbers), X)


def _on_skin(layout, neuron, others, where):
    """Whether a skin is drawn; it shows weights only."""
    if layout is None and neuron is not None:
        raise UsageError("neuron has no effect without a layout", where, "pass layout=FILE")
    if layout is not None and any(one is not None for one in others):
        raise UsageError("a picture of weights on a skin has no panels and no samples", where,
                         "omit panel, X and y, or the layout")
    return layout is not None
