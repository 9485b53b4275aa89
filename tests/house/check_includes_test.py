import unittest

from support import TreeTest

import check_includes


class IncludeTable(TreeTest):
    def problems(self):
        """Those of the table and of guests; a test of its own covers what entrances reach."""
        return [problem for problem in check_includes.check(self.tree) if "no entrance" not in problem]

    def test_passes_what_the_table_allows(self):
        self.write("include/somato/maps/grid.h",
                   '#include <vector>\n#include "somato/core/check.h"\n'
                   '#include "somato/files/bytes.h"\n#include "somato/maps/schedule.h"\n')
        self.write("src/graph/builder.cc", '#include "somato/codes/one_hot.h"\n#include <fmt/core.h>\n')
        self.write("program/main.cc", '#include "somato/live/loop.h"\n#include <CLI/CLI.hpp>\n')
        self.assertEqual(self.problems(), [])

    def test_refuses_a_look_upwards_and_says_where(self):
        self.write("src/core/random.cc", "#include <cmath>\n\n#include \"somato/maps/grid.h\"\n")
        self.assertEqual(self.problems(), [
            "src/core/random.cc:3: 'core' may not look at 'maps' (somato/maps/grid.h)"])

    def test_refuses_a_look_aside(self):
        self.write("include/somato/codes/one_hot.h", '#include "somato/maps/grid.h"\n')
        self.write("src/maps/grid.cc", '#include "somato/recording/recording.h"\n')
        self.write("src/bodies/hand.cc", '#include "somato/graph/graph.h"\n')
        self.assertEqual(len(self.problems()), 3)

    def test_sees_internal_headers_and_angle_brackets(self):
        self.write("src/files/bytes.cc", '#include "maps/kernels.h"\n#  include <somato/maps/grid.h>\n')
        self.assertEqual(len(self.problems()), 2)

    def test_keeps_others_out_of_public_headers(self):
        self.write("include/somato/core/value.h", "#include <fmt/format.h>\n")
        self.write("include/somato/core/matrix.h", "#include <tl/expected.hpp>\n")
        self.write("include/somato/maps/grid.h", '#include "maps/kernels.h"\n')
        self.write("include/somato/core/result.h", "#include <tl/expected.hpp>\n")
        self.assertEqual(len(self.problems()), 3)
        self.assertIn("include/somato/core/value.h:1: a public header may not bring in fmt/format.h",
                      self.problems())

    def test_refuses_public_headers_that_no_entrance_includes(self):
        self.write("include/somato/som.h", '#include "somato/maps/som.h"\n')
        self.write("include/somato/maps/som.h", '#include "somato/maps/grid.h"\n')
        self.write("include/somato/maps/grid.h", "#include <vector>\n")
        self.write("include/somato/maps/schedule.h", '#include "somato/maps/grid.h"\n')
        self.assertEqual(check_includes.check(self.tree), [
            "include/somato/maps/schedule.h:1: no entrance header includes it; move it to src"])

    def test_refuses_locks_where_servos_are_driven(self):
        self.write("src/devices/bus.cc", "#include <mutex>\n")
        self.write("src/wire/sound_source.cc", "#include <thread>\n")
        self.write("src/maps/som.cc", "#include <mutex>\n")
        self.assertEqual(self.problems(), ["src/devices/bus.cc:1: 'devices' takes no locks (mutex)"])

    def test_refuses_unknown_rooms(self):
        self.write("src/attic/thing.cc")
        self.assertEqual(self.problems(), ["src/attic/thing.cc:1: 'attic' is not a room of the table"])


if __name__ == "__main__":
    unittest.main()
