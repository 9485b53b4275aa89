#pragma once

#include <string>
#include <vector>

#include "row_data.h"

namespace somato::program {

/// Names or else numbers from 1 of columns, with commas between; three or more in a row that are
/// numbered one after the other are written as `tax_1..tax_8`.
std::string listed_columns(const TableColumns& table, const std::vector<std::size_t>& columns);

/// What the columns of the rows are taken for, and what was filled in: a line each.
std::string columns_and_filled(const RowData& rows);

/// Says on standard error which columns a trained map leaves out of the rows, and what was filled
/// in; nothing when there is nothing to say, or quiet.
void note_columns_and_filled(const RowData& rows);

}  // namespace somato::program
