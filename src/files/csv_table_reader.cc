#include "files/csv_table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "files/csv_number.h"
#include "files/text.h"
#include "somato/core/value.h"

namespace somato {
namespace {

Result<float> number_in(const CsvField& field, const std::string& place) {
  const CsvReading<float> reading = read_csv_number<float>(field.text);
  if (reading.meaning == CsvMeaning::kNumber) return reading.number;
  return no_csv_number(field, reading.meaning, place,
                       "correct it, or name the column as the label column");
}

std::optional<std::size_t> number_from_one(const std::string& text) {
  std::size_t number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && stop == text.data() + text.size() && number > 0;
  return whole ? std::optional(number - 1) : std::nullopt;
}

// Single precision holds what few digits say as well as it need be.
double exact_number(std::string_view field, float rounded) {
  constexpr std::size_t kFewDigits = 7;
  return field.size() <= kFewDigits ? double{rounded} : read_csv_number<double>(field).number;
}

}  // namespace

Result<void> CsvTableReader::begin() {
  separator_ = options_.separator ? *options_.separator : records_.guess_separator();
  return next().and_then([&] { return read_first_record(); }).and_then([&]() -> Result<void> {
    return fields_.empty() ? no_rows() : Result<void>();
  });
}

Result<NumberTable> CsvTableReader::rows(std::size_t most) {
  std::vector<float> values;
  NumberTable table;
  std::size_t count = 0;
  for (; count < most && !fields_.empty(); ++count) {
    Result<void> read = read_row(values, table.labels).and_then([&] { return next(); });
    if (!read) return fail(std::move(read.error()));
  }
  table.values = Matrix<float>(count, columns(), std::move(values));
  if (!fields_.empty()) return table;
  return precision_.check(names_, where_).map([&] { return std::move(table); });
}

bool CsvTableReader::seems_header() const {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (is_label(i)) continue;
    if (fields_[i].quoted || is_csv_text(fields_[i].text)) return true;
  }
  return false;
}

// A name counts only in a header; a number may point at a label column before it is known
// whether there is one.
Result<void> CsvTableReader::find_label_column() {
  const std::string& wanted = options_.label_column;
  if (wanted.empty()) return {};
  std::vector<std::string> names;
  names.reserve(fields_.size());
  for (const CsvField& field : fields_) names.push_back(field.text);
  const auto named = std::find(names.begin(), names.end(), wanted);
  const std::optional<std::size_t> number = number_from_one(wanted);
  const bool is_number = number && *number < width_;
  if (named != names.end() && options_.header.value_or(true) && !is_number) {
    label_ = static_cast<std::size_t>(named - names.begin());
    named_label_ = true;
  } else if (is_number) {
    label_ = number;
  } else {
    return fail(ErrorKind::kUsage, fmt::format("there is no column {}", shown(wanted)), where_,
                number ? fmt::format("there are {} columns", width_) : name_advice(wanted, names));
  }
  return {};
}

Result<void> CsvTableReader::read_first_record() {
  width_ = fields_.size();
  if (width_ == 0) return no_rows();
  if (Result<void> found = find_label_column(); !found) return found;
  if (width_ == (label_ ? 1u : 0u)) {
    return fail(ErrorKind::kData, "there is no column of numbers", where_,
                "check the separator and the label column");
  }
  const bool header = options_.header.value_or(named_label_ || seems_header());
  if (!header) return {};
  for (std::size_t i = 0; i < width_; ++i) {
    if (!is_label(i)) names_.push_back(fields_[i].text);
  }
  return next();
}

Result<void> CsvTableReader::read_row(std::vector<float>& values,
                                      std::vector<std::string>& labels) {
  if (fields_.size() != width_) {
    return fail(
        ErrorKind::kData, fmt::format("expected {} fields, found {}", width_, fields_.size()),
        fmt::format("{}:{}", where_, fields_[0].line), "give every row the same number of fields");
  }
  std::size_t column = 0;
  for (std::size_t i = 0; i < width_; ++i) {
    Result<void> read =
        is_label(i) ? read_label(fields_[i], labels) : read_value(fields_[i], column++, values);
    if (!read) return read;
  }
  return {};
}

Result<void> CsvTableReader::read_label(const CsvField& field,
                                        std::vector<std::string>& labels) const {
  if (field.text.empty()) {
    return fail(ErrorKind::kData, "the label is empty", records_.place(field),
                "give every row a label");
  }
  labels.push_back(field.text);
  return {};
}

Result<void> CsvTableReader::read_value(const CsvField& field, std::size_t column,
                                        std::vector<float>& values) {
  return number_in(field, records_.place(field)).map([&](float value) {
    values.push_back(value);
    if (trusts_precision_) return;
    precision_.take(column, exact_number(field.text, value), value);
  });
}

Result<void> CsvTableReader::no_rows() const {
  return fail(ErrorKind::kData, "there are no rows of numbers", where_,
              "check that it is the right file");
}

}  // namespace somato
