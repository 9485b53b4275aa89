"""Pictures: those of the program, and the cells on axes of matplotlib."""

import re
import shutil
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

import pysomato
from pysomato import SOM, Drawing, Recording

HEXAGONAL = {"rows": 3, "columns": 4, "lattice": "hexagonal", "iterations": 200}


@pytest.fixture
def som(X, labels):
    return SOM(**HEXAGONAL).fit(X, labels)


@pytest.fixture
def files(som, X, labels, tmp_path):
    """The map, its samples and labels, as the program reads them."""
    som.save(tmp_path / "map.somato")
    np.save(tmp_path / "rows.npy", X)
    (tmp_path / "labels.txt").write_text("".join(f"{label}\n" for label in labels))
    return tmp_path


def plot_of_program(somato, files, *flags):
    data = [files / "rows.npy", "--labels", files / "labels.txt"]
    somato("som", "plot", files / "map.somato", *data, "-o", files / "map.svg", *flags)
    return (files / "map.svg").read_text()


def test_a_drawing_is_that_of_the_program(somato, som, files, X, labels):
    expected = plot_of_program(somato, files)
    assert som.draw(title="map.somato").svg == expected
    assert som.draw(X=X, y=labels, title="map.somato").svg == expected
    loaded = SOM.load(files / "map.somato")
    assert loaded.draw(None, X, labels, title="map.somato").svg == expected


@pytest.mark.parametrize("panel", ["u_matrix", "hits", "labels", "components"])
def test_a_panel_is_that_of_the_program(somato, som, files, panel):
    expected = plot_of_program(somato, files, "--panels", panel, "--components", 3)
    assert som.draw(panel, title="map.somato", components=3).svg == expected


@pytest.mark.parametrize("panel, flags, look", [
    ("u_matrix_edges", [], {}),
    ("pies", [], {}),
    ("pies", ["--size-by-hits"], {"size_by_hits": True}),
    ("label_text", [], {}),
    ("components", ["--component-order", "likeness", "--component-scale", "common"],
     {"component_order": "likeness", "component_scale": "common"}),
    ("clusters", ["--clusters", "ward:3"], {"clusters": "ward:3"}),
    ("dendrogram", [], {}),
    ("projection", ["--clusters", "k_means:2"], {"clusters": "k_means:2"}),
    ("trajectory", ["--trajectory", "3..12"], {"trajectory": range(2, 12)}),
    ("hits", ["--clusters", "watershed"], {"clusters": "watershed"}),
])
def test_a_panel_of_any_kind_is_that_of_the_program(somato, som, files, X, labels, panel, flags, look):
    expected = plot_of_program(somato, files, "--panels", panel, *flags)
    assert som.draw(panel, X, labels, title="map.somato", **look).svg == expected


def test_panels_are_drawn_in_the_order_in_which_they_are_named(somato, som, files):
    expected = plot_of_program(somato, files, "--panels", "hits,u_matrix")
    assert som.draw(["hits", "u_matrix"], title="map.somato").svg == expected
    assert expected.index(">Hits<") < expected.index(">U-matrix<")


def test_clusters_of_any_origin_are_outlined(som):
    plain = som.draw("u_matrix").svg
    halves = np.arange(12) // 6
    outlined = som.draw("u_matrix", clusters=halves).svg
    assert plain != outlined and 'class="outlines"' in outlined
    assert som.draw("clusters", clusters=halves).svg.count('<text') > 12
    for clusters in (halves[:5], halves.astype(float), halves - 1, [halves]):
        with pytest.raises(pysomato.UsageError, match="each of the 12 neurons"):
            som.draw("u_matrix", clusters=clusters)
    with pytest.raises(pysomato.UsageError, match="hierarchical"):
        som.draw("dendrogram", clusters=halves)
    with pytest.raises(pysomato.UsageError, match="hierarchical"):
        som.draw("dendrogram", clusters="k_means:2")
    with pytest.raises(pysomato.UsageError, match="did you mean 'ward'"):
        som.draw("u_matrix", clusters="wart:2")
    with pytest.raises(pysomato.UsageError, match="not a number of clusters"):
        som.draw("u_matrix", clusters="ward:two")


def test_a_trajectory_has_consecutive_rows(som, X):
    whole = som.draw("trajectory", X[:5]).svg
    assert whole == som.draw("trajectory", X, trajectory=slice(0, 5)).svg
    assert whole == som.draw("trajectory", X, trajectory=range(5)).svg
    for rows in (range(0, 4, 2), range(3, 3), range(0, len(X) + 1), 3, slice(2, 2)):
        with pytest.raises(pysomato.UsageError, match="no consecutive rows"):
            som.draw("trajectory", X, trajectory=rows)
    with pytest.raises(pysomato.UsageError, match="cannot be followed"):
        som.draw("trajectory", np.tile(X, (30, 1))[:1001])


