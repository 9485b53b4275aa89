#pragma once

#include <vector>

#include "flags/command_line.h"
#include "som/row_data.h"
#include "somato/maps/som_parameters.h"

namespace somato::program {

/// --layers: the layers of a map.
Flag layers_flag();

/// The layers that the flag names, for the columns of the rows; none without the flag. Errors
/// (kUsage): no such column, one in two layers or in none, layers whose columns are no neighbours,
/// a distance or a number that is not one.
Result<std::vector<Layer>> read_layers(const Arguments& arguments, const RowData& rows);

}  // namespace somato::program
