import unittest

from support import TreeTest

import recipes

PAGE = """# A part

Tests: `./dev test base/core program`

```diff
diff --git a/src/part.cc b/src/part.cc
new file mode 100644
--- /dev/null
+++ b/src/part.cc
@@ -0,0 +1 @@
+int part();
```

```diff
diff --git a/src/list.cc b/src/list.cc
--- a/src/list.cc
+++ b/src/list.cc
@@ -1,2 +1,3 @@
 first
+part
 last
```
"""


class Recipes(TreeTest):
    def setUp(self):
        super().setUp()
        self.write("docs/recipes/README.md", "# Recipes\n")
        self.write("docs/recipes/part.md", PAGE)
        self.write("src/list.cc", "first\nlast\n")

    def test_changes_that_apply(self):
        self.assertEqual(recipes.check(self.tree), [])
        recipe = recipes.read(self.tree)[0]
        self.assertEqual((recipe.name, recipe.tests, recipe.places()), ("part", ("base/core", "program"), 3))
        self.assertEqual(recipes.apply(recipe.patch, self.tree), "")
        self.assertEqual((self.tree / "src/list.cc").read_text(encoding="utf-8"), "first\npart\nlast\n")
        self.assertEqual((self.tree / "src/part.cc").read_text(encoding="utf-8"), "int part();\n")

    def test_changes_of_a_file_that_is_gone_or_another(self):
        for text in (None, "other\nlines\n"):
            with self.subTest(text):
                self.write("src/list.cc", text or "")
                if text is None:
                    (self.tree / "src/list.cc").unlink()
                problems = recipes.check(self.tree)
                self.assertEqual(len(problems), 1)
                self.assertIn("docs/recipes/part.md: its changes do not apply", problems[0])
                self.assertIn("src/list.cc", problems[0])

    def test_a_page_without_changes_or_tests(self):
        self.write("docs/recipes/part.md", PAGE.replace("Tests: ", ""))
        self.assertIn("no line 'Tests:", recipes.check(self.tree)[0])

    def test_too_many_places(self):
        more = "".join(f"+++ b/src/part{number}.h\n" for number in range(4))
        self.write("docs/recipes/part.md", PAGE.replace("+++ b/src/part.cc\n", f"+++ b/src/part.cc\n{more}"))
        self.assertIn("it touches 7 places; at most 6", recipes.check(self.tree)[0])

    def test_a_header_with_its_source_is_one_place_and_a_page_none(self):
        patch = "+++ b/src/part.h\n+++ b/src/part.cc\n+++ b/docs/reference/modules.md\n"
        self.assertEqual(recipes.Recipe("part", patch, ()).places(), 2)


if __name__ == "__main__":
    unittest.main()
