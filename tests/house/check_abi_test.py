import contextlib
import io
import shutil
import subprocess
import sys
import unittest
from unittest import mock

from support import TreeTest

import check_abi

HEADER = """
namespace somato {
struct Answer {
  int winner;
  double distance;
};
enum class Kind { kOne, kTwo };
Answer nearest(Kind kind);
void forget();
}
"""
SOURCE = """
#include "somato/maps/answer.h"
namespace somato {
Answer nearest(Kind kind) { return {static_cast<int>(kind), 0.0}; }
void forget() {}
}
"""


@unittest.skipUnless(shutil.which("abidw"), "abigail-tools is not installed")
class CheckAbi(TreeTest):
    def setUp(self):
        super().setUp()
        (self.tree / "abi").mkdir()
        self.assertEqual(self.check(HEADER, SOURCE, "--update")[0], 0)

    def check(self, header, source, *flags):
        self.write("include/somato/maps/answer.h", header)
        path = self.write("answer.cc", source)
        library = self.tree / "libsomato.so"
        subprocess.run(["g++", "-std=c++20", "-fPIC", "-shared", "-I", self.tree / "include", path, "-o", library], check=True)
        printed = io.StringIO()
        words = ["check_abi.py", str(library), "--tree", str(self.tree), *flags]
        with mock.patch.object(sys, "argv", words), contextlib.redirect_stdout(printed):
            status = check_abi.main()
        return status, printed.getvalue()

    def changed(self, text, old, new):
        self.assertIn(old, text)
        return text.replace(old, new)

    def test_the_same_tree_is_compatible(self):
        status, printed = self.check(HEADER, SOURCE)
        self.assertEqual(status, 0)
        self.assertIn("2 types and the exported symbols are compatible with 1.0", printed)

    def test_a_removed_function_is_reported(self):
        status, printed = self.check(self.changed(HEADER, "void forget();\n", ""), self.changed(SOURCE, "void forget() {}", ""))
        self.assertEqual(status, 1)
        self.assertIn("_ZN6somato6forgetEv", printed)

    def test_a_changed_argument_is_reported(self):
        status, printed = self.check(self.changed(HEADER, "forget()", "forget(int)"), self.changed(SOURCE, "forget()", "forget(int)"))
        self.assertEqual(status, 1)
        self.assertIn("_ZN6somato6forgetEv", printed)

    def test_an_added_member_is_reported(self):
        status, printed = self.check(self.changed(HEADER, "  double distance;\n", "  double distance;\n  int row;\n"), SOURCE)
        self.assertEqual(status, 1)
        self.assertIn("somato::Answer: '128 bits' became '192 bits; 128 row int'", printed)

    def test_a_member_of_another_type_of_the_same_size_is_reported(self):
        self.assertIn("0 winner unsigned int", self.check(self.changed(HEADER, "int winner", "unsigned winner"), SOURCE)[1])

    def test_another_value_of_a_constant_is_reported(self):
        self.assertIn("kTwo = 1' became", self.check(self.changed(HEADER, "kTwo", "kNone, kTwo"), SOURCE)[1])

    def test_an_addition_is_compatible(self):
        header = self.changed(HEADER, "void forget();\n", "void forget();\nstruct Other {\n  int a;\n};\nint more(Other other);\n")
        source = self.changed(SOURCE, "void forget() {}", "void forget() {}\nint more(Other other) { return other.a; }")
        self.assertEqual(self.check(header, source)[0], 0)


if __name__ == "__main__":
    unittest.main()
