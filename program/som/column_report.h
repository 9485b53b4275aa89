#pragma once

#include <string>
#include <vector>

#include "som/row_data.h"

namespace somato::program {

/// The names of columns, or their numbers from 1 if they have none, separated by commas; three or
/// more consecutively numbered columns are written as `tax_1..tax_8`.
std::string listed_columns(const TableColumns& table, const std::vector<std::size_t>& columns);

/// The use of the columns and the number of filled values, one per line.
std::string columns_and_filled(const RowData& rows);

/// Reports on standard error which columns a trained map leaves out and how many values were
/// filled; prints nothing if there are none, or with --quiet.
void note_columns_and_filled(const RowData& rows);

/// Warns on standard error of columns of which rounding to single precision loses something;
/// prints nothing if there are none, or with --quiet.
void note_rounded(const RowData& rows);

}  // namespace somato::program
