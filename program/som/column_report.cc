#include "som/column_report.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "terminal/terminal.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

std::string name_of(const TableColumns& table, std::size_t column) {
  return table.names.empty() ? std::to_string(column + 1) : printable(table.names[column]);
}

// The successor of a name that ends in a number, such as tax_10 of tax_9; empty for others.
std::string next_name(const std::string& name) {
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  constexpr std::size_t kMostDigits = 15;
  if (digits == name.size() || name.size() - digits > kMostDigits) return {};
  const std::string number = name.substr(digits);
  return name.substr(0, digits) + fmt::format("{:0{}}", std::stoull(number) + 1, number.size());
}

// Values that training leaves out are not filled.
std::string filled(const RowData& rows) {
  return fmt::format("{} {} in {} ({})",
                     rows.missing == MissingFill::kLeaveOut ? "missing" : "filled",
                     counted(rows.known.missing(), "value"),
                     counted(rows.known.incomplete(), "row"), choice_name(rows.missing));
}

}  // namespace

std::string listed_columns(const TableColumns& table, const std::vector<std::size_t>& columns) {
  constexpr std::size_t kRun = 3;
  std::string text;
  for (std::size_t i = 0; i < columns.size();) {
    std::size_t end = i + 1;
    while (end < columns.size() &&
           name_of(table, columns[end]) == next_name(name_of(table, columns[end - 1]))) {
      ++end;
    }
    if (end - i < kRun) end = i + 1;
    text += (text.empty() ? "" : ", ") + name_of(table, columns[i]);
    if (end > i + 1) text += ".." + name_of(table, columns[end - 1]);
    i = end;
  }
  return text;
}

std::string columns_and_filled(const RowData& rows) {
  const TableColumns& table = rows.columns;
  std::string text = fmt::format("features {}\n", listed_columns(table, table.features));
  if (table.label) text += fmt::format("label {}\n", name_of(table, *table.label));
  const std::vector<std::size_t> left_out = table.left_out();
  if (!left_out.empty()) text += fmt::format("left_out {}\n", listed_columns(table, left_out));
  if (rows.known.missing() > 0) text += filled(rows) + "\n";
  return text;
}

void note_columns_and_filled(const RowData& rows) {
  if (is_quiet()) return;
  const std::string path = printable(rows.path);
  const std::vector<std::size_t> left_out = rows.columns.left_out();
  if (!left_out.empty()) {
    fmt::print(stderr, "somato: {}: left out {}\n", path, listed_columns(rows.columns, left_out));
  }
  if (rows.known.missing() > 0) fmt::print(stderr, "somato: {}: {}\n", path, filled(rows));
}

void note_rounded(const RowData& rows) {
  if (is_quiet()) return;
  for (const std::string& column : rows.rounded) {
    fmt::print(stderr,
               "somato: {}: {}; train the map with --standardize, which subtracts the mean before "
               "rounding, or subtract an offset\n",
               printable(rows.path), printable(column));
  }
}

}  // namespace somato::program
