#include "base/tables/csv_table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "base/tables/csv_dialect.h"
#include "base/tables/csv_header.h"
#include "base/tables/csv_number.h"
#include "base/tables/csv_text.h"
#include "base/text/flag_hint.h"
#include "base/text/number_of_text.h"
#include "base/text/text.h"
#include "somato/core/check.h"
#include "somato/core/value.h"

namespace somato {
namespace {

std::optional<std::size_t> number_from_one(const std::string& text) {
  const auto number = number_of_text<std::size_t>(text);
  return number && *number > 0 ? std::optional(*number - 1) : std::nullopt;
}

// Single precision is sufficient for numbers with few digits.
double exact_number(std::string_view field, DecimalMark decimal, float rounded) {
  constexpr std::size_t kFewDigits = 7;
  return field.size() <= kFewDigits ? double{rounded}
                                    : read_csv_number<double>(field, decimal).number;
}

// The header that pandas writes for columns without names: an empty field for the index, 0, 1, 2.
bool numbers_columns(const std::vector<CsvField>& fields) {
  if (fields.size() < 2 || !fields[0].text.empty()) return false;
  for (std::size_t i = 1; i < fields.size(); ++i) {
    if (fields[i].text != std::to_string(i - 1)) return false;
  }
  return true;
}

}  // namespace

Result<void> CsvTableReader::begin() {
  return begin_csv(records_, options_.decimal, options_.separator, fields_)
      .map([&](char separator) { separator_ = separator; })
      .and_then([&] { return read_first_record(); })
      .and_then([&]() -> Result<void> { return fields_.empty() ? no_rows() : Result<void>(); });
}

Result<void> CsvTableReader::skip_to(std::size_t begin) {
  while (!fields_.empty() && start().place < begin) {
    SOMATO_TRY_VOID(next());
    is_first_row_ = false;
  }
  return {};
}

Result<void> CsvTableReader::continue_with(CsvRecords records) {
  records_ = std::move(records);
  precision_ = ColumnPrecision(columns_.scales);
  return next();
}

Result<NumberTable> CsvTableReader::rows(std::size_t most) {
  std::vector<float> values;
  NumberTable table;
  std::size_t count = 0;
  for (; count < most && has_row(); ++count) {
    Result<void> read = read_row(values, table.labels).and_then([&] { return next(); });
    if (!read) return fail(std::move(read.error()));
  }
  table.values = Matrix<float>(count, columns_.features.size(), std::move(values));
  if (has_row()) return table;
  if (!trusts_precision_) columns_.rounded = precision_.notes(columns_.names);
  return precision_.check(columns_.names, where_).map([&] { return std::move(table); });
}

bool CsvTableReader::seems_header() const {
  if (numbers_columns(fields_)) return true;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (is_label(i) || leaves_out_number(options_.columns, i)) continue;
    const std::string& text = fields_[i].text;
    if (fields_[i].quoted || (is_csv_text(text) && !has_decimal_comma(text))) return true;
  }
  return false;
}

// A name counts only in a header; a number may point at a label column before it is known
// whether there is one.
Result<void> CsvTableReader::find_label_column() {
  const std::string& wanted = options_.label_column;
  if (wanted.empty()) return {};
  const std::vector<std::string> names = names_in_header(fields_);
  const auto named = std::find(names.begin(), names.end(), wanted);
  const std::optional<std::size_t> number = number_from_one(wanted);
  const bool is_number = number && *number < columns_.width;
  if (named != names.end() && options_.header.value_or(true) && !is_number) {
    if (std::count(named, names.end(), wanted) > 1) {
      return fail(ErrorKind::kUsage, fmt::format("two columns are named {}", shown(wanted)), where_,
                  "rename one of them, or use the number of the column");
    }
    columns_.label = static_cast<std::size_t>(named - names.begin());
    named_label_ = true;
  } else if (is_number) {
    columns_.label = number;
  } else {
    return fail(
        ErrorKind::kUsage, fmt::format("there is no column {}", shown(wanted)), where_,
        number ? fmt::format("there are {} columns", columns_.width) : name_advice(wanted, names));
  }
  return {};
}

Result<void> CsvTableReader::choose() {
  return choose_columns(options_.columns, columns_, where_).map([&](TableColumns&& chosen) {
    columns_ = std::move(chosen);
    precision_ = ColumnPrecision(columns_.scales);
  });
}

