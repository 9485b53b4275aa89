"""Code that the tests of the scripts share."""

import sys
import tempfile
import unittest
from pathlib import Path

TREE = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(TREE / "scripts"), str(TREE / "scripts" / "release")]


class TreeTest(unittest.TestCase):
    """A test with a small source tree of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = Path(folder.name)

    def write_rooms(self):
        """Gives the tree the table of rooms of this checkout."""
        self.write("src/rooms.json", (TREE / "src/rooms.json").read_text(encoding="utf-8"))

    def write(self, name, text=""):
        path = self.tree / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path
