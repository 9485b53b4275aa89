"""Studies give the results of the program, and their systems process frames."""

import functools
import json
import shutil
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

import pysomato
from pysomato import Recording, System, load, study, suggest

@pytest.fixture
def recording():
    random = np.random.default_rng(11)
    centres = random.normal(size=(3, 5))
    joints = [np.linspace(0, 1, 6)[:, None] * centres[i % 3] + random.normal(size=(6, 5)) * 0.05
              for i in range(15)]
    return Recording.from_arrays({"object": [["ball", "cube", "cone"][i % 3] for i in range(15)]},
                                 {"joints": joints}, rates={"joints": 10})


@pytest.fixture
def toml(tmp_path, study_text):
    path = tmp_path / "grasps.toml"
    path.write_text(study_text('protocols = ["train_is_test", "leave_one_out"]\nseeds = 3'))
    return path


def test_results_are_those_of_the_program(somato, recording, toml, tmp_path):
    recording.write(tmp_path / "grasps.mcap")
    somato("run", toml, "--data", tmp_path / "grasps.mcap", "--seeds", 2, "--out", tmp_path / "out")
    expected = json.loads((tmp_path / "out/results.json").read_text())
    outcome = study(recording, toml, seeds=2)
    assert outcome.results["parts"][0]["protocols"] == expected["parts"][0]["protocols"]
    outcome.system.save(tmp_path / "mine.somato")
    assert (tmp_path / "mine.somato").read_bytes() == (tmp_path / "out/system.somato").read_bytes()
    assert outcome.draw().svg == (tmp_path / "out/map.svg").read_text() == outcome._repr_svg_()


def test_files_and_report_are_those_of_the_program(somato, recording, toml, tmp_path):
    recording.write(tmp_path / "recording.mcap")
    somato("run", toml, "--data", tmp_path / "recording.mcap", "--seeds", 2, "--out", tmp_path / "out")
    outcome = study(recording, toml, seeds=2)
    outcome.save(tmp_path / "mine")
    assert {file.name for file in (tmp_path / "mine").iterdir()} == {
        file.name for file in (tmp_path / "out").iterdir()}
    for name in ("system.somato", "map.svg"):
        assert (tmp_path / "mine" / name).read_bytes() == (tmp_path / "out" / name).read_bytes()
    results = json.loads((tmp_path / "mine/results.json").read_text())
    expected = json.loads((tmp_path / "out/results.json").read_text())
    for name in ("protocols", "model", "pairs"):
        assert results["parts"][0].get(name) == expected["parts"][0].get(name)
    with pytest.raises(pysomato.OperatingSystemError, match="map.svg"):
        outcome.save(tmp_path / "mine/map.svg")
    page = outcome.report()
    assert page.html == outcome.report().html  # nothing depends on the folder of its files
    page.save(tmp_path / "page.html")
    somato("report", tmp_path / "mine/results.json", "--data", tmp_path / "recording.mcap", "-o",
           tmp_path / "report.html")
    printed = (tmp_path / "report.html").read_text()
    assert page.html == printed.replace(f"{tmp_path}/mine/", "")
    assert (tmp_path / "page.html").read_text() == page.html


def test_a_notebook_shows_the_report_in_a_frame(recording, toml):
    page = study(recording, toml, seeds=1, protocols="train_is_test").report(height=500)
    (frame,) = ElementTree.fromstring(f"<div>{page._repr_html_()}</div>")
    assert (frame.tag, frame.get("height")) == ("iframe", "500")
    assert frame.get("srcdoc").replace("\n", " ") == page.html.replace("\n", " ")
    with pytest.raises(pysomato.UsageError, match="use the extension .html"):
        page.save("report.pdf")


