"""Systems: their modules, training and outputs."""

import json
import sys

import numpy as np
import pytest

import pysomato
from pysomato import Recording, System, load, study

@pytest.fixture
def recording():
    random = np.random.default_rng(11)
    return Recording.from_arrays({"object": [["ball", "cube", "cone"][i % 3] for i in range(9)]},
                                 {"joints": [random.random((4 + i, 6)) + i % 3 for i in range(9)]})


@pytest.fixture
def system(tmp_path, study_text):
    path = tmp_path / "grasps.toml"
    path.write_text(study_text("seeds = 3", columns=5))
    return System(path)


def test_modules_are_described(system):
    assert repr(system) == "<System grasps: joints, closed, map>"
    assert system.modules[1] == {"name": "closed", "type": "last", "inputs": {"input": "joints"},
                                 "parameters": {}}
    assert system.modules[2]["parameters"] == {"rows": 4, "columns": 5, "iterations": 300}
    assert 'type = "som"' in system.toml
    assert System("shape_and_size").name == "shape_and_size"


def test_a_trained_system_is_that_of_a_study(system, recording, tmp_path):
    system.fit(recording, seed=7).save(tmp_path / "mine.somato")
    study(recording, system, first_seed=7, seeds=1).system.save(tmp_path / "study.somato")
    assert (tmp_path / "mine.somato").read_bytes() == (tmp_path / "study.somato").read_bytes()


def test_outputs_are_those_of_the_modules(system, recording, tmp_path):
    trained = system.fit(recording)
    for found, given in zip(trained.evaluate(recording, "joints"), recording["joints"]):
        np.testing.assert_array_equal(found, given)
    closed = trained.evaluate(recording, "closed")
    np.testing.assert_array_equal(closed, [frames[-1] for frames in recording["joints"]])
    activity = trained.evaluate(recording, "map", threads=2)
    assert {one.shape for one in activity} == {(4, 5)}
    winners = [winner_of(trained, frames) for frames in recording["joints"]]
    assert [int(one.argmax()) for one in activity] == winners
    trained.save(tmp_path / "grasps.somato")
    np.testing.assert_array_equal(load(tmp_path / "grasps.somato").evaluate(recording, "map"), activity)


def winner_of(trained, frames):
    live = trained.live()
    live.start()
    for frame in frames:
        live.step({"joints": frame})
    return live.winner()


def test_modules_of_a_trained_system_have_outputs(system, recording):
    outputs = [module["output"] for module in system.fit(recording).modules]
    assert outputs[0].startswith("6, ") and "every frame" in outputs[0]
    assert outputs[2].startswith("4 x 5")
    assert "U-matrix" in system.fit(recording)._repr_svg_()


def test_what_does_not_fit_is_named(system, recording, tmp_path, study_text):
    trained = system.fit(recording)
    with pytest.raises(pysomato.UsageError, match="did you mean 'closed'"):
        trained.evaluate(recording, "close")
    other = Recording.from_arrays({}, {"joints": [np.ones((3, 2))]})
    with pytest.raises(pysomato.DataError, match="joints"):
        trained.evaluate(other, "map")
    with pytest.raises(pysomato.UsageError, match="object"):
        system.fit(Recording.from_arrays({"trial": [1]}, {"joints": [np.ones((3, 6))]}))
    (tmp_path / "wrong.toml").write_text(study_text("seeds = 3").replace("[study]", "[stady]"))
    with pytest.raises(pysomato.UsageError, match="wrong.toml"):
        System(tmp_path / "wrong.toml")


class Stopped(Exception):
    pass


def test_the_progress_is_shown_and_can_stop(system, recording):
    shown = []

    def show(done, total):
        assert 0 <= done <= total
        shown.append(done)

    pysomato._somato.study(recording._inner, system._inner, {}, 1, show)
    assert shown == sorted(shown) and shown

    def stop(*_):
        raise Stopped

    with pytest.raises(Stopped):
        pysomato._somato.study(recording._inner, system._inner, {"seeds": 10**6}, 2, stop)


