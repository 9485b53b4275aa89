#include "base/tables/csv_text.h"

#include <algorithm>
#include <string_view>

#include "base/tables/csv_number.h"

namespace somato {
namespace {

constexpr char kGuard = '\'';
constexpr std::string_view kFormulaStarts = "=+-@\t\r";

// A number such as -1.5 is the same for a spreadsheet.
bool is_formula(std::string_view text) {
  return !text.empty() && kFormulaStarts.find(text.front()) != std::string_view::npos &&
         read_csv_number<double>(text).meaning != CsvMeaning::kNumber;
}

// Whether the text after its guards is a formula.
bool guards_formula(std::string_view text) {
  return is_formula(text.substr(std::min(text.find_first_not_of(kGuard), text.size())));
}

}  // namespace

std::string guarded_text(std::string text) {
  if (guards_formula(text)) text.insert(text.begin(), kGuard);
  return text;
}

std::string unguarded_text(std::string text) {
  if (text.starts_with(kGuard) && guards_formula(text)) text.erase(0, 1);
  return text;
}

}  // namespace somato
