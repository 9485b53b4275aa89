import json
import unittest

from support import TreeTest

import check_rooms
import rooms

TABLE = {
    "base": {"holds": "what serves all", "uses": [], "public": [], "rooms": {"core": {"holds": "checks"}}},
    "program": {"holds": "the command line", "uses": ["base"], "public": [], "rooms": {"flags": {"holds": "commands"}}},
}


class Rooms(TreeTest):
    def setUp(self):
        super().setUp()
        self.write("tests/CMakeLists.txt", "somato_wing_tests(base)\nsomato_wing_tests(program libraries)\n")
        self.write_table(TABLE)
        self.write("src/base/README.md", "# base\n\n- `core`: checks.\n")
        self.write("program/README.md", "# program\n\n- `flags`: commands.\n")
        for number in range(4):
            self.write(f"src/base/core/part{number}.h", "line\n" * 50)
            self.write(f"program/flags/part{number}.h")

    def write_table(self, table):
        self.write("src/rooms.json", json.dumps(table))
        self.write("ARCHITECTURE.md", f"# Rooms\n\n{rooms.markdown(rooms.read(self.tree))}\n\nText\n")

    def problems(self):
        return check_rooms.check(self.tree)

    def test_passes_rooms_of_the_table(self):
        self.assertEqual(self.problems(), [])

    def test_refuses_a_crowded_room_and_says_what_to_do(self):
        for number in range(4, 27):
            self.write(f"src/base/core/part{number}.h")
        self.assertEqual(self.problems(), [f"base/core: 27 files; at most 26: {check_rooms.ADVICE}"])

    def test_refuses_a_wing_whose_tests_no_program_runs(self):
        self.write("tests/CMakeLists.txt", "somato_wing_tests(base)\n# somato_wing_tests(program)\n")
        self.assertEqual(self.problems(), ["tests/CMakeLists.txt: no line somato_wing_tests(program ...)"])

    def test_refuses_a_crowded_folder_of_the_pages(self):
        for number in range(27):
            self.write(f"web/src/view/part{number}.ts")
        self.assertEqual(self.problems(), [f"web/src/view: 27 files; at most 26: {check_rooms.ADVICE}"])

    def test_refuses_crowded_folders_of_other_code_unless_a_reason_is_listed(self):
        for number in range(27):
            self.write(f"python/package/part{number}.py")
            self.write(f"python/package/__pycache__/part{number}.pyc")
            self.write(f"scripts/part{number}.py")
        self.assertEqual(self.problems(), [f"python/package: 27 files; at most 26: {check_rooms.ADVICE}"])

    def test_refuses_a_reason_that_is_not_needed(self):
        self.write("scripts/part.py")
        self.assertEqual(self.problems(),
                         ["scripts: at most 26 files; remove it from LARGE_FOLDERS of check_rooms.py"])

    def test_refuses_a_small_room_without_a_reason(self):
        (self.tree / "program/flags/part0.h").unlink()
        self.assertEqual(self.problems(), ["program/flags: 3 files; at least 4: join it with its neighbour"])
        table = json.loads(json.dumps(TABLE))
        table["program"]["rooms"]["flags"]["small"] = "a reason"
        self.write_table(table)
        self.assertEqual(self.problems(), [])

    def test_refuses_a_wing_with_too_many_rooms(self):
        table = json.loads(json.dumps(TABLE))
        for number in range(10):
            table["base"]["rooms"][f"room{number}"] = {"holds": "files", "small": "a reason"}
        self.write_table(table)
        self.write("src/base/README.md", "# base\n" + "".join(f"`{room}`\n" for room in table["base"]["rooms"]))
        self.assertEqual(self.problems(), [f"base: 11 rooms; at most 10: {check_rooms.ADVICE}"])

    def test_refuses_folders_that_the_table_does_not_name(self):
        for name in ("src/base/attic/a.h", "src/attic/a.h", "tests/attic/a.h", "tests/base/attic/a.h"):
            self.write(name)
        self.assertEqual(self.problems(), [
            "base/attic: not a room of src/rooms.json", "src/attic: not a wing of src/rooms.json",
            "tests/attic: not a wing of src/rooms.json", "tests/base/attic: not a room of src/rooms.json"])

    def test_refuses_tests_that_would_not_be_compiled(self):
        for name in ("tests/base/part_test.cc", "tests/base/core/deeper/part_test.cc", "tests/base/core/part_test.cc"):
            self.write(name)
        self.assertEqual(self.problems(), ["tests/base/core/deeper/part_test.cc: a test belongs to tests/base/ROOM",
                                           "tests/base/part_test.cc: a test belongs to tests/base/ROOM"])

    def test_refuses_a_page_with_another_table(self):
        self.write("ARCHITECTURE.md", "| wing | may use |\n|---|---|\n| old | all |\n\n| room |\n|---|\n\nText\n")
        self.assertEqual(len(self.problems()), 1)
        check_rooms.fix(self.tree)
        self.assertEqual(self.problems(), [])
        self.assertTrue((self.tree / "ARCHITECTURE.md").read_text(encoding="utf-8").endswith("\n\nText\n"))

    def test_refuses_a_wing_without_a_page_of_all_its_rooms(self):
        (self.tree / "program/README.md").unlink()
        self.write("src/base/README.md", "line\n" * 61)
        self.assertEqual(self.problems(), [
            "base/README.md: 61 lines; at most 60", "base/README.md: does not name the rooms core",
            "program: no README.md, which says what comes in, what goes out and how to add the usual thing"])

    def test_notes_small_units_with_one_user(self):
        self.write("src/base/core/small.h", "line\n" * 10)
        self.write("src/base/core/part0.h", '#include "base/core/small.h"\n' * 50)
        self.assertEqual(list(check_rooms.small_units(self.tree)),
                         ["note: base/core/small has 10 lines and one user, base/core/part0"])
        self.write("src/base/core/part1.h", '#include "base/core/small.h"\n' * 50)
        self.assertEqual(list(check_rooms.small_units(self.tree)), [])


if __name__ == "__main__":
    unittest.main()
