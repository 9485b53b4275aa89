#pragma once

#include <map>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "views/report/report.h"

namespace somato::program {

/// The objects of all built-in tables, and their materials. There are no errors in an intact
/// program.
Result<std::vector<ReportThing>> report_things();

/// The units of all settings of explorations, by "explore.TABLE.NAME".
std::map<std::string, std::string> explore_units();

}  // namespace somato::program
