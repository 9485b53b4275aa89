"""The logic of scripts/accuracy_study.py: folds, choice of the baseline, clusters, stored cells and the page."""

import io
import itertools
import json
import math
import sys
from pathlib import Path

import numpy as np
import pytest
from sklearn.model_selection import KFold

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))

import accuracy_page  # noqa: E402: after the path
import accuracy_study  # noqa: E402
from accuracy import block_folds, cells, clusterers, data, methods, study  # noqa: E402


def mixed_labels(seed):
    random = np.random.default_rng(seed)
    return random.permutation(np.repeat(["ball", "cube", "cone", "tube"], [13, 5, 3, 10]))


class TestFolds:
    def test_blocks_are_those_of_unshuffled_folds_within_each_class(self):
        for seed, size in itertools.product(range(3), (10, 15, 25)):
            labels = np.random.default_rng(seed).permutation(np.repeat(["a", "b"], size))
            fold = block_folds.blocks(labels)
            for name in "ab":
                members = np.flatnonzero(labels == name)
                for number, (_, held) in enumerate(KFold(5).split(members)):
                    np.testing.assert_array_equal(fold[members[held]], number)

    def test_blocks_are_consecutive_and_of_equal_size(self):
        labels = mixed_labels(1)
        fold = block_folds.blocks(labels)
        for name in np.unique(labels):
            own = fold[labels == name]
            assert (np.diff(own) >= 0).all()
            sizes = np.bincount(own, minlength=5)
            assert sizes.max() - sizes.min() <= 1

    def test_interleaved_folds_separate_neighbours(self):
        np.testing.assert_array_equal(block_folds.interleaved(["a", "b", "a", "a", "a", "a", "a", "b"]),
                                      [0, 0, 1, 2, 3, 4, 0, 1])

    @pytest.mark.parametrize("rule", [block_folds.blocks, block_folds.interleaved])
    def test_each_sample_is_tested_once_and_not_learned_for_it(self, rule):
        labels = mixed_labels(2)
        tested = []
        for train, test in block_folds.divisions(rule(labels)):
            assert sorted([*train, *test]) == list(range(len(labels)))
            tested += list(test)
        assert sorted(tested) == list(range(len(labels)))

    def test_a_single_sample_is_not_tested(self):
        assert not list(block_folds.divisions(block_folds.blocks(["a"])))


def slow_neighbours(train, labels, test, power):
    """The label of the nearest row by explicit loops."""
    found = []
    for row in test:
        distances = [sum(abs(a - b) ** power for a, b in zip(row, other)) for other in train]
        found.append(labels[distances.index(min(distances))])
    return found