def test_names_of_a_loaded_map_are_written(som, files, labels):
    loaded = SOM.load(files / "map.somato")
    written = loaded.draw("label_text").svg
    assert str(labels[0]) in written
    assert "projection" in pysomato.drawing.PANELS
    assert 'class="samples"' in loaded.draw("projection").svg


def test_other_samples_are_drawn(som, X, labels):
    half = som.draw("hits", X[:30]).svg
    assert half != som.draw("hits").svg
    written = [int(text.text) for text in ElementTree.fromstring(half).iter(
        "{http://www.w3.org/2000/svg}text") if (text.text or "").isdigit()]
    assert sum(written) - max(written) == 30  # each cell, and the limits 0 and the greatest one


def test_a_drawing_is_saved_and_shown(som, tmp_path):
    drawing = som.draw("u_matrix")
    assert isinstance(drawing, Drawing)
    drawing.save(tmp_path / "map.svg")
    assert (tmp_path / "map.svg").read_text() == drawing.svg == drawing._repr_svg_()
    with pytest.raises(pysomato.UsageError, match="use the extension .svg or .pdf or .png"):
        drawing.save(tmp_path / "map.jpeg")
    with pytest.raises(pysomato.OperatingSystemError, match="missing"):
        drawing.save(tmp_path / "missing/map.svg")


def test_a_drawing_is_saved_as_pdf_and_png_by_chromium(tmp_path, monkeypatch):
    square = Drawing('<svg xmlns="http://www.w3.org/2000/svg" width="120" height="60" viewBox="0 0 120 60">'
                     '<rect x="60" y="0" width="60" height="60" fill="#ff8000"/></svg>')
    if shutil.which("chromium") is not None:
        pixels = pytest.importorskip("PIL.Image")
        square.save(tmp_path / "square.png")
        picture = pixels.open(tmp_path / "square.png").convert("RGB")
        assert picture.size == (240, 120)
        assert (picture.getpixel((60, 60)), picture.getpixel((180, 60))) == ((255, 255, 255), (255, 128, 0))
        square.save(tmp_path / "square.PDF")
        content = (tmp_path / "square.PDF").read_bytes()
        assert content.startswith(b"%PDF-") and content.count(b"/Type /Page\n") == 1
        assert re.search(rb"/MediaBox \[0 0 90 45", content)  # points
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(pysomato.OperatingSystemError, match="Chromium, which is not installed.*plot"):
        square.save(tmp_path / "other.pdf")
    assert not (tmp_path / "other.pdf").exists()


def test_panels_without_data_are_named(som, files, X):
    loaded = SOM.load(files / "map.somato")
    assert "Component 7" in loaded.draw().svg  # all that a map has without samples
    with pytest.raises(pysomato.UsageError, match="'hits' needs samples; pass them as X"):
        loaded.draw("hits")
    with pytest.raises(pysomato.UsageError, match="'labels' needs labelled samples"):
        loaded.draw(["u_matrix", "labels"], X)
    with pytest.raises(pysomato.UsageError, match="panels are: u_matrix"):
        som.draw("planes")
    with pytest.raises(pysomato.UsageError, match="pass X as well"):
        som.draw("labels", y=[1, 2])
    with pytest.raises(pysomato.UsageError, match="not a number of component planes"):
        som.draw("components", components=0)


def test_partial_fit_forgets_the_samples_of_fit(som, X):
    with pytest.raises(pysomato.UsageError, match="needs samples"):
        som.partial_fit(X).draw("hits")


def test_a_notebook_shows_u_matrix_and_hits(som):
    assert som._repr_svg_() == som.draw(["u_matrix", "hits"]).svg


def hand():
    """Two frames of a thumb and a finger; one value is missing."""
    return Recording.from_arrays(
        {"object": ["ball", "cube"]},
        {"touch": [np.array([[0, 1, 2], [3, 4, 9]]), np.zeros((1, 3))]}, units={"touch": "N"},
        rates={"touch": 10}, element_names={"touch": ["thumb_tip_1", "thumb_tip_2", "index_tip_1"]},
        valid={"touch": [np.array([[1, 1, 1], [1, 1, 0]]), None]})


def test_a_skin_has_its_values_and_names():
    svg = hand().draw("touch").svg
    for text in ("touch: object ball", "frame 1, 0.1 s", "thumb_tip_1: 3 N", "index_tip_1: missing",
                 ">index<", ">4 N<"):
        assert text in svg
    both = hand().draw("touch", frames=[0, -1], limits=(0, 8)).svg
    assert "frame 0, 0 s" in both and "frame 1, 0.1 s" in both and ">8 N<" in both
    assert "all values are 0 N" in hand().draw("touch", exploration=1).svg


