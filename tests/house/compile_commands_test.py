"""Tests of scripts/compile_commands.py."""

import json
import tempfile
import unittest
from pathlib import Path

from support import TREE

import compile_commands


class CompileCommands(unittest.TestCase):
    def test_sources_that_are_compiled_together_have_the_command_of_their_group(self):
        with tempfile.TemporaryDirectory() as folder:
            group = Path(folder) / "src/together/somato/src_maps_0.cc"
            group.parent.mkdir(parents=True)
            group.write_text('#include "src/maps/grid/grid.cc"\n#include "src/maps/grid/areas.cc"\n', encoding="utf-8")
            single = TREE / "src/base/kernels/kernels_avx2.cc"
            entries = [{"file": str(group), "command": "c++ group"}, {"file": str(single), "command": "c++ single"}]
            (Path(folder) / "compile_commands.json").write_text(json.dumps(entries), encoding="utf-8")
            self.assertEqual(compile_commands.by_file(Path(folder)), {
                TREE / "src/maps/grid/grid.cc": ("c++ group", group),
                TREE / "src/maps/grid/areas.cc": ("c++ group", group),
                single: ("c++ single", single)})


if __name__ == "__main__":
    unittest.main()
