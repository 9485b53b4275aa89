#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"

namespace somato {

/// A table of numbers from a file.
struct NumberTable {
  std::vector<std::string> names;   ///< Names of the columns of `values`; empty if there are none.
  Matrix<float> values;             ///< Finite numbers; if missing numbers are kept, these are NaN.
  std::vector<std::string> labels;  ///< One per row; empty without a label column.

  bool operator==(const NumberTable&) const = default;
};

/// Place and spread of a column, known before its numbers are rounded to float32.
struct ColumnScale {
  double offset = 0.0;     ///< Subtracted in double precision before.
  double deviation = 0.0;  ///< Differences far below this are of no use; 0: not known.
};

/// Selects the columns of a table that are read as features. If columns have names, an item of
/// `use` and `skip` is a name or a pattern in which `*` matches any characters and `?` one;
/// otherwise it is a number from 1 or a range of numbers such as 2..17. Among columns with names, a
/// number selects a column without a name, or one of several that share a name.
struct ColumnChoice {
  std::vector<std::string> use;   ///< Empty: all columns.
  std::vector<std::string> skip;  ///< Skipped among those.
  /// Names of the columns that are then selected, in this order, from a table with names; empty:
  /// all remaining columns, in the order of the file.
  std::vector<std::string> features;
  /// One for each feature, or one for all; another number has no effect. Numbers are read without
  /// the offset of their column.
  std::vector<ColumnScale> scales = {};
};

/// The character between the whole part and the fraction of numbers in a text.
enum class DecimalMark { kPoint, kComma };

template <>
struct Choices<DecimalMark> {
  static const std::vector<std::pair<DecimalMark, std::string>>& all();
};

/// Options for reading a file of numbers; options that are not set are detected. For an NPY,
/// NPZ or MAT file only `columns`, `variable` and `keeps_missing` apply; a label column and a
/// decimal comma are refused. For other files `variable` is refused.
struct CsvOptions {
  /// Separator of fields: comma, semicolon, tab or blank (any number of spaces and tabs). Detected:
  /// the character that a first line such as sep=; declares, or the first of tab, semicolon, comma
  /// and blank that occurs in the first line; with a decimal comma the first of tab, semicolon and
  /// blank.
  std::optional<char> separator = {};
  /// Whether the first line contains names. Detected: true if a field outside the label column, and
  /// outside columns that are skipped by number, is quoted, or is neither a number (possibly with a
  /// decimal comma) nor a marker of a missing number, or if the first field is empty and the others
  /// are 0, 1, 2 and so on, as pandas numbers columns.
  std::optional<bool> header = {};
  /// The column with labels, by name or by number from 1; empty: none.
  std::string label_column = {};
  /// Which of the other columns are read; the content of skipped columns is ignored.
  ColumnChoice columns = {};
  /// The array of a file with several (NPZ, MAT); empty: the only one.
  std::string variable = {};
  /// Treatment of missing numbers: an error, or NaN.
  bool keeps_missing = false;
  /// Treatment of empty labels: an error, or an empty text.
  bool keeps_empty_labels = false;
  /// A decimal comma cannot separate fields as well; with a decimal comma, a point is not part of a
  /// number.
  DecimalMark decimal = DecimalMark::kPoint;
};

/// The table in `text`, from the source `where`: RFC 4180 with other separators, a byte order mark
/// and any line endings. Blank lines and lines that begin with # are skipped. Numbers are decimal,
/// rounded to float32. Names and labels are as in csv_field(); column 1 without a name is named
/// (column 1). Errors: kData with `where:line:column`, both from 1, column in bytes (ragged
/// rows, values that are not finite numbers, binary content, no rows); kUsage for a missing label
/// column, for a decimal comma where commas separate fields, and those of choose_columns().
Result<NumberTable> parse_csv(std::string_view text, std::string_view where,
                              const CsvOptions& options = {});

/// The table in the file at `path`; see parse_csv() and read_whole().
Result<NumberTable> read_csv(const std::string& path, const CsvOptions& options = {});

/// A text as a field of a CSV file: in quotation marks, with inner ones doubled, unless it is
/// unambiguous without them. A text that a spreadsheet would evaluate, because it begins with = + -
/// @, a tab or a carriage return and is not a number, is preceded by an apostrophe, and so is a
/// text that consists of such a text after apostrophes. All functions that read names and labels
/// remove this apostrophe.
std::string csv_field(const std::string& value);

/// The table as text that is read back to the same bits unless a name is blank: names if there are
/// any, commas, the labels as last column `label`. Throws InvalidArgument if sizes do not match, a
/// value is not finite, or a text is not UTF-8.
std::string format_csv(const NumberTable& table);

/// Saves atomically; see save_whole().
Result<void> write_csv(const std::string& path, const NumberTable& table);

}  // namespace somato