@pytest.mark.parametrize("arguments, message", [
    (("tuoch",), "did you mean 'touch'"),
    (("touch", 2), "no exploration 2"),
    (("touch", 0, 2), "no frame 2"),
    (("touch", 0, []), "needs a frame"),
])
def test_a_skin_that_is_not_there_is_named(arguments, message):
    with pytest.raises(pysomato.UsageError, match=message):
        hand().draw(*arguments)
    with pytest.raises(pysomato.UsageError, match="lesser one first"):
        hand().draw("touch", limits=(1, 0))


@pytest.fixture
def axes():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    yield pyplot.subplots()[1]
    pyplot.close("all")


def test_axes_have_the_cells_and_values_of_the_map(som, axes):
    assert som.plot("u_matrix", ax=axes) is axes
    (cells,) = axes.collections
    np.testing.assert_array_equal(cells.get_array(), som.u_matrix().ravel())
    corners = [path.vertices[:6] for path in cells.get_paths()]
    assert len(corners) == 12
    # The regular hexagon of the first neuron: a cell wide, its side 1 / sqrt(3).
    sides = np.linalg.norm(np.diff(corners[0], axis=0), axis=1)
    np.testing.assert_allclose(sides, 1 / np.sqrt(3), rtol=1e-9)
    assert np.ptp(corners[0][:, 0]) == 1
    # The second row is half a cell to the right, below the first; neighbours share two corners.
    assert corners[4].mean(axis=0)[0] == pytest.approx(1.0)
    shared = {tuple(corner) for corner in corners[0]} & {tuple(corner) for corner in corners[4]}
    assert len(shared) == 2
    assert axes.get_ylim()[0] > axes.get_ylim()[1]


def test_axes_show_any_panel(som, axes):
    som.plot("hits", ax=axes)
    np.testing.assert_array_equal(axes.collections[0].get_array(), som.hits_)
    plane = som.plot(2)
    assert plane is not axes
    np.testing.assert_array_equal(plane.collections[0].get_array(), som.weights_[:, 2])
    named = som.plot("labels").get_legend_handles_labels()[1]
    assert named == list(som.classes_)
    for panel, message in [("components", "name or number of its column"), (7, "counted from 0"),
                           ("planes", "panels are")]:
        with pytest.raises(pysomato.UsageError, match=message):
            som.plot(panel)


def test_axes_show_the_values_of_edges(som, axes):
    cells = som.plot("u_matrix_edges", ax=axes).collections[0]
    rows, columns = 3, 4
    # Edges of a hexagonal plane: within rows, and two to the next row except at its end.
    edges = rows * (columns - 1) + (rows - 1) * (2 * columns - 1)
    assert len(cells.get_array()) == rows * columns + edges
    centres = np.array([path.vertices[:6].mean(axis=0) for path in cells.get_paths()])
    by_place = {tuple(np.round(centre, 6)): value for centre, value in zip(centres, cells.get_array(), strict=True)}
    neurons = som.map_.cells().mean(axis=1)
    for a in range(12):
        assert by_place[tuple(np.round(neurons[a], 6))] == som.u_matrix().ravel()[a]
        for b in range(a):
            if np.linalg.norm(neurons[a] - neurons[b]) < 1.1:
                expected = np.linalg.norm(som.weights_[a].astype(float) - som.weights_[b])
                assert by_place[tuple(np.round((neurons[a] + neurons[b]) / 2, 6))] == pytest.approx(expected)


def test_axes_show_the_plane_of_the_principal_components(som, X, axes):
    som.plot("projection", X, ax=axes)
    weights = som.weights_.astype(float)
    centred = weights - weights.mean(axis=0)
    expected = centred @ np.linalg.svd(centred)[2][:2].T
    samples, neurons = axes.collections[-2].get_offsets(), axes.collections[-1].get_offsets()
    np.testing.assert_allclose(np.abs(neurons), np.abs(expected), atol=1e-5)
    assert len(samples) == len(X)
    variances = np.linalg.svd(centred)[1] ** 2
    assert f"{variances[0] / variances.sum():.0%}" in axes.get_xlabel()


