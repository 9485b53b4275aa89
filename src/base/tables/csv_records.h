#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files/text_window.h"
#include "somato/core/result.h"

namespace somato {

/// A field of a CSV file and its place, from 1.
struct CsvField {
  std::string text;
  bool quoted = false;
  std::size_t line = 0;
  std::size_t column = 0;
};

/// Cuts the text of a CSV file into records of fields, passing over blank lines and lines that
/// begin with #.
class CsvRecords {
 public:
  /// `text` is `where`; it must outlive this object.
  CsvRecords(std::string_view text, std::string_view where) : text_(text), where_(where) {}

  /// The beginning of a record: its byte in the file and its line, from 1.
  struct Start {
    std::size_t place = 0;
    std::size_t line = 1;
  };

  /// The same for the text of `window`, of which only one record needs to be in memory; it must
  /// outlive this object and begins with line `line`.
  CsvRecords(TextWindow& window, std::string_view where, std::size_t line = 1)
      : window_(&window), text_(window.text()), where_(where) {
    position_.line = line;
  }

  /// The separator of a text that has not been read: the one that a first line such as sep=;
  /// declares, which is passed over, or the first of `candidates` that occurs in the first record
  /// outside quotation marks, otherwise a comma.
  char guess_separator(std::string_view candidates = "\t;, ");

  /// Reads the next record into `fields`, which is empty at the end of the text. Errors: kData.
  Result<void> next(char separator, std::vector<CsvField>& fields);

  /// The beginning of the record that was read last; the end of the text after the last.
  const Start& start() const { return start_; }

  /// `where:line:column` of a field.
  std::string place(const CsvField& field) const;

  /// `where:line` of a field.
  std::string line_place(const CsvField& field) const;

 private:
  // The current position.
  struct Position {
    std::size_t offset = 0;
    std::size_t line = 1;
    std::size_t line_start = 0;
  };

  Result<void> record(char separator, std::vector<CsvField>& fields);
  // The separator, and whether all of the record was there.
  std::pair<char, bool> guess_from_here(std::string_view candidates);
  std::optional<char> take_declared_separator();
  Result<bool> read_on(const Position& from);
  bool at_end() const { return position_.offset == text_.size(); }
  char here() const { return text_[position_.offset]; }
  bool at_line_end() const { return at_end() || here() == '\n' || here() == '\r'; }
  bool at_separator(char separator) const;
  void skip_blanks(char separator);
  void skip_line_end();
  void skip_what_is_no_record();
  Result<CsvField> field(char separator);
  Result<void> quoted_text(CsvField& field);

  TextWindow* window_ = nullptr;
  std::string_view text_;
  std::string where_;
  Position position_;
  Start start_;
  std::optional<Error> failure_;  // The error of the window; no further text is read.
};

}  // namespace somato
