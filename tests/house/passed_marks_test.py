import os
import shutil
import time
import unittest
from unittest import mock

from support import TreeTest

import passed_marks


class PassedMarks(TreeTest):
    def setUp(self):
        super().setUp()
        self.enterContext(mock.patch.dict(os.environ, XDG_CACHE_HOME=str(self.tree / "cache")))

    def key(self, tree, command="clang -I{tree}/src a.cc"):
        files = [tree / "build/unity.cxx", tree / "src/a.cc"]
        return passed_marks.key_of(tree, [command.format(tree=tree)], files)

    def checkout(self, name):
        self.write(f"{name}/src/a.cc", "int a;\n")
        self.write(f"{name}/build/unity.cxx", f'#include "{self.tree}/{name}/src/a.cc"\n')
        return self.tree / name

    def test_a_second_checkout_uses_the_marks_of_the_first(self):
        passed_marks.add(self.key(self.checkout("first")))
        self.assertTrue(passed_marks.has(self.key(self.checkout("longer/second"))))

    def test_a_changed_byte_name_or_command_has_no_mark(self):
        tree = self.checkout("first")
        passed_marks.add(self.key(tree))
        self.assertFalse(passed_marks.has(self.key(tree, "clang -O1 -I{tree}/src a.cc")))
        self.write("first/src/a.cc", "int b;\n")
        self.assertFalse(passed_marks.has(self.key(tree)))
        other = passed_marks.key_of(tree, [], [tree / "src/a.cc"])
        shutil.move(tree / "src/a.cc", tree / "src/b.cc")
        self.assertNotEqual(other, passed_marks.key_of(tree, [], [tree / "src/b.cc"]))

    def test_marks_unused_for_a_month_are_removed(self):
        for key, days in (("old", 31), ("used", 31), ("new", 29)):
            passed_marks.add(key)
            then = time.time() - days * 24 * 3600
            os.utime(passed_marks.folder() / key, (then, then))
        self.assertTrue(passed_marks.has("used"))
        passed_marks.prune()
        self.assertEqual(sorted(mark.name for mark in passed_marks.folder().iterdir()), ["new", "used"])

    def test_a_relative_cache_folder_is_ignored(self):
        with mock.patch.dict(os.environ, XDG_CACHE_HOME="cache", HOME=str(self.tree)):
            self.assertEqual(passed_marks.folder(), self.tree / ".cache/somato/clang-tidy")


if __name__ == "__main__":
    unittest.main()
