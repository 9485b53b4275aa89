#include "somato/files/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "files/csv_number.h"
#include "files/csv_records.h"
#include "files/text.h"
#include "somato/core/check.h"
#include "somato/core/value.h"
#include "somato/files/whole_file.h"

namespace somato {
namespace {

bool is_text(std::string_view field) {
  return read_csv_number<float>(field).meaning == CsvMeaning::kText;
}

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

class TableReader {
 public:
  TableReader(std::string_view text, std::string_view where, const CsvOptions& options)
      : records_(text, where), where_(where), options_(options) {}

  Result<NumberTable> read() {
    separator_ = options_.separator ? *options_.separator : records_.guess_separator();
    return next()
        .and_then([&] { return read_first_record(); })
        .and_then([&] { return read_rows(); })
        .and_then([&]() -> Result<NumberTable> {
          const std::size_t columns = width_ - (label_ ? 1 : 0);
          const std::size_t rows = values_.size() / columns;
          table_.values = Matrix<float>(rows, columns, std::move(values_));
          return std::move(table_);
        });
  }

 private:
  Result<void> next() { return records_.next(separator_, fields_); }

  bool is_label(std::size_t column) const { return label_ == column; }

  bool seems_header() const {
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      if (is_label(i)) continue;
      if (fields_[i].quoted || is_text(fields_[i].text)) return true;
    }
    return false;
  }

  // A name counts only in a header; a number may point at a label column before it is known
  // whether there is one.
  Result<void> find_label_column() {
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
      return fail(
          ErrorKind::kUsage, fmt::format("there is no column {}", shown(wanted)), where_,
          number ? fmt::format("there are {} columns", width_) : name_advice(wanted, names));
    }
    return {};
  }

  Result<void> read_first_record() {
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
      if (!is_label(i)) table_.names.push_back(fields_[i].text);
    }
    return next();
  }

  Result<void> read_rows() {
    if (fields_.empty()) return no_rows();
    while (!fields_.empty()) {
      Result<void> read = read_row().and_then([&] { return next(); });
      if (!read) return read;
    }
    return {};
  }

  Result<void> read_row() {
    if (fields_.size() != width_) {
      return fail(ErrorKind::kData,
                  fmt::format("expected {} fields, found {}", width_, fields_.size()),
                  fmt::format("{}:{}", where_, fields_[0].line),
                  "give every row the same number of fields");
    }
    for (std::size_t i = 0; i < width_; ++i) {
      Result<void> read = is_label(i) ? read_label(fields_[i]) : read_value(fields_[i]);
      if (!read) return read;
    }
    return {};
  }

  Result<void> read_label(const CsvField& field) {
    if (field.text.empty()) {
      return fail(ErrorKind::kData, "the label is empty", records_.place(field),
                  "give every row a label");
    }
    table_.labels.push_back(field.text);
    return {};
  }

  Result<void> read_value(const CsvField& field) {
    return number_in(field, records_.place(field)).map([&](float value) {
      values_.push_back(value);
    });
  }

  Result<void> no_rows() const {
    return fail(ErrorKind::kData, "there are no rows of numbers", where_,
                "check that it is the right file");
  }

  CsvRecords records_;
  std::string where_;
  const CsvOptions& options_;
  char separator_ = ',';
  std::vector<CsvField> fields_;
  std::size_t width_ = 0;
  std::optional<std::size_t> label_;
  bool named_label_ = false;
  std::vector<float> values_;
  NumberTable table_;
};

bool is_plain(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_' ||
         c == '-' || c == '.';
}

// As a field that parse_csv() can read again.
std::string written(const std::string& text) {
  require(is_utf8(text) && text.find('\0') == std::string::npos, "a text is not UTF-8");
  return csv_field(text);
}

void append_header(std::string& out, const NumberTable& table) {
  for (const std::string& name : table.names)
    out += (&name != &table.names[0] ? "," : "") + written(name);
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
    out += "," + written(table.labels[row]);
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

Result<NumberTable> parse_csv(std::string_view text, std::string_view where,
                              const CsvOptions& options) {
  require(!options.separator || is_known_separator(*options.separator),
          "a separator is a comma, a semicolon, a tab or a space");
  return text_of(text, where).and_then([&](std::string_view clean) {
    return TableReader(clean, where, options).read();
  });
}

Result<NumberTable> read_csv(const std::string& path, const CsvOptions& options) {
  return read_whole(path).and_then(
      [&](const std::string& bytes) { return parse_csv(bytes, path, options); });
}

std::string csv_field(const std::string& text) {
  const bool plain = std::all_of(text.begin(), text.end(), is_plain);
  if (plain && is_text(text)) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string format_csv(const NumberTable& table) {
  require(sizes_match(table), "a table needs values, a name a column and a label a row");
  std::string out;
  if (!table.names.empty()) append_header(out, table);
  for (std::size_t row = 0; row < table.values.rows(); ++row) append_row(out, table, row);
  return out;
}

Result<void> write_csv(const std::string& path, const NumberTable& table) {
  return save_whole(path, format_csv(table));
}

}  // namespace somato