class TestMethods:
    @pytest.fixture
    def samples(self):
        """Classes that differ in small columns, beside a large one without information."""
        random = np.random.default_rng(5)
        labels = np.repeat(["a", "b", "c"], 15)
        vectors = random.normal(size=(45, 3)) + np.repeat(np.eye(3) * 4, 15, axis=0)
        return data.Samples(np.column_stack([vectors, random.normal(size=45) * 1000]), labels)

    @pytest.mark.parametrize("metric, power", [("euclidean", 2), ("manhattan", 1)])
    @pytest.mark.parametrize("scale", ["raw", "standardized"])
    def test_neighbours_are_those_of_loops(self, samples, metric, power, scale):
        train, test, labels = samples.vectors[::2], samples.vectors[1::2], samples.labels[::2]
        found, kept = methods.neighbour(metric, scale)(train, labels, test, 1)
        if scale == "standardized":
            mean, deviation = train.mean(axis=0), train.std(axis=0)
            train, test = (train - mean) / deviation, (test - mean) / deviation
        assert list(found) == slow_neighbours(train, labels, test, power)
        assert kept == len(train)

    def test_the_scale_is_chosen_by_the_training_part(self, samples):
        assert methods.chosen_candidate(samples.vectors, samples.labels)[1] == "standardized"
        informative = samples.vectors * [1, 1, 1, 0]
        informative[:, 3] = np.repeat([0, 1e6, 2e6], 15)
        noise = np.random.default_rng(1).normal(size=(45, 30))
        assert methods.chosen_candidate(np.hstack([noise, informative[:, 3:]]), samples.labels)[1] == "raw"

    def test_a_tie_takes_the_first_candidate(self):
        vectors = np.repeat([[0.0, 0.0], [9.0, 9.0]], 10, axis=0)
        assert methods.chosen_candidate(vectors, np.repeat(["a", "b"], 10)) == methods.CANDIDATES[0]

    def test_half_of_each_class_is_kept(self, samples):
        assert methods.half_of_samples(samples.vectors, samples.labels, samples.vectors[:3], 1)[1] == 21

    def test_sides_respect_the_share(self):
        for samples, share in itertools.product((4, 7, 30, 405), (0.1, 0.5, 1.0)):
            sides = methods.sides_within(share, samples)
            assert sides["rows"] * sides["columns"] <= max(2, share * samples)
        assert methods.sides_within(0.5, 200)["rows"] == 10

    @pytest.mark.parametrize("name", ["default", "manhattan", "measured", "suggested", "growing", "linear_discriminant",
                                      "support_vectors"])
    def test_separate_classes_are_named(self, name):
        random = np.random.default_rng(3)
        labels = np.array(["a", "b", "c"] * 12)
        vectors = random.normal(size=(36, 4)) + 30 * np.eye(4)[np.arange(36) % 3]
        found, kept = methods.METHODS[name].classify(vectors[:30], labels[:30], vectors[30:], 1)
        assert list(found) == list(labels[30:])
        assert 0 < kept <= 300

    def test_the_size_of_a_map_is_counted(self):
        vectors, labels = np.random.default_rng(1).normal(size=(40, 2)), np.array(["a", "b"] * 20)
        assert methods.som(0.5)(vectors, labels, vectors[:2], 1)[1] == 20

    def test_a_run_counts_every_test(self):
        samples = data.Samples(np.arange(10.0)[:, None], np.array(["a"] * 5 + ["b"] * 5))
        knows_three = methods.Method(
            "m", "", "", lambda train, labels, test, seed: (np.where(test[:, 0] < 3, "a", "?"), 2))
        run = study.run_of_folds(knows_three, samples, 1)
        assert (run["accuracy"], run["kept"], run["trained"]) == (0.3, 2, 8)
        assert run["learned"] == pytest.approx(0.3)  # each sample is learned in four of five folds

    def test_what_was_learned_is_counted_separately(self):
        samples = data.Samples(np.arange(10.0)[:, None], np.array(["a"] * 5 + ["b"] * 5))

        def knows_the_learned(train, labels, test, seed):
            known = dict(zip(train[:, 0], labels))
            return np.array([known.get(row[0], "?") for row in test]), 1

        run = study.run_of_folds(methods.Method("m", "", "", knows_the_learned), samples, 1)
        assert (run["accuracy"], run["learned"]) == (0, 1)

    def test_a_method_that_the_package_lacks_ends_the_program(self, monkeypatch):
        def lacks():
            raise methods.MissingFeature("it has no refinement")

        refined = methods.Method("refined", "", "", None, check=lacks)
        monkeypatch.setitem(methods.METHODS, "refined", refined)
        with pytest.raises(SystemExit, match="refined: it has no refinement; .* --methods default,growing$"):
            accuracy_study.check_methods(["default", "refined", "growing"])

    def test_unknown_names_are_refused(self):
        with pytest.raises(SystemExit, match="--only: 'moon' is not one of a, b"):
            accuracy_study.names_of("a,moon", ["a", "b"], "--only")


class TestData:
    def test_a_table_keeps_the_order_of_its_rows(self, tmp_path):
        file = tmp_path / "grasps.csv"
        file.write_text("object,slipped,one,two\nball,0,1,2\ncube,1,3,4\nball,0,5,6\n", encoding="utf-8")
        samples = data.table(file)
        np.testing.assert_array_equal(samples.vectors, [[1, 2], [3, 4], [5, 6]])
        assert list(samples.labels) == ["ball", "cube", "ball"]

    def test_samples_are_ordered_by_their_keys(self):
        samples = data.ordered([[1], [2], [3]], ["a", "b", "c"], [30, 10, 20])
        assert list(samples.labels) == ["b", "c", "a"]
        assert samples.vectors.ravel().tolist() == [2, 3, 1]

    def test_features_of_a_grasp(self):
        taxels = np.arange(60.0)[None]
        features = data.grasp_features(np.arange(9.0)[None], taxels)[0]
        assert features[:9].tolist() == list(range(9))
        np.testing.assert_allclose(features[9:14], [5.5, 17.5, 29.5, 41.5, 53.5])
        np.testing.assert_allclose(features[14:], math.sqrt(sum((i - 5.5) ** 2 for i in range(12)) / 11))

    def test_frames_are_rounded_up(self):
        assert [data.frames_in(share, 12) for share in (0.01, 0.2, 0.5, 1.0)] == [1, 3, 6, 12]

    def test_a_value_and_a_label_change_the_hash(self):
        first = data.Samples(np.zeros((2, 2)), np.array(["a", "b"]))
        assert first.hash() == data.Samples(np.zeros((2, 2)), np.array(["a", "b"])).hash()
        assert first.hash() != data.Samples(np.eye(2), first.labels).hash()
        assert first.hash() != data.Samples(first.vectors, np.array(["a", "c"])).hash()


