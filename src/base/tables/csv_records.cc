#include "base/tables/csv_records.h"

#include <fmt/format.h>

#include "base/text/text.h"

namespace somato {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

// The separator that a line such as sep=; declares for spreadsheets. They may put it in quotation
// marks, and repeat the separator once for each of the other columns.
std::optional<char> declared_separator(std::string_view line) {
  constexpr std::string_view kDeclaration = "sep=";
  constexpr std::string_view kSeparators = ",;\t |:";
  const bool is_quoted = line.starts_with('"');
  if (is_quoted) line.remove_prefix(1);
  for (const char c : kDeclaration) {
    if (line.empty() || (line.front() != c && line.front() != c - 'a' + 'A')) return std::nullopt;
    line.remove_prefix(1);
  }
  if (line.empty() || kSeparators.find(line.front()) == std::string_view::npos) return std::nullopt;
  const char separator = line.front();
  line.remove_prefix(1);
  if (is_quoted && !line.starts_with('"')) return std::nullopt;
  if (is_quoted) line.remove_prefix(1);
  const bool is_whole = line.find_first_not_of(separator) == std::string_view::npos;
  return is_whole ? std::optional(separator) : std::nullopt;
}

}  // namespace

std::string CsvRecords::place(const CsvField& field) const {
  return fmt::format("{}:{}:{}", where_, field.line, field.column);
}

std::string CsvRecords::line_place(const CsvField& field) const {
  return fmt::format("{}:{}", where_, field.line);
}

bool CsvRecords::at_separator(char separator) const {
  return separator == ' ' ? is_blank(here()) : here() == separator;
}

void CsvRecords::skip_blanks(char separator) {
  while (!at_end() && is_blank(here()) && (separator == ' ' || here() != separator))
    ++position_.offset;
}

void CsvRecords::skip_line_end() {
  if (at_end()) return;
  position_.offset += text_.substr(position_.offset).starts_with("\r\n") ? 2 : 1;
  ++position_.line;
  position_.line_start = position_.offset;
}

void CsvRecords::skip_what_is_no_record() {
  while (!at_end()) {
    const std::size_t length = text_.substr(position_.offset).find_first_of("\r\n");
    const std::string_view line = text_.substr(position_.offset, length);
    if (!line.starts_with('#') && !trimmed(line).empty()) return;
    position_.offset += line.size();
    skip_line_end();
  }
}

// Moves the window to the text after its content, from the start of a record, which is read again.
// Returns false at the end.
Result<bool> CsvRecords::read_on(const Position& from) {
  position_ = from;
  if (!window_) return false;
  window_->drop(from.line_start);
  position_.offset -= from.line_start;
  position_.line_start = 0;
  Result<bool> more = window_->extend();
  text_ = window_->text();
  if (!more) failure_ = more.error();
  return more;
}

char CsvRecords::guess_separator(std::string_view candidates) {
  for (;;) {
    const Position start = position_;
    const auto [separator, whole] = guess_from_here(candidates);
    if (!whole && read_on(start).value_or(false)) continue;
    return take_declared_separator().value_or(separator);
  }
}

// From the start of the first record, which is in memory.
std::optional<char> CsvRecords::take_declared_separator() {
  const std::string_view line =
      text_.substr(position_.offset, text_.substr(position_.offset).find_first_of("\r\n"));
  const std::optional<char> separator = declared_separator(line);
  if (!separator) return std::nullopt;
  position_.offset += line.size();
  skip_line_end();
  return separator;
}

std::pair<char, bool> CsvRecords::guess_from_here(std::string_view candidates) {
  skip_what_is_no_record();
  std::string outside_quotes;
  bool quoted = false;
  bool whole = false;
  for (std::size_t i = position_.offset; i < text_.size(); ++i) {
    if (!quoted && (text_[i] == '\n' || text_[i] == '\r')) {
      whole = true;
      break;
    }
    if (text_[i] == '"') quoted = !quoted;
    if (!quoted) outside_quotes += text_[i];
  }
  const std::string_view record = trimmed(outside_quotes);
  for (const char separator : candidates) {
    if (record.find(separator) != std::string_view::npos) return {separator, whole};
  }
  return {',', whole};
}

Result<void> CsvRecords::quoted_text(CsvField& field) {
  field.quoted = true;
  for (++position_.offset; !at_end();) {
    if (text_.substr(position_.offset).starts_with("\"\"")) {
      field.text += '"';
      position_.offset += 2;
    } else if (here() == '"') {
      ++position_.offset;
      return {};
    } else if (at_line_end()) {
      const std::size_t start = position_.offset;
      skip_line_end();
      field.text += text_.substr(start, position_.offset - start);
    } else {
      field.text += text_[position_.offset++];
    }
  }
  return fail(ErrorKind::kData, "the quotation mark is not closed", place(field),
              "close it, or write it twice if it belongs to the text");
}

Result<CsvField> CsvRecords::field(char separator) {
  skip_blanks(separator);
  CsvField field;
  field.line = position_.line;
  field.column = position_.offset - position_.line_start + 1;
  if (!at_end() && here() == '"') {
    SOMATO_TRY_VOID(quoted_text(field));
  } else {
    const std::size_t start = position_.offset;
    while (!at_line_end() && !at_separator(separator)) ++position_.offset;
    field.text = trimmed(text_.substr(start, position_.offset - start));
  }
  const bool separated = !at_line_end() && at_separator(separator);
  skip_blanks(separator);
  if (!at_line_end() && !at_separator(separator) && !separated) {
    return fail(ErrorKind::kData, "text follows the closing quotation mark", place(field),
                "put the whole field in quotation marks");
  }
  return field;
}

// An item at the end of the text in memory may continue after it, even a line end of two
// characters.
Result<void> CsvRecords::next(char separator, std::vector<CsvField>& fields) {
  if (failure_) return fail(*failure_);
  for (;;) {
    const Position start = position_;
    Result<void> read = record(separator, fields);
    if (!window_ || !at_end()) return read;
    SOMATO_TRY(const bool more, read_on(start));
    if (!more) return record(separator, fields);
  }
}

Result<void> CsvRecords::record(char separator, std::vector<CsvField>& fields) {
  fields.clear();
  skip_what_is_no_record();
  start_ = {(window_ ? window_->start() : 0) + position_.offset, position_.line};
  if (at_end()) return {};
  for (;;) {
    SOMATO_TRY(CsvField read, field(separator));
    fields.push_back(std::move(read));
    if (at_line_end()) break;
    if (separator != ' ') ++position_.offset;
  }
  skip_line_end();
  return {};
}

}  // namespace somato
