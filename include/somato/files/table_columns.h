#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// Which columns of a table are read as features. An item of `use` and `skip` is, in a table whose
/// columns have names, a name or a pattern in which `*` stands for any characters and `?` for one;
/// in a table without names a number from 1 or a range of numbers such as 2..17.
struct ColumnChoice {
  std::vector<std::string> use;   ///< Empty: all columns.
  std::vector<std::string> skip;  ///< Left out of those.
  /// Names of the columns that are then picked, in this order, from a table with names; empty: all
  /// that are left, in the order of the file.
  std::vector<std::string> features;
};

/// What the columns of a table are for. Columns are counted from 0.
struct TableColumns {
  std::size_t width = 0;              ///< Columns of the file.
  std::vector<std::string> names;     ///< Of all of them; empty when they have none.
  std::optional<std::size_t> label;   ///< The column that holds labels.
  std::vector<std::size_t> features;  ///< The columns of the numbers that are read, in their order.

  /// Names of the features; empty when columns have no names.
  std::vector<std::string> feature_names() const;

  /// The columns that are neither features nor the label.
  std::vector<std::size_t> left_out() const;
};

/// Decides on the features of `table`, of which all else is known, and which is `where`.
/// Errors: kUsage for an item that names no column, is given twice or fits two columns of one name,
/// for a column that is named twice in different roles (to be used and skipped, label and used or
/// skipped; a column that a pattern or a range includes may be skipped), and when no column is
/// left; kData when a column of `choice.features` is not there, or is there twice.
Result<TableColumns> choose_columns(const ColumnChoice& choice, TableColumns table,
                                    std::string_view where);

/// Whether `choice` leaves out `column` of a table without names.
bool leaves_out_number(const ColumnChoice& choice, std::size_t column);

}  // namespace somato