class TestClusters:
    def test_sequential_centres_are_the_means_of_what_they_had(self):
        vectors = np.random.default_rng(4).normal(size=(50, 3))
        order = np.random.default_rng(9).permutation(50)
        had = [[vectors[i]] for i in order[:4]]
        for i in order[4:]:
            distances = [np.linalg.norm(vectors[i] - np.mean(own, axis=0)) for own in had]
            had[int(np.argmin(distances))].append(vectors[i])
        centres = clusterers.sequential_centres(vectors, 9, 4)
        np.testing.assert_allclose(centres, [np.mean(own, axis=0) for own in had])
        nearest = [int(np.argmin(np.linalg.norm(centres - vector, axis=1))) for vector in vectors]
        assert clusterers.nearest_centres(vectors, centres).tolist() == nearest

    def test_agreement_is_that_of_pairs_and_entropies(self):
        labels = ["a", "a", "a", "b", "b", "c"]
        clusters = [0, 0, 1, 1, 1, 2]
        pairs = list(itertools.combinations(range(6), 2))
        in_label = {(i, j) for i, j in pairs if labels[i] == labels[j]}
        in_cluster = {(i, j) for i, j in pairs if clusters[i] == clusters[j]}
        by_chance = len(in_label) * len(in_cluster) / len(pairs)
        expected = (len(in_label & in_cluster) - by_chance) / ((len(in_label) + len(in_cluster)) / 2 - by_chance)

        def entropy(values):
            return -sum(values.count(v) / 6 * math.log(values.count(v) / 6) for v in set(values))

        joint = entropy(list(zip(labels, clusters)))
        mutual = entropy(labels) + entropy(clusters) - joint
        found = clusterers.agreement(labels, clusters)
        assert found["clusters"] == 3
        assert found["adjusted_rand_index"] == pytest.approx(expected)
        mean = (entropy(labels) + entropy(clusters)) / 2
        assert found["normalized_mutual_information"] == pytest.approx(mutual / mean)

    @pytest.mark.parametrize("name", clusterers.CLUSTERERS)
    def test_every_clusterer_gives_each_vector_a_cluster(self, name):
        vectors = np.random.default_rng(2).normal(size=(40, 3)) + 8 * np.repeat(np.eye(3), [20, 10, 10], axis=0)
        clusters = clusterers.CLUSTERERS[name].cluster(vectors, 1)
        assert clusters.shape == (40,)
        assert len(np.unique(clusters)) <= 20


class TestCells:
    @pytest.fixture
    def counted(self, tmp_path):
        """A cell, and the list of its computations."""
        computed = []

        def compute(value):
            computed.append(value)
            return {"value": value}

        def cell(value=1, name="one.json"):
            return cells.Cell(tmp_path / "set" / name, {"value": value}, compute, (value,))

        return cell, computed

    def test_a_stored_cell_is_not_computed_again(self, counted):
        cell, computed = counted
        for _ in range(2):
            assert not cells.run([cell()], 1, io.StringIO())
        assert computed == [1]
        assert cell().stored()["value"] == 1

    def test_another_identity_is_computed(self, counted):
        cell, computed = counted
        cells.run([cell()], 1, io.StringIO())
        cells.run([cell(2)], 1, io.StringIO())
        assert computed == [1, 2]
        assert cell(1).stored() is None

    def test_a_damaged_file_is_computed_again(self, counted):
        cell, computed = counted
        cells.run([cell()], 1, io.StringIO())
        cell().path.write_text('{"identity"', encoding="utf-8")
        cells.run([cell()], 1, io.StringIO())
        assert computed == [1, 1]

    def test_a_failure_is_reported_and_the_others_are_stored(self, counted, tmp_path):
        cell, _ = counted
        failing = cells.Cell(tmp_path / "set" / "bad.json", {}, math.sqrt, (-1,))
        report = io.StringIO()
        failed = cells.run([failing, cell()], 1, report)
        assert list(failed) == ["set bad"]
        assert "math domain error" in failed["set bad"]
        assert cell().stored() and failing.stored() is None
        assert "1 of 2: set bad failed" in report.getvalue()
        assert [path.name for path in (tmp_path / "set").iterdir()] == ["one.json"]

    def test_processes_store_the_same(self, tmp_path):
        both = [cells.Cell(tmp_path / "set" / f"{n}.json", {"n": n}, dict, ([("value", n)],)) for n in (1, 2)]
        assert not cells.run(both, 2, io.StringIO())
        assert [cell.stored()["value"] for cell in both] == [1, 2]


