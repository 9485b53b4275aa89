import unittest

from support import TreeTest

import check_text


class Text(TreeTest):
    def problems(self, name, text):
        self.write(name, text)
        return check_text.check(self.tree, [name])

    def test_refuses_functions_with_other_bits_elsewhere(self):
        for call in ("std::exp(x)", "std::pow(a, b)", "std::shuffle(a, b, c)", "rand()", "expf(x)",
                     "std::uniform_int_distribution<int> d;", "std::normal_distribution<> d;"):
            self.assertEqual(len(self.problems("src/maps/a.cc", f"x = {call};\n")), 1, call)

    def test_says_where(self):
        self.assertEqual(self.problems("include/somato/maps/a.h", "int a;\nauto b = std::log(a);\n"), [
            "include/somato/maps/a.h:2: 'std::log' differs between machines; see STYLE.md"])

    def test_passes_our_own_functions_words_and_tests(self):
        self.assertEqual(self.problems("src/maps/a.cc", "y = exponential(x); // std::exp(x)\n"
                                       'what = "std::exp";\nauto e = std::expected(x);\n'
                                       "z = random.sample(x) + map.log(y) + operand(x);\n"), [])
        self.assertEqual(self.problems("tests/core/a_test.cc", "y = std::exp(x);\n"), [])

    def test_passes_them_where_bits_are_not_promised(self):
        name = next(iter(check_text.MAY_ROUND))
        self.assertEqual(self.problems(name, "x = std::tan(y);\n"), [])

    def test_refuses_prints_of_the_library(self):
        self.assertEqual(len(self.problems("src/maps/a.cc", "std::cout << 1;\n")), 1)
        self.assertEqual(self.problems("program/main.cc", "std::cout << 1;\n"), [])

    def test_refuses_flags_of_the_program_in_messages_of_the_library(self):
        message = 'fail(kind, "there is no name", "use --skip 1");\n'
        self.assertEqual(len(self.problems("src/base/tables/a.cc", message)), 1)
        self.assertEqual(self.problems("src/recordings/bags/a.cc", message), [], "only the program reads bags")
        self.assertEqual(self.problems("program/som/a.cc", message), [])
        self.assertEqual(self.problems("src/base/tables/a.cc", 'flag_hint("skip");  // "--skip"\ni--;\n'), [])

    def test_refuses_checks_under_conditions_without_braces(self):
        for line in ("  if (named) EXPECT_EQ(a, b);", "} else if (f(a)) ASSERT_TRUE(b) << c;"):
            self.assertEqual(len(self.problems("tests/maps/a_test.cc", line + "\n")), 1, line)
        self.assertEqual(self.problems("tests/maps/a_test.cc", "  if (named) {\n    EXPECT_EQ(a, b);\n  }\n"
                                       "  // if (a) EXPECT_EQ(b, c);\n  for (int i : all) EXPECT_GT(i, 0);\n"), [])

    def test_refuses_flags_that_change_bits(self):
        self.assertEqual(len(self.problems("CMakeLists.txt", "add_compile_options(-ffast-math)\n")), 1)

    def test_refuses_places_of_one_machine(self):
        for place in ("/tmp/a", "cd /root/b", '"/home/me/c"', "/work/d"):
            self.assertEqual(len(self.problems("docs/a.md", place + "\n")), 1, place)
        for place in ("build/tmp/a", "${x}/tmp/a", "http://example.org/work/a", "./tmp/a"):
            self.assertEqual(self.problems("docs/a.md", place + "\n"), [], place)

    def test_refuses_wording_that_reads_as_translated(self):
        for words in ("Whoever reads this", "the classes are told apart", "nobody knows", "one map alone",
                      "asked_files(names)", "the body goes on"):
            self.assertEqual(len(self.problems("docs/a.md", words + "\n")), 1, words)
        self.assertEqual(self.problems("docs/a.md", "The map separates the classes; `asked` is a key.\n"), [])

    def test_refuses_comments_that_begin_with_a_fragment(self):
        for comment in ("// What the map learns.", "int a;  ///< Of the last row.", "/** Of a frame. */"):
            self.assertEqual(len(self.problems("src/maps/a.h", comment + "\n")), 1, comment)
        for comment in ("// The samples of the map.", "// Office hours.", "// What if it fails?"):
            self.assertEqual(self.problems("src/maps/a.h", comment + "\n"), [], comment)

    def test_notes_long_files(self):
        self.write("src/maps/a.cc", "\n" * 401)
        self.write("src/maps/b.cc", "\n" * 400)
        self.assertEqual(len(list(check_text.long_files(self.tree, ["src/maps/a.cc", "src/maps/b.cc"]))), 1)

    def test_refuses_links_to_files_that_are_gone(self):
        self.write("docs/a.md", "[a](b.md#part) [b](../src/c.cc) [c](https://example.org/d) [d](#here)\n\n```diff\n+[](auto d)\n```\n")
        self.write("src/c.cc")
        self.assertEqual(check_text.check(self.tree, ["docs/a.md"]), ["docs/a.md: the link 'b.md' leads to no file"])
        self.write("docs/b.md")
        self.assertEqual(check_text.check(self.tree, ["docs/a.md"]), [])


if __name__ == "__main__":
    unittest.main()
