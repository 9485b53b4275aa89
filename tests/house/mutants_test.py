import unittest

from support import TreeTest

import mutants


class Mutants(TreeTest):
    def changed_lines(self, text):
        """The line of `text` after each mutation of it."""
        file = self.write("a.cc", text)
        return sorted(mutant.text() for mutant in mutants.of_file(file))

    def test_changes_operators_between_blanks(self):
        self.assertEqual(self.changed_lines("  if (a <= b && !c) {"),
                         sorted(["  if (a < b && !c) {", "  if (a <= b || !c) {"]))
        self.assertEqual(self.changed_lines("  if (!c) {"), ["  if (c) {"])

    def test_changes_constants(self):
        self.assertEqual(self.changed_lines("  f(x3, 7,"), ["  f(x3, 8,"])
        self.assertEqual(self.changed_lines("  g(0.5,"), ["  g((0.5 * 2 + 1),"])
        self.assertEqual(self.changed_lines("  bool x{true};"), ["  bool x{false};"])

    def test_leaves_out_statements_but_not_declarations(self):
        self.assertEqual(self.changed_lines("  values.clear();"), ["  ;"])
        self.assertEqual(self.changed_lines("  x.y = z;"), ["  ;"])
        self.assertEqual(self.changed_lines("  return x;"), [])
        self.assertEqual(self.changed_lines("  const auto x = y;"), [])
        self.assertEqual(self.changed_lines("  f([&] {"), [])

    def test_spares_texts_comments_and_directives(self):
        for text in ('  g("a < 1"', "// 3 < 4", "#if A > 3", "  /* 1 */", "R\"(1 < 2)\""):
            self.assertEqual(self.changed_lines(text), [], text)

    def test_names_its_place(self):
        file = self.write("src/maps/a.cc", "\n\n  return a < b;\n")
        mutants.TREE = self.tree
        self.assertEqual([str(mutant) for mutant in mutants.of_file(file)],
                         ["src/maps/a.cc:3: < -> <="])


if __name__ == "__main__":
    unittest.main()