def test_the_map_of_a_study_has_its_winners(recording, toml):
    outcome = study(recording, toml, seeds=1, protocols="train_is_test")
    run = outcome.results["parts"][0]["protocols"][0]["runs"][0]
    closed = [frames[-1] for frames in recording["joints"]]
    np.testing.assert_array_equal(outcome.som.winners_, run["winners"])
    np.testing.assert_array_equal(outcome.som.predict(closed), run["winners"])
    np.testing.assert_array_equal(outcome.som.hits_, np.bincount(run["winners"], minlength=16))
    labels = recording.label("object")
    assert outcome.som.draw().svg == outcome.som.draw(X=closed, y=labels).svg


def test_results_are_frames(recording, toml):
    pytest.importorskip("pandas")
    outcome = study(recording, toml, seeds=2, protocols=["leave_one_out"], first_seed=7)
    values = outcome.values
    accuracy = values[values.metric == "accuracy"]
    assert list(accuracy.seed) == [7, 8]
    assert set(outcome.metrics.protocol) == {"leave_one_out"}
    metrics = outcome.metrics.set_index("metric")
    assert metrics.loc["accuracy", "mean"] == pytest.approx(accuracy.value.mean())
    assert metrics.loc["accuracy", "sd"] == pytest.approx(accuracy.value.std())
    predictions = outcome.predictions
    assert len(predictions) == 30
    named_right = (predictions.label == predictions.prediction).groupby(predictions.seed).mean()
    np.testing.assert_allclose(named_right, accuracy.value)
    assert outcome._repr_svg_().startswith("<svg") or "<svg" in outcome._repr_svg_()


def test_a_trained_system_processes_frames(recording, toml, tmp_path):
    outcome = study(recording, toml, seeds=1, protocols="train_is_test")
    outcome.system.save(tmp_path / "system.somato")
    run = outcome.results["parts"][0]["protocols"][0]["runs"][0]
    for system in (outcome.system, load(tmp_path / "system.somato")):
        live = system.live()
        assert live.channels == ["joints"]
        for exploration in range(15):
            live.start(10)
            for frame in recording["joints"][exploration]:
                live.step({"joints": frame})
            assert live.winner() == run["winners"][exploration]
            assert live.label() == run["predictions"][exploration]
    assert 'type = "som"' in load(tmp_path / "system.somato").toml


def test_a_live_system_always_answers_the_most_similar_class(recording, toml):
    system = System(toml).fit(recording, seed=1)
    live = system.live()
    centres = [frames[-1] for frames in recording["joints"]]
    answers, named = [], set(study(recording, toml, seeds=1).som.winners_)
    unnamed = 0
    for one in centres:
        for other in centres[:3]:  # between two things, where no exploration has been
            between = Recording.from_arrays({"object": ["x"]}, {"joints": [[0.5 * (one + other)]]})
            live.start()
            live.step({"joints": between["joints"][0][0]})
            unnamed += live.winner() not in named
            answers.append(live.label() == system.answers(between)["nearest"][0])
    assert unnamed > 0 and all(answers)


def test_the_map_of_a_study_is_at_the_end_of_its_training(recording, toml):
    som = study(recording, toml, seeds=1, protocols="train_is_test").som
    assert som.samples_seen_ == som.get_params()["iterations"]
    rows = [frames[-1] for frames in recording["joints"]]
    before = -som.score(rows)
    assert -som.partial_fit(rows[:3]).score(rows) < 1.1 * before


def test_a_live_system_outlives_its_file_and_study(recording, toml):
    live = study(recording, toml, seeds=1, protocols="train_is_test").system.live()
    live.start()
    with pytest.raises(ValueError):
        live.winner()
    with pytest.raises(KeyError) as caught:
        live.step({"touch": [1.0]})
    assert isinstance(caught.value, pysomato.UsageError) and "channels are: joints" in str(caught.value)
    with pytest.raises(pysomato.UsageError):
        live.step({"joints": [1.0, 2.0]})
    for value in (None, float("nan"), np.ma.masked):
        with pytest.raises(pysomato.DataError, match="joints"):
            live.step({"joints": [0.0, value, 0.0, 0.0, 0.0]})
    with pytest.raises(pysomato.DataError, match="joints"):
        live.step({"joints": np.ma.masked_equal([0.0, 7.0, 0.0, 0.0, 0.0], 7.0)})
    live.step({"joints": [0.0] * 5})
    assert 0 <= live.winner() < 16


