"""Tests of scripts/release/exported_symbols.py."""

import unittest

from support import TREE

import exported_symbols

HEADER = """
#ifndef SOMATO_X_H  // class Not;
#include "somato/y.h"
namespace somato {
class Mentioned;
/// class Commented { };
struct Point { double x = 0; void hidden(); };
template <typename T, typename = Matrix<T>>
class [[nodiscard]] Table final : public Base<T> {
 public:
  class Row { int y; };
  Table() { if (true) { return; } }
};
enum class Kind { kA, kB };
using Alias = Table<int>;
inline constexpr int kMost = 3;
constexpr double kShare{0.5};
[[nodiscard]] Result<std::vector<Point>> read(const std::string& path = "a;b{", char mark = '}');
template <typename T>
bool is_valid(const T& value) {
  return value > 0;
}
bool operator==(const Point& a, const Point& b);
extern const char* const kName;
namespace detail {
Result<void> check(int n);
}  // namespace detail
}  // namespace somato
namespace somato::live {
void watch();
}
extern "C" {
typedef struct somato_system somato_system;
typedef enum somato_status { SOMATO_OK = 0 } somato_status;
const char* somato_version(void);
}
#endif
"""
NAMES = {"somato::Point", "somato::Table", "somato::Kind", "somato::kMost", "somato::kShare", "somato::read",
         "somato::is_valid", "somato::operator", "somato::kName", "somato::detail::check", "somato::live::watch",
         "somato_version"}


class ExportedSymbols(unittest.TestCase):
    def test_the_names_of_a_header_are_those_of_its_types_functions_and_variables(self):
        self.assertEqual(exported_symbols.declared_names(HEADER), NAMES)

    def test_the_interface_of_c_is_its_functions(self):
        text = (TREE / "include/somato/c/c_system.h").read_text(encoding="utf-8")
        names = exported_symbols.declared_names(text)
        self.assertIn("somato_load", names)
        self.assertTrue(all(name.startswith("somato_") and f"{name}(" in text for name in names), names)

    def test_symbols_of_declared_names_are_exported(self):
        for symbol in ["somato::Point::hidden()", "somato::read(std::string const&, char)",
                       "tl::expected<void, somato::Error> somato::is_valid<int>(int const&)",
                       "vtable for somato::Table<int>", "typeinfo name for somato::Table<int>::Row",
                       "non-virtual thunk to somato::Table<int>::~Table()", "somato::kName[abi:cxx11]",
                       "guard variable for somato::detail::check(int)::seen", "somato_version",
                       "somato::operator==(somato::Point const&, somato::Point const&)",
                       "somato::Point::operator()(int) const", "somato::Point::operator<(int) const"]:
            self.assertTrue(exported_symbols.is_declared(symbol, NAMES), symbol)

    def test_all_others_are_hidden(self):
        for symbol in ["somato::Mentioned::Mentioned()", "somato::Commented::f()", "somato::check(int)",
                       "somato::reader(somato::Point)", "std::vector<somato::Point>::push_back(somato::Point const&)",
                       "typeinfo for std::function<void (somato::Point)>", "somato::live::other()",
                       "somato::(anonymous namespace)::read()", "tl::expected<somato::Point>::value()", "read",
                       "_ZN6somato4Oddly4mangledE"]:
            self.assertFalse(exported_symbols.is_declared(symbol, NAMES), symbol)

    def test_the_version_script_hides_by_default(self):
        self.assertEqual(exported_symbols.version_script(["a", "b"], "SOMATO_1"),
                         "SOMATO_1 {\n  global:\n    a;\n    b;\n  local:\n    *;\n};\n")


if __name__ == "__main__":
    unittest.main()
