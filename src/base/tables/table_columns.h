#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"
#include "somato/files/csv.h"

namespace somato {

/// The roles of the columns of a table. Columns are counted from 0.
struct TableColumns {
  std::size_t width = 0;                 ///< Number of columns of the file.
  std::vector<std::string> names;        ///< Names of all columns; empty if they have none.
  std::optional<std::size_t> label;      ///< The column with labels.
  std::vector<std::size_t> features;     ///< The columns of the features, in order.
  std::vector<ColumnScale> scales = {};  ///< By column; columns without one are read as they are.

  /// After the last row: a sentence for each column of which rounding to single precision loses
  /// something; see ColumnPrecision::notes().
  std::vector<std::string> rounded = {};

  /// Names of the features; empty if columns have no names.
  std::vector<std::string> feature_names() const;

  /// The columns that are neither features nor the label.
  std::vector<std::size_t> left_out() const;
};

/// Determines the features of `table`, whose other members are known, from the source `where`.
/// Errors: kUsage for an item that matches no column, is listed twice or matches two columns with
/// one name, for a column with two different roles (used and skipped, label and used or skipped; a
/// column matched by a pattern or a range may be skipped), and if no column is left; kData if a
/// column of `choice.features` is missing or ambiguous, or if, without these, features that no item
/// of `choice.use` names have no name (see is_nameless()) or the same name.
Result<TableColumns> choose_columns(const ColumnChoice& choice, TableColumns table,
                                    std::string_view where);

/// The number without the offset of its column.
double without_offset(const TableColumns& table, std::size_t column, double number);

/// Whether the columns have offsets.
bool has_offsets(const TableColumns& table);

/// Whether `choice` skips `column` of a table without names.
bool leaves_out_number(const ColumnChoice& choice, std::size_t column);

}  // namespace somato
