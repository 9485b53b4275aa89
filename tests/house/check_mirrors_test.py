import unittest

from support import TreeTest

import check_mirrors


class Mirrors(TreeTest):
    def setUp(self):
        super().setUp()
        self.write_rooms()

    def problems(self):
        return check_mirrors.check(self.tree)

    def test_passes_a_mirrored_tree(self):
        for name in ("include/somato/maps/grid.h", "src/maps/grid/grid.cc", "tests/maps/grid/grid_test.cc",
                     "include/somato/core/result.h", "src/maps/som/rows.h", "src/maps/som/rows.cc",
                     "tests/base/core/result_test.cc", "tests/maps/support/laws.h", "tests/maps/support/laws_test.cc"):
            self.write(name)
        self.assertEqual(self.problems(), [])

    def test_refuses_a_source_without_a_header(self):
        self.write("src/maps/grid/grid.cc", '#include <vector>\n')
        self.write("src/maps/grid/ring.cc", '#include "somato/core/check.h"\n')
        self.assertEqual(self.problems(), [
            f"src/maps/grid/{name}.cc: no header of its name, and its first include is not a header of 'maps'"
            for name in ("grid", "ring")])

    def test_passes_a_source_that_begins_with_the_header_that_it_defines(self):
        self.write("src/maps/som/som_elements.cc", '#include "somato/maps/som.h"\n\n#include <vector>\n')
        self.write("src/systems/modules/drift.cc", '#include "systems/modules/support.h"\n')
        self.assertEqual(self.problems(), [])

    def test_refuses_a_header_in_another_wing(self):
        self.write("src/maps/grid/grid.cc")
        self.write("include/somato/codes/grid.h")
        self.assertEqual(len(self.problems()), 1)

    def test_refuses_a_public_header_without_a_test(self):
        self.write("src/maps/grid/grid.cc")
        self.write("include/somato/maps/grid.h")
        self.assertEqual(self.problems(), ["include/somato/maps/grid.h: no tests/maps/ROOM/grid_test.cc"])

    def test_passes_one_subject_of_a_header(self):
        for name in ("include/somato/maps/grid.h", "src/maps/grid/grid.cc", "tests/maps/grid/grid_test.cc",
                     "tests/maps/grid/grid_laws_test.cc"):
            self.write(name)
        self.assertEqual(self.problems(), [])

    def test_one_subject_does_not_stand_for_the_whole(self):
        for name in ("include/somato/maps/grid.h", "src/maps/grid/grid.cc", "tests/maps/grid/grid_laws_test.cc"):
            self.write(name)
        self.assertEqual(self.problems(), ["include/somato/maps/grid.h: no tests/maps/ROOM/grid_test.cc"])

    def test_refuses_a_test_of_nothing(self):
        self.write("tests/maps/grid/gird_test.cc")
        self.assertEqual(self.problems(), ["tests/maps/grid/gird_test.cc: no header of that name"])

    def test_refuses_a_test_in_another_room_than_its_header(self):
        self.write("src/maps/som/rows.h")
        self.write("tests/maps/grid/rows_test.cc")
        self.assertEqual(self.problems(), ["tests/maps/grid/rows_test.cc: no header of that name"])


if __name__ == "__main__":
    unittest.main()
