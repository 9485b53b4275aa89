#include "files/csv_records.h"

#include <fmt/format.h>

#include "files/text.h"

namespace somato {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

}  // namespace

std::string CsvRecords::place(const CsvField& field) const {
  return fmt::format("{}:{}:{}", where_, field.line, field.column);
}

bool CsvRecords::at_separator(char separator) const {
  return separator == ' ' ? is_blank(here()) : here() == separator;
}

void CsvRecords::skip_blanks(char separator) {
  while (!at_end() && is_blank(here()) && (separator == ' ' || here() != separator)) ++position_;
}

void CsvRecords::skip_line_end() {
  if (at_end()) return;
  position_ += text_.substr(position_).starts_with("\r\n") ? 2 : 1;
  ++line_;
  line_start_ = position_;
}

void CsvRecords::skip_what_is_no_record() {
  while (!at_end()) {
    const std::size_t length = text_.substr(position_).find_first_of("\r\n");
    const std::string_view line = text_.substr(position_, length);
    if (!line.starts_with('#') && !trimmed(line).empty()) return;
    position_ += line.size();
    skip_line_end();
  }
}

char CsvRecords::guess_separator() {
  skip_what_is_no_record();
  std::string outside_quotes;
  bool quoted = false;
  for (std::size_t i = position_; i < text_.size(); ++i) {
    if (!quoted && (text_[i] == '\n' || text_[i] == '\r')) break;
    if (text_[i] == '"') quoted = !quoted;
    if (!quoted) outside_quotes += text_[i];
  }
  const std::string_view record = trimmed(outside_quotes);
  for (const char separator : {'\t', ';', ',', ' '}) {
    if (record.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

Result<void> CsvRecords::quoted_text(CsvField& field) {
  field.quoted = true;
  for (++position_; !at_end();) {
    if (text_.substr(position_).starts_with("\"\"")) {
      field.text += '"';
      position_ += 2;
    } else if (here() == '"') {
      ++position_;
      return {};
    } else if (at_line_end()) {
      const std::size_t start = position_;
      skip_line_end();
      field.text += text_.substr(start, position_ - start);
    } else {
      field.text += text_[position_++];
    }
  }
  return fail(ErrorKind::kData, "the quotation mark is never closed", place(field),
              "close it, or write it twice if it belongs to the text");
}

Result<CsvField> CsvRecords::field(char separator) {
  skip_blanks(separator);
  CsvField field;
  field.line = line_;
  field.column = position_ - line_start_ + 1;
  if (!at_end() && here() == '"') {
    if (Result<void> read = quoted_text(field); !read) return fail(read.error());
  } else {
    const std::size_t start = position_;
    while (!at_line_end() && !at_separator(separator)) ++position_;
    field.text = trimmed(text_.substr(start, position_ - start));
  }
  const bool separated = !at_line_end() && at_separator(separator);
  skip_blanks(separator);
  if (!at_line_end() && !at_separator(separator) && !separated) {
    return fail(ErrorKind::kData, "text follows the closing quotation mark", place(field),
                "put all of the field in quotation marks");
  }
  return field;
}

Result<void> CsvRecords::next(char separator, std::vector<CsvField>& fields) {
  fields.clear();
  skip_what_is_no_record();
  if (at_end()) return {};
  for (;;) {
    Result<CsvField> read = field(separator);
    if (!read) return fail(std::move(read.error()));
    fields.push_back(std::move(*read));
    if (at_line_end()) break;
    if (separator != ' ') ++position_;
  }
  skip_line_end();
  return {};
}

}  // namespace somato
