#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "somato/core/result.h"
#include "somato/files/number_table.h"
#include "somato/files/table_columns.h"

namespace somato {

/// How a file of numbers is read; what is not given is found out. Of an NPY file only `columns` and
/// `keeps_missing` count; a label column and a decimal comma are refused.
struct CsvOptions {
  /// Between fields: ',', ';', '\t' or ' ' (any number of spaces and tabs). Found out: the first of
  /// tab, semicolon, comma and blank that the first line holds, with a decimal comma the first of
  /// tab, semicolon and blank.
  std::optional<char> separator = {};
  /// Whether the first line holds names. Found out: when a field outside the label column, and
  /// outside columns that are left out by number, is quoted, or is neither a number (be it with a
  /// decimal comma) nor what stands for a missing one.
  std::optional<bool> header = {};
  /// The column that holds labels, by name or by number from 1; empty: none.
  std::string label_column = {};
  /// Which of the others are read; what they hold that are left out does not matter.
  ColumnChoice columns = {};
  /// What missing numbers become: an error, or NaN.
  bool keeps_missing = false;
  /// What marks decimals: '.' or ','. A comma cannot separate fields too; with a decimal comma a
  /// point is no part of a number.
  char decimal = '.';
};

/// The table in `text`, which is `where`: RFC 4180 with other separators, a byte order mark and any
/// ends of lines. Blank lines and lines that begin with # are passed over. Numbers are decimal,
/// rounded to float32.
/// Errors: kData with `where:line:column`, both from 1, column in bytes (ragged rows, what is no
/// finite number, binary content, no rows); kUsage for a label column that is not there, for a
/// decimal comma where commas separate fields, and those of choose_columns().
Result<NumberTable> parse_csv(std::string_view text, std::string_view where,
                              const CsvOptions& options = {});

/// The table in the file at `path`; see parse_csv() and read_whole().
Result<NumberTable> read_csv(const std::string& path, const CsvOptions& options = {});

/// The text as a field of a CSV file: between quotes, those inside doubled, unless nobody could
/// take it for a number or anything else.
std::string csv_field(const std::string& text);

/// The table as text that reads back to the same bits: names if there are any, commas, the labels
/// as last column `label`. Throws InvalidArgument when sizes do not match, a value is not finite,
/// or a text is not UTF-8.
std::string format_csv(const NumberTable& table);

/// Saves wholly or not at all; see save_whole().
Result<void> write_csv(const std::string& path, const NumberTable& table);

}  // namespace somato