def test_lines_show_the_progress_without_tqdm(system, recording, monkeypatch, capfd):
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    study(recording, system, seeds=1)
    assert capfd.readouterr().err == ""
    study(recording, system, seeds=1, progress=True)
    assert ": 100 %, about 0 s left\n" in capfd.readouterr().err


def test_bars_show_the_progress_with_tqdm(system, recording, capfd):
    pytest.importorskip("tqdm")
    study(recording, system, seeds=1, progress=True)
    assert "it/s" in capfd.readouterr().err


def apart(things, explorations, seed=5):
    """Explorations of things whose joints differ by more than the noise."""
    random = np.random.default_rng(seed)
    names = [thing for thing in things for _ in range(explorations)]
    joints = [10.0 * list(things).index(name) + random.random((4, 6)) for name in names]
    return Recording.from_arrays({"object": names}, {"joints": joints})


def test_answers_are_those_of_the_program(system, tmp_path, somato):
    grasps = apart(["ball", "cube", "cone"], 8)
    first = Recording.from_arrays({"object": list(grasps.label("object"))[:16]},
                                  {"joints": grasps["joints"][:16]})
    trained = system.fit(first, unknown=True, false_alarm_rate=0.1)
    answers = trained.answers(grasps, threads=2)
    assert list(answers["answer"][:16]) == list(answers["nearest"][:16]) == ["ball"] * 8 + ["cube"] * 8
    assert set(answers["answer"][16:]) == {"unknown"}
    assert (answers["novelty"][:16] <= 1).all() and (answers["novelty"][16:] > 1).all()
    trained.save(tmp_path / "wary.somato")
    grasps.write(tmp_path / "grasps.mcap")
    lines = somato("apply", tmp_path / "wary.somato", tmp_path / "grasps.mcap", "--json")
    rows = json.loads(lines)["answers"]
    assert [row["object"] for row in rows] == list(answers["answer"])
    assert [row["winner"] for row in rows] == list(answers["winner"])
    np.testing.assert_allclose([row["novelty"] for row in rows], answers["novelty"], rtol=1e-6)
    plain = system.fit(first).answers(grasps)
    assert plain["novelty"].isna().all() and "unknown" not in set(plain["answer"])


def test_what_other_protocols_read_does_not_hinder_a_fit(tmp_path, system):
    path = tmp_path / "continual.toml"
    path.write_text(system.toml.replace("[study]", """[study]
protocols = ["object_after_object", "leave_class_out"]
folds = 4
replay_per_object = 2
taught_per_class = 1
false_alarm_rate = 0.2"""))
    continual = System(path)
    grasps = apart(["ball", "cube", "cone"], 8)
    assert continual.fit(grasps).answers(grasps)["novelty"].isna().all()
    assert continual.fit(grasps, unknown=True).answers(grasps)["novelty"].notna().all()
    study(grasps, continual, protocols=["k_folds"], seeds=1)
    with pytest.raises(pysomato.UsageError, match="study: 'folds' has no effect"):
        continual.fit(grasps, folds=3)


def test_a_system_is_taught_a_name(system):
    grasps = apart(["ball", "cube", "cone"], 8)
    first = Recording.from_arrays({"object": list(grasps.label("object"))[:16]},
                                  {"joints": grasps["joints"][:16]})
    trained = system.fit(first, unknown=True, false_alarm_rate=0.1)
    before = trained.answers(grasps)
    taught = trained.teach(grasps, -1, "cone")
    assert trained.answers(grasps).equals(before)  # it is another system
    after = taught.answers(grasps)
    assert after["answer"][23] == "cone" and after["novelty"][23] == 0
    assert set(after["nearest"][16:]) == {"cone"}
    assert after[:16].equals(before[:16])
    for name in ("", "unknown", "  ", "two\nlines", "nul\0", "a" * 256):
        with pytest.raises(pysomato.UsageError):
            trained.teach(grasps, 0, name)
    with pytest.raises(TypeError, match="must be a str, not int"):
        trained.teach(grasps, 0, 3)
    with pytest.raises(IndexError):
        trained.teach(grasps, 24, "cone")
