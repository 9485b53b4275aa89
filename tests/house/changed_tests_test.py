import unittest
from pathlib import Path
from unittest import mock

from support import TreeTest

import changed_run
import changed_tests

TREE = Path(changed_tests.__file__).resolve().parent.parent
TESTS = ["maps.som", "maps.grid", "program.view", "systems.codes", "systems.walk", "web.unit", "web.view",
         "web.view_moving", "web.report", "fuzz.csv_replay"]


class Selected(TreeTest):
    def setUp(self):
        super().setUp()
        self.write_rooms()
        self.write("include/somato/maps/som.h", "")
        self.write("src/maps/som/som.cc", '#include "somato/maps/som.h"\n')
        self.write("src/maps/som/elements.h", "")
        self.write("include/somato/graph/system.h", '#include "somato/maps/som.h"\n')
        self.write("tests/systems/graph/system_test.cc", '#include "somato/graph/system.h"\n')
        self.write("program/study/train_command.cc", '#include "somato/graph/system.h"\n')
        self.write("src/systems/codes/pca.h", "")
        self.write("src/systems/codes/pca.cc", '#include "systems/codes/pca.h"\n')
        self.write("fuzz/model_fuzz.cc", '#include "maps/som/elements.h"\n')
        self.write("docs/maps.md", "")

    def select(self, *names):
        return changed_tests.select(self.tree, list(names))

    def test_a_source_reaches_the_rooms_that_include_its_header(self):
        chosen = self.select("src/maps/som/som.cc")
        self.assertEqual(chosen.changed, {"maps/som"})
        self.assertEqual(chosen.near, {"maps": 0, "systems": 1, "systems/graph": 2, "program/study": 2})

    def test_a_header_reaches_fuzzers_and_only_those_that_include_it(self):
        self.assertEqual(self.select("src/maps/som/elements.h").near, {"fuzz.model_replay": 1})
        chosen = self.select("src/systems/codes/pca.h")
        self.assertEqual((chosen.changed, chosen.near), ({"systems/codes"}, {}))

    def test_a_source_that_defines_functions_of_another_header(self):
        self.write("src/maps/som/som_elements.cc", '#include "somato/maps/som.h"\n')
        self.assertEqual(self.select("src/maps/som/som_elements.cc").near["systems"], 1)

    def test_a_table_that_is_included(self):
        self.write("src/studies/results/metrics.inc", "")
        self.write("src/studies/results/metric_table.cc", '#include "studies/results/metrics.inc"\n')
        self.assertEqual(self.select("src/studies/results/metrics.inc").changed, {"studies/results"})

    def test_a_removed_header_is_not_an_error(self):
        self.assertEqual(self.select("src/maps/som/gone.h").changed, {"maps/som"})

    def test_files_that_are_not_sources(self):
        for name, reached in (
                ("web/tests/view/view.test.ts", {"web.view", "web.types"}),
                ("web/tests/report/report_faults.test.ts", {"web.report", "web.types"}),
                ("web/tests/parts/orbit.test.ts", {"web.unit", "web.types"}),
                ("web/src/report/map.ts", {"web.unit", "web.types", "web.report"}),
                ("python/somato/som.py", {"python"}), ("scripts/mutate.py", {"house"}),
                ("tests/program/hostile/killed_sessions.py", {"program/hostile"}),
                ("systems/texture.toml", {"studies"}), ("devices/leap.toml", {"hardware"}),
                ("fuzz/corpus/csv/a.csv", {"fuzz.csv_replay"}), ("tests/same_bits/expected.txt", {"same_bits"}),
                ("CHANGELOG.md", set())):
            with self.subTest(name):
                chosen = self.select(name)
                self.assertEqual((chosen.changed, chosen.near, chosen.unbounded), (reached, {}, []))

    def test_documents_that_still_exist(self):
        chosen = self.select("docs/maps.md", "docs/gone.md")
        self.assertEqual((chosen.documents, chosen.changed), (["docs/maps.md"], set()))

    def test_what_cannot_be_bounded(self):
        names = ["dev", "src/rooms.json", "cmake/SomatoTest.cmake", "src/CMakeLists.txt", "tests/base/support/random.cc"]
        self.assertEqual(self.select(*names).unbounded, names)
        self.assertEqual(self.select("tests/web/CMakeLists.txt").unbounded, [])


class WithinLimit(unittest.TestCase):
    def chosen(self, changed, near=None):
        return changed_tests.Selection(changed=set(changed), near=near or {})

    def test_the_nearest_come_first_up_to_the_limit(self):
        seconds = dict.fromkeys(["maps.som", "maps.grid"], 50) | {"program.view": 60, "web.unit": 5}
        run, left = changed_tests.within_limit(
            self.chosen(["systems/codes"], {"web.unit": 3, "program/view": 2, "maps": 1}), TESTS, seconds.get)
        self.assertEqual(run, ["systems.codes", "maps.som", "maps.grid", "web.unit"])
        self.assertEqual(left, ["program.view"])

    def test_a_changed_room_runs_whatever_it_costs(self):
        run, left = changed_tests.within_limit(self.chosen(["program"]), TESTS, lambda _: 1000)
        self.assertEqual((run, left), (["program.view"], []))

    def test_a_room_with_several_tests(self):
        tests = ["program.hostile.killed_sessions.1", "program.hostile_other", "program.view"]
        run, _ = changed_tests.within_limit(self.chosen(["program/hostile"]), tests, lambda _: 1)
        self.assertEqual(run, ["program.hostile.killed_sessions.1"])

    def test_single_tests(self):
        run, _ = changed_tests.within_limit(self.chosen(["web.view*", "fuzz.csv_replay"]), TESTS, lambda _: 1)
        self.assertEqual(run, ["web.view", "web.view_moving", "fuzz.csv_replay"])


class Run(unittest.TestCase):
    def test_targets(self):
        self.assertEqual(changed_run.targets_of(["maps.som", "maps.grid", "fuzz.csv_replay"], ["docs/a.md"]),
                         ["csv_replay", "docs_group", "maps_group"])

    def test_documents_run_one_by_one_with_the_options_of_the_build(self):
        command = ["measure", "times", "python3", "run_doc_blocks.py", "--link", "a.so", "--scratch", "s",
                   "--without", "docs/b.md", "--share", "2/2"]
        with mock.patch.object(changed_run, "passes", return_value=True) as passes:
            self.assertTrue(changed_run.run_documents(["docs/a.md"], {"docs.commands": command}))
        words = passes.call_args.args
        self.assertEqual(words[2:8], (*command[:6],))
        self.assertEqual(words[-2:], ("--only", "docs/a.md"))
        self.assertNotIn("--without", words)
        self.assertNotIn("--share", words)

    def test_seconds_of_the_budget_where_no_run_is_known(self):
        with mock.patch.object(changed_run, "UNIT", 0.5), mock.patch.multiple(changed_run.budget, LAST=TREE / "missing.json",
                                 read=lambda: {"dev: maps.som": 8.0, "dev: web.view": 3.0}):
            self.assertEqual(changed_run.seconds_by_test(["maps.som", "maps.new", "web.view"]),
                             {"maps.som": 4, "web.view": 1.5})


if __name__ == "__main__":
    unittest.main()