def test_suggestions_are_those_of_the_program(recording, somato, tmp_path):
    recording.write(tmp_path / "grasps.mcap")
    somato("suggest", tmp_path / "grasps.mcap", "--budget", 50, "--seed", 3, "-o", tmp_path / "theirs.toml",
           "--name", "mine")
    suggested = suggest(recording, budget=50, seed=3, name="mine")
    suggested.save(tmp_path / "mine.toml")
    assert (tmp_path / "mine.toml").read_text() == (tmp_path / "theirs.toml").read_text()
    assert suggested.scores["combinations"] > 0
    assert (suggested.name, suggested.modules) == ("mine", System(tmp_path / "theirs.toml").modules)
    assert len(study(recording, suggested, seeds=1).predictions) > 0


def test_wrong_settings_of_suggestions_are_named(recording):
    with pytest.raises(pysomato.UsageError, match="did you mean 'budget'"):
        suggest(recording, buget=50)
    with pytest.raises(pysomato.UsageError, match="'budget' must be a whole number.*not None"):
        suggest(recording, budget=None)
    with pytest.raises(pysomato.DataError, match="only one exploration"):
        suggest(Recording.from_arrays({"object": ["a"]}, {"joints": [np.ones((3, 2))]}))


def test_own_systems_have_names():
    assert "shape_and_size" in pysomato.systems()


@pytest.mark.parametrize("settings, message", [
    ({"seed": 2}, "did you mean 'seeds'"),
    ({"seeds": 0}, "seeds"),
    ({"protocols": ["leave_group_out"]}, "groups"),
    ({"label": "material"}, "object"),
])
def test_wrong_settings_are_named(recording, toml, settings, message):
    with pytest.raises(pysomato.UsageError, match=message):
        study(recording, toml, **settings)


def test_files_that_are_wrong_are_named(recording, toml, tmp_path):
    toml.write_text(toml.read_text().replace('type = "last"', 'type = "lats"'))
    with pytest.raises(pysomato.UsageError, match="grasps.toml:.*'last'"):
        study(recording, toml)
    with pytest.raises(pysomato.UsageError, match="joints"):
        study(recording, "texture")
    with pytest.raises(pysomato.OperatingSystemError, match="none.toml"):
        study(recording, tmp_path / "none.toml")
    with pytest.raises(pysomato.DataError, match="grasps.toml"):
        load(toml)


@pytest.mark.skipif(shutil.which("chromium") is None, reason="figures are drawn by Chromium")
def test_a_figure_of_a_study_is_that_of_the_program(recording, toml, tmp_path):
    outcome = study(recording, toml, seeds=1, protocols="train_is_test")
    outcome.figure("methods", tmp_path / "methods.txt")
    methods = (tmp_path / "methods.txt").read_text()
    assert f"Somato, version {pysomato.__version__}" in methods
    assert "explorations of" in methods and "in 1 run with the seed 1." in methods


def test_arguments_of_a_figure_are_those_of_the_program(tmp_path):
    figure = functools.partial(pysomato.figure, tmp_path / "results.json", "map")
    with pytest.raises(pysomato.UsageError, match="known are: .svg, .pdf, .png"):
        figure(tmp_path / "map.gif")
    with pytest.raises(pysomato.UsageError, match="'20in' is not from 20 to 500 mm"):
        figure(tmp_path / "map.pdf", width="20in")
    with pytest.raises(pysomato.UsageError, match="caption: has no effect"):
        figure(tmp_path / "map.csv", caption=True)
    with pytest.raises(pysomato.Error, match="results.json"):
        figure(tmp_path / "map.pdf", width="3.3in", caption=True, selection="run=1")
