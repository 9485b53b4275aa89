#pragma once

#include <map>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/report/report.h"

namespace somato::program {

/// The things of all tables that travel with the program, and the materials that things are made
/// of. Errors: none that a program as it was built could have.
Result<std::vector<ReportThing>> report_things();

/// The units of all settings of exploring, by "explore.TABLE.NAME".
std::map<std::string, std::string> explore_units();

}  // namespace somato::program
