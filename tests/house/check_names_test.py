import unittest

from support import TreeTest

import check_names


def source(*lines, inside="somato"):
    return "\n".join([f"namespace {inside} {{", "namespace {", *lines, "}  // namespace", "}"])


class Names(TreeTest):
    def problems(self, first, second, second_path="src/maps/som/second.cc"):
        self.write_rooms()
        self.write("src/maps/grid/first.cc", first)
        self.write(second_path, second)
        return check_names.check(self.tree)

    def test_equal_names_are_refused(self):
        for line in ("constexpr double kGain = 0.5;", "constexpr int kSizes[] = {1, 2};", "const Text kHand{1};",
                     "const Text kText = of(1);", "struct Reading { int kept; };", "class Reader : public Base {};",
                     "enum class Side { kLeft };", "template <typename T>\nT sum(const std::vector<T>& all) { return {}; }",
                     "Result<void> check(const Text& text = {},\n  std::size_t from = 0) {}", "TEST(Part, Works) {}",
                     "TEST_F(Part, Works) {}", 'constexpr const char* kUsage = R"(")";'):
            with self.subTest(line):
                problems = self.problems(source(line), source("int other();", line))
                self.assertEqual(len(problems), 1, problems)
                self.assertIn(f"src/maps/som/second.cc:4: '", problems[0])
                self.assertIn("is also in the anonymous namespace of src/maps/grid/first.cc", problems[0])

    def test_names_that_do_not_meet(self):
        line = "constexpr double kGain = 0.5;"
        for first, second, path in (
                (source(line), source(line), "src/base/core/second.cc"),
                (source(line), source(line), "tests/maps/som/second_test.cc"),
                (source(line), source(line, inside="somato::svg"), "src/maps/som/second.cc"),
                (source(line), "namespace somato {\nconstexpr double kGain = 0.5;\n}", "src/maps/som/second.cc"),
                (source(line), source(f"void f() {{\n{line}\n}}"), "src/maps/som/second.cc"),
                (source(line), source(f"struct A {{ {line} }};"), "src/maps/som/second.cc"),
                (source(line), source(f"// {line}", f'const char* kText = "{line}";'), "src/maps/som/second.cc")):
            with self.subTest(second, path=path):
                self.assertEqual(self.problems(first, second, path), [])
                (self.tree / path).unlink()

    def test_functions_of_other_parameters_are_not_equal(self):
        one = "int sum(const Text& text, int from) {}"
        self.assertEqual(self.problems(source(one), source("int sum(const Text& text, double from) {}")), [])
        self.assertEqual(len(self.problems(source(one), source("int sum(const Text& other, int) {}"))), 1)

    def test_an_alias_may_be_repeated_for_the_same_type_only(self):
        one = source("using Json = nlohmann::json;")
        self.assertEqual(self.problems(one, one), [])
        self.assertEqual(len(self.problems(one, source("using Json = nlohmann::ordered_json;"))), 1)

    def test_what_is_declared_before_its_definition_is_one(self):
        self.write_rooms()
        self.write("src/maps/grid/first.cc", source("int sum(int a);", "int sum(int a) { return a; }"))
        self.assertEqual(check_names.check(self.tree), [])


if __name__ == "__main__":
    unittest.main()
