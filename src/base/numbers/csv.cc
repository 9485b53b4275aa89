#include "somato/files/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/files/whole_file.h"
#include "base/numbers/whole_table.h"
#include "base/tables/csv_number.h"
#include "base/tables/csv_text.h"
#include "base/text/text.h"
#include "somato/core/check.h"

namespace somato {
namespace {

bool needs_no_quotes(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_' ||
         c == '-' || c == '.';
}

// As a field that parse_csv() can read.
std::string written(const std::string& text) {
  require(is_utf8(text) && text.find('\0') == std::string::npos, "a text is not UTF-8");
  return csv_field(text);
}

void append_header(std::string& out, const NumberTable& table) {
  for (const std::string& name : table.names) {
    if (&name != &table.names[0]) out += ',';
    out += written(name);
  }
  if (!table.labels.empty()) out += ",label";
  out += '\n';
}

void append_row(std::string& out, const NumberTable& table, std::size_t row) {
  const std::span<const float> values = table.values.row(row);
  for (std::size_t i = 0; i < values.size(); ++i) {
    require(std::isfinite(values[i]), "a value is not finite");
    fmt::format_to(std::back_inserter(out), "{}{}", i > 0 ? "," : "", values[i]);
  }
  if (!table.labels.empty()) {
    require(!table.labels[row].empty(), "a label is empty");
    out += ',';
    out += written(table.labels[row]);
  }
  out += '\n';
}

bool is_known_separator(char c) {
  return c == ',' || c == ';' || c == '\t' || c == ' ';
}

bool sizes_match(const NumberTable& table) {
  const Matrix<float>& values = table.values;
  return !values.empty() && (table.names.empty() || table.names.size() == values.columns()) &&
         (table.labels.empty() || table.labels.size() == values.rows());
}

}  // namespace

const std::vector<std::pair<DecimalMark, std::string>>& Choices<DecimalMark>::all() {
  static const std::vector<std::pair<DecimalMark, std::string>> choices{
      {DecimalMark::kPoint, "point"}, {DecimalMark::kComma, "comma"}};
  return choices;
}

Result<NumberTable> parse_csv(std::string_view text, std::string_view where,
                              const CsvOptions& options) {
  require(!options.separator || is_known_separator(*options.separator),
          "a separator is a comma, a semicolon, a tab or a space");
  return csv_table(text, where, options).map([](WholeTable&& whole) {
    return std::move(whole.table);
  });
}

Result<NumberTable> read_csv(const std::string& path, const CsvOptions& options) {
  return read_whole(path).and_then(
      [&](const std::string& bytes) { return parse_csv(bytes, path, options); });
}

std::string csv_field(const std::string& value) {
  std::string text = guarded_text(value);
  const bool plain = std::all_of(text.begin(), text.end(), needs_no_quotes);
  if (plain && is_csv_text(text)) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string format_csv(const NumberTable& table) {
  require(sizes_match(table), "a table needs values, one name per column and one label per row");
  std::string out;
  if (!table.names.empty()) append_header(out, table);
  for (std::size_t row = 0; row < table.values.rows(); ++row) append_row(out, table, row);
  return out;
}

Result<void> write_csv(const std::string& path, const NumberTable& table) {
  return save_whole(path, format_csv(table));
}

}  // namespace somato