Result<void> CsvTableReader::read_first_record() {
  columns_.width = fields_.size();
  if (fields_.empty()) return no_rows();
  SOMATO_TRY_VOID(find_label_column());
  const bool header = options_.header.value_or(named_label_ || seems_header());
  if (!header) return choose();
  columns_.names = names_in_header(fields_);
  return choose().and_then([&] { return next(); });
}

Result<void> CsvTableReader::read_row(std::vector<float>& values,
                                      std::vector<std::string>& labels) {
  if (fields_.size() != columns_.width) {
    return fail(wrong_number_of_fields(
        fields_, columns_.width, is_first_row_ && !columns_.names.empty(),
        records_.line_place(fields_[0]), "give every row the same number of fields"));
  }
  const std::size_t start = values.size();
  values.resize(start + columns_.features.size());
  for (std::size_t i = 0; i < columns_.features.size(); ++i) {
    Result<void> read = read_value(columns_.features[i], values[start + i]);
    if (!read) return read;
  }
  is_first_row_ = false;
  return columns_.label ? read_label(fields_[*columns_.label], labels) : Result<void>();
}

Result<void> CsvTableReader::read_label(const CsvField& field,
                                        std::vector<std::string>& labels) const {
  if (field.text.empty() && !options_.keeps_empty_labels) {
    return fail(ErrorKind::kData, "the label is empty", records_.place(field),
                "give every row a label");
  }
  labels.push_back(unguarded_text(field.text));
  return {};
}

Result<void> CsvTableReader::read_value(std::size_t column, float& value) {
  const CsvField& field = fields_[column];
  const auto reading = read_csv_number<float>(field.text, options_.decimal);
  if (reading.meaning == CsvMeaning::kMissing && options_.keeps_missing) {
    value = std::numeric_limits<float>::quiet_NaN();
    return {};
  }
  if (reading.meaning != CsvMeaning::kNumber) return fail(no_number(column, reading.meaning));
  value = reading.number;
  const bool moved = without_offset(columns_, column, 0.0) != 0.0;
  if (trusts_precision_ && !moved) return {};
  double exact = moved ? read_csv_number<double>(field.text, options_.decimal).number
                       : exact_number(field.text, options_.decimal, value);
  exact = without_offset(columns_, column, exact);
  if (moved) value = static_cast<float>(exact);
  if (!trusts_precision_) precision_.take(column, exact, value);
  return {};
}

Error CsvTableReader::no_number(std::size_t column, CsvMeaning meaning) const {
  const CsvField& field = fields_[column];
  const std::string advice = meaning == CsvMeaning::kText ? advice_for_text() : std::string();
  Error error =
      no_csv_number(field, meaning, options_.decimal, records_.place(field), advice).value();
  const bool ends_row = field.text.empty() && column + 1 == columns_.width && column > 0;
  if (ends_row && is_first_row_ && columns_.names.empty()) {
    error.advice = fmt::format(
        "if a separator ends every line, skip the last column{}, or remove the separator",
        flag_hint("skip", std::to_string(columns_.width)));
    return error;
  }
  if (meaning == CsvMeaning::kMissing) {
    error.advice = "leave the row out, fill in a number, or keep missing values" +
                   flag_hint("missing", "mean or nearest");
  }
  return error;
}

// Text in the first row is the type of a column, later it is an error.
std::string CsvTableReader::advice_for_text() const {
  std::vector<std::string> columns;
  for (const std::size_t i : columns_.features) {
    if (!is_first_row_ ||
        read_csv_number<float>(fields_[i].text, options_.decimal).meaning != CsvMeaning::kText) {
      continue;
    }
    columns.push_back(columns_.names.empty() ? std::to_string(i + 1) : columns_.names[i]);
  }
  if (columns_.names.empty() || columns.empty()) {
    return "correct it, use the column for labels, or skip it" + flag_hint("skip");
  }
  const std::string list = fmt::format("{}", fmt::join(columns, ","));
  return fmt::format(
      "{}: use the labels as label column{}, and skip others: {}{}",
      columns.size() == 1 ? "the column contains text" : "these columns contain text",
      flag_hint("label-column"), list, flag_hint("skip", "'" + list + "'"));
}

Result<void> CsvTableReader::no_rows() const {
  return fail(ErrorKind::kData, "there are no rows of numbers", where_,
              "check that it is the right file");
}

}  // namespace somato
