#pragma once

#include <map>
#include <string>
#include <vector>

#include "somato/bodies/object_table.h"
#include "views/report/report.h"

namespace somato::program {

/// The objects of all built-in tables, and their materials.
std::vector<ReportThing> built_in_things();

/// The objects and materials of a table.
std::vector<ReportThing> things_in(const ObjectTable& table);

/// The units of all settings of explorations, by "explore.TABLE.NAME".
std::map<std::string, std::string> explore_units();

}  // namespace somato::program
