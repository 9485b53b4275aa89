import unittest

from support import TreeTest

import check_mirrors


class Mirrors(TreeTest):
    def problems(self):
        return check_mirrors.check(self.tree)

    def test_passes_a_mirrored_tree(self):
        for name in ("include/somato/maps/grid.h", "src/maps/grid.cc", "tests/maps/grid_test.cc",
                     "include/somato/core/result.h", "src/maps/kernels.h", "src/maps/kernels.cc",
                     "tests/core/result_test.cc", "tests/support/laws.cc"):
            self.write(name)
        self.assertEqual(self.problems(), [])

    def test_refuses_a_source_without_a_header(self):
        self.write("src/maps/grid.cc")
        self.assertEqual(self.problems(),
                         ["src/maps/grid.cc: no include/somato/maps/grid.h and no src/maps/grid.h"])

    def test_refuses_a_header_in_another_room(self):
        self.write("src/maps/grid.cc")
        self.write("include/somato/codes/grid.h")
        self.assertEqual(len(self.problems()), 1)

    def test_refuses_a_public_header_without_a_test(self):
        self.write("src/maps/grid.cc")
        self.write("include/somato/maps/grid.h")
        self.assertEqual(self.problems(), ["include/somato/maps/grid.h: no tests/maps/grid_test.cc"])

    def test_passes_one_subject_of_a_header(self):
        for name in ("include/somato/maps/grid.h", "src/maps/grid.cc", "tests/maps/grid_test.cc",
                     "tests/maps/grid_laws_test.cc"):
            self.write(name)
        self.assertEqual(self.problems(), [])

    def test_one_subject_does_not_stand_for_the_whole(self):
        for name in ("include/somato/maps/grid.h", "src/maps/grid.cc", "tests/maps/grid_laws_test.cc"):
            self.write(name)
        self.assertEqual(self.problems(), ["include/somato/maps/grid.h: no tests/maps/grid_test.cc"])

    def test_refuses_a_test_of_nothing(self):
        self.write("tests/maps/gird_test.cc")
        self.assertEqual(self.problems(), ["tests/maps/gird_test.cc: no header of that name"])


if __name__ == "__main__":
    unittest.main()