def test_axes_show_every_panel(som, X, labels, axes):
    from matplotlib import pyplot

    for panel in pysomato.drawing.PANELS:
        if panel == "components":
            continue
        axes.clear()
        drawn = som.plot(panel, X, labels, ax=axes, clusters="ward:3", trajectory=range(10))
        assert drawn.get_title()
        drawn.figure.canvas.draw()
    wedges = som.plot("pies", X, labels).patches
    pairs = {(winner, label) for winner, label in zip(som.predict(X), labels, strict=True)}
    assert len(wedges) == len(pairs)
    open_figures = len(pyplot.get_fignums())
    with pytest.raises(pysomato.UsageError, match="hierarchical"):
        som.plot("dendrogram", clusters="watershed")
    assert len(pyplot.get_fignums()) == open_figures


def test_names_too_long_for_cells_are_numbers_with_a_legend(som, X, axes):
    short = som.plot("label_text", X, ["ab"] * len(X), ax=axes)
    assert short.get_legend() is None and {text.get_text() for text in short.texts} == {"ab"}
    axes.clear()
    som.plot("label_text", X, ["w" * 60] * len(X), ax=axes)
    assert {text.get_text() for text in axes.texts} == {"1"}
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["1  " + "w" * 60]


def test_axes_show_a_column_by_its_name(X, axes):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(X, columns=["aperture_mm", "hits", *[f"joint{i}" for i in range(X.shape[1] - 2)]])
    som = pysomato.SOM(3, 4).fit(frame)
    plane = som.plot("aperture_mm", ax=axes)
    np.testing.assert_array_equal(plane.collections[0].get_array(), som.weights_[:, 0])
    assert plane.get_title() == "aperture_mm"
    # The name of a panel is that panel; the column of the same name has its number.
    np.testing.assert_array_equal(som.plot("hits").collections[0].get_array(), som.hits_)
    with pytest.raises(pysomato.UsageError, match="did you mean 'aperture_mm'.*the names of columns"):
        som.plot("aperture")


def test_without_matplotlib_a_plot_says_what_to_install(som, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ImportError, match=r"pip install 'pysomato\[matplotlib\]'"):
        som.plot()


@pytest.fixture
def pad(tmp_path, X):
    """A layout file of all columns but the first, in the opposite order."""
    columns = X.shape[1]
    places = [[4 * i, 3] for i in range(1, columns)]
    names = [f"'{column}'" for column in range(columns, 1, -1)]
    (tmp_path / "pad.toml").write_text(
        f"[layout.touch]\nplaces = {places}\nelements = [{', '.join(names)}]\n")
    return tmp_path / "pad.toml"


def test_weights_on_a_skin_are_drawn_as_by_the_program(somato, som, files, pad):
    for flags, options in ([(), {}], [("--neuron", "2,3"), {"neuron": 6}]):
        somato("som", "plot", files / "map.somato", "--layout", pad, "-o", files / "skin.svg", *flags)
        drawing = som.draw(layout=pad, title="map.somato", **options)
        assert drawing.svg == (files / "skin.svg").read_text()
        assert drawing.svg.count("row 2, column 3") == 1
    with pytest.raises(pysomato.UsageError, match="no panels"):
        som.draw("hits", layout=pad)
    with pytest.raises(pysomato.UsageError, match="without a layout"):
        som.draw(neuron=1)
    with pytest.raises(pysomato.UsageError, match="the map has 12"):
        som.draw(layout=pad, neuron=12)


def test_weights_on_a_skin_are_plotted_at_their_places(som, pad):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    points = som.plot(layout=pad, neuron=6).collections[0]
    np.testing.assert_array_equal(points.get_array(), som.weights_[6, :0:-1])
    assert points.get_offsets()[1].tolist() == [8, 3]
    means = som.plot(layout=pad).collections[0].get_array()
    np.testing.assert_allclose(means, som.weights_[:, :0:-1].mean(axis=0))


def test_frames_are_drawn_at_the_places_of_a_layout(tmp_path):
    (tmp_path / "pad.toml").write_text("[layout.touch]\nplaces = [[0, 0], [9, 3], [0, 3]]\n")
    recording = Recording.from_arrays({"object": ["cup"]}, {"touch": [np.float32([[1, 2, 3]])]})
    svg = recording.draw("touch", layout=tmp_path / "pad.toml").svg
    circles = ElementTree.fromstring(svg).findall(".//{http://www.w3.org/2000/svg}circle")
    x = [float(circle.get("cx")) for circle in circles]
    assert x[0] == x[2] < x[1]
    with pytest.raises(pysomato.UsageError, match="did you mean 'touhc'"):
        recording.draw("touch", layout=wrong_layout(tmp_path))


def wrong_layout(folder):
    (folder / "wrong.toml").write_text("[layout.touhc]\nplaces = [[0, 0], [9, 3], [0, 3]]\n")
    return folder / "wrong.toml"
