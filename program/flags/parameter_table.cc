#include "flags/parameter_table.h"

#include <fmt/format.h>

#include <iterator>

namespace somato::program {
namespace {

// A bound that only keeps a number within its type is not shown.
Range range_worth_showing(Range range) {
  constexpr double kAsGoodAsNone = 1e12;
  return range.high < kAsGoodAsNone ? range
                                    : Range{range.low, Range::any().high, range.low_excluded};
}

}  // namespace

std::string markdown_cell(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

std::string permitted_values(const ParameterInfo& info) {
  std::string values = info.choices.empty()
                           ? info.type
                           : fmt::format("{}{}", info.type.starts_with("list") ? "list of " : "",
                                         fmt::join(info.choices, ", "));
  const std::string range = to_string(range_worth_showing(info.range));
  if (!range.empty()) values += ", " + range;
  if (!info.unit.empty()) values += fmt::format(" [{}]", info.unit);
  return values;
}

std::string parameter_table(const std::vector<ParameterInfo>& parameters) {
  std::string page = "| key | values | default | meaning |\n|---|---|---|---|\n";
  for (const ParameterInfo& info : parameters) {
    fmt::format_to(std::back_inserter(page), "| `{}` | {} | `{}` | {} |\n", info.name,
                   markdown_cell(permitted_values(info)), info.default_text,
                   markdown_cell(info.text));
  }
  return page;
}

}  // namespace somato::program