def write_cell(folder, kind, set_name, method, accuracies, library="scikit-learn 1"):
    runs = [{"seed": seed, "accuracy": value, "learned": 0.875, "kept": 20.0, "trained": 80.0, "seconds": 0.5,
             "adjusted_rand_index": value, "normalized_mutual_information": value / 2, "clusters": 3 + seed}
            for seed, value in enumerate(accuracies, 1)]
    path = folder / kind / set_name / f"{method}.json"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps({"identity": {"library": library}, "samples": 100, "classes": 4, "columns": 7,
                                "runs": runs}), encoding="utf-8")


class TestPage:
    @pytest.fixture
    def folder(self, tmp_path):
        study.describe(tmp_path, 2)
        write_cell(tmp_path, "accuracy", "fabricslide", "best_neighbour", [0.8])
        write_cell(tmp_path, "accuracy", "fabricslide", "best_neighbour_interleaved", [0.95])
        write_cell(tmp_path, "accuracy", "fabricslide", "euclidean_standardized", [0.75])
        write_cell(tmp_path, "accuracy", "fabricslide", "default", [0.5, 0.7], "pysomato a")
        write_cell(tmp_path, "clusters", study.CLUSTERED[0], "map_10", [0.25, 0.75], "pysomato a")
        return tmp_path

    def page(self, folder, capsys):
        accuracy_page.main([str(folder)])
        return capsys.readouterr().out

    def test_figures_are_those_of_the_cells(self, folder, capsys):
        page = self.page(folder, capsys)
        assert "| map | 0.600 ± 0.141 | -20.0 | 20 (25 %) | 0.50 |" in page
        assert "| fabricslide | 0.600 | 0.800 | -20.0 | -5.0 | -15.0 | 0.875 | 20 (25 %) |" in page
        assert "| fabricslide | 0.800 | 0.950 | +15.0 |" in page
        assert "| map, 10 clusters of neurons | 0.500 ± 0.354 | 0.250 ± 0.177 | 4.5 ± 0.7 |" in page
        assert "100 explorations, 4 classes, 7 columns" in page

    def test_goals_are_judged_by_accuracy_and_by_memory(self, folder, capsys):
        for name, value in (("manhattan_standardized", 0.7), ("euclidean_standardized", 0.65), ("best_neighbour", 0.7)):
            write_cell(folder, "accuracy", "bts3v2_palm_45", name, [value])
        for name, value in (("default", 0.65), ("manhattan", 0.6), ("refined", 0.66), ("growing", 0.69)):
            write_cell(folder, "accuracy", "bts3v2_palm_45", name, [value, value], "pysomato a")
        page = self.page(folder, capsys)
        share = "25 % of"
        for line in (f"0.650 of 0.640 | {share} 100 % | met |",
                     f"0.600 of 0.640 | {share} 100 % | missed by 4.0 points |",
                     f"0.660 of 0.650 | {share} 50 % | met |",
                     f"0.660 of 0.670 | {share} 50 % | missed by 1.0 points |",
                     f"0.690 of 0.680 | {share} 30 % | met |"):
            assert line in page
        file = folder / "accuracy" / "bts3v2_palm_45" / "growing.json"
        file.write_text(file.read_text(encoding="utf-8").replace('"kept": 20.0', '"kept": 40.0'), encoding="utf-8")
        assert "0.690 of 0.680 | 50 % of 30 % | missed: too many vectors |" in self.page(folder, capsys)

    def test_methods_without_cells_are_named(self, folder, capsys):
        page = self.page(folder, capsys)
        (line,) = [line for line in page.splitlines() if line.startswith("Not run for")]
        assert "*map, refined*" in line and "*SVM*" in line
        assert "*map*" not in line and "*best nearest neighbour*" not in line

    def test_a_map_at_the_baseline_has_no_table(self, folder, capsys):
        write_cell(folder, "accuracy", "fabricslide", "growing", [0.8, 0.8], "pysomato a")
        assert "### growing map\n\nIt reaches the baseline on every set." in self.page(folder, capsys)

    def test_cells_of_two_versions_are_refused(self, folder):
        write_cell(folder, "accuracy", "fabricslide", "growing", [0.8], "pysomato b")
        with pytest.raises(SystemExit, match=r"several versions \(pysomato a, pysomato b\)"):
            accuracy_page.main([str(folder)])

    def test_a_changed_page_is_noticed(self, folder, capsys):
        page = folder / "accuracy.md"
        page.write_text(self.page(folder, capsys), encoding="utf-8")
        accuracy_page.main([str(folder), "--check", str(page)])
        page.write_text("something else", encoding="utf-8")
        with pytest.raises(SystemExit, match="differs"):
            accuracy_page.main([str(folder), "--check", str(page)])
