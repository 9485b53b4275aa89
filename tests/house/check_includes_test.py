import unittest

from support import TreeTest

import check_includes


class IncludeTable(TreeTest):
    def setUp(self):
        super().setUp()
        self.write_rooms()

    def problems(self):
        """Those of the table and of guests; a test of its own covers what entrances reach."""
        return [problem for problem in check_includes.check(self.tree) if "no entrance" not in problem]

    def test_passes_what_the_table_allows(self):
        self.write("include/somato/maps/grid.h",
                   '#include <vector>\n#include "somato/core/check.h"\n'
                   '#include "somato/files/bytes.h"\n#include "somato/maps/schedule.h"\n')
        self.write("src/maps/grid/ring.cc", '#include "somato/drawing/map_picture.h"\n')  # the face of its wing
        self.write("src/systems/graph/builder.cc", '#include "somato/codes/one_hot.h"\n#include <fmt/core.h>\n')
        self.write("program/main.cc", '#include "version.h"\n#include "flags/commands.h"\n#include <CLI/CLI.hpp>\n')
        self.write("program/view/loop.cc", '#include "views/live/loop.h"\n#include "terminal/wording.h"\n')
        self.assertEqual(self.problems(), [])

    def test_refuses_a_wing_above_and_says_where(self):
        self.write("src/base/core/random.cc", "#include <cmath>\n\n#include \"somato/maps/grid.h\"\n")
        self.assertEqual(self.problems(), [
            "src/base/core/random.cc:3: 'base' may not include 'maps' (somato/maps/grid.h)"])

    def test_refuses_a_later_room(self):
        self.write("src/maps/grid/ring.cc", '#include "maps/som/map_rows.h"\n')
        self.write("program/terminal/wording.cc", '#include "view/browser.h"\n')
        self.assertEqual(self.problems(), [
            "src/maps/grid/ring.cc:1: 'maps/grid' may not include 'maps/som' (maps/som/map_rows.h)",
            "program/terminal/wording.cc:1: 'program/terminal' may not include 'program/view' (view/browser.h)"])

    def test_refuses_a_wing_beside(self):
        self.write("include/somato/codes/one_hot.h", '#include "somato/simulation/hand.h"\n')
        self.write("src/maps/grid/grid.cc", '#include "somato/recording/recording.h"\n')
        self.write("src/bodies/hands/hand.cc", '#include "somato/graph/graph.h"\n')
        self.assertEqual(len(self.problems()), 3)

    def test_refuses_paths_around_the_table(self):
        self.write("src/base/core/random.cc", '#include "../../studies/folds/fold_run.h"\n#include "random.h"\n')
        self.assertEqual(self.problems(), [
            "src/base/core/random.cc:1: '../../studies/folds/fold_run.h' is not the path of a header of a room",
            "src/base/core/random.cc:2: 'random.h' is not the path of a header of a room"])

    def test_sees_internal_headers_and_angle_brackets(self):
        self.write("src/base/files/bytes.cc", '#include "maps/som/map_rows.h"\n#  include <somato/maps/grid.h>\n')
        self.assertEqual(len(self.problems()), 2)

    def test_refuses_private_headers_of_others(self):
        self.write("src/base/files/toml_file.cc",
                   "#include <toml++/toml.h>\n#include <toml++/impl/unicode.h>\n#include <internal.h>\n")
        self.assertEqual(self.problems(), [
            "src/base/files/toml_file.cc:2: toml++/impl/unicode.h is a private header of another project"])

    def test_keeps_others_out_of_public_headers(self):
        self.write("include/somato/core/value.h", "#include <fmt/format.h>\n")
        self.write("include/somato/core/matrix.h", "#include <tl/expected.hpp>\n")
        self.write("include/somato/maps/grid.h", '#include "base/kernels/kernels.h"\n')
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
        self.write("src/hardware/devices/bus.cc", "#include <mutex>\n")
        self.write("src/hardware/lines/sound_source.cc", "#include <thread>\n")
        self.write("src/maps/som/som.cc", "#include <mutex>\n")
        self.assertEqual(self.problems(),
                         ["src/hardware/devices/bus.cc:1: 'hardware/devices' takes no locks (mutex)"])

    def test_refuses_unknown_rooms(self):
        self.write("src/attic/thing.cc")
        self.write("src/maps/thing.cc")
        self.write("src/maps/attic/thing.cc")
        self.write("include/somato/attic/thing.h")
        self.assertEqual(self.problems(), [
            f"{name}:1: '{name.rpartition('/')[0]}' is not a room of src/rooms.json"
            for name in ("include/somato/attic/thing.h", "src/attic/thing.cc", "src/maps/attic/thing.cc",
                         "src/maps/thing.cc")])


if __name__ == "__main__":
    unittest.main()
