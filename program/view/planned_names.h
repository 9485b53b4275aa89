#pragma once

#include <vector>

#include "flags/commands.h"
#include "somato/core/result.h"
#include "views/session/view_source.h"

namespace somato::program {

/// The flags of the names that are given in a page, and of the explorations of each.
std::vector<Flag> planned_name_flags();

/// The source has the names that the flags plan. Errors (kUsage): a name is missing or repeated; a
/// number is not whole or out of range.
Result<void> plan_names(const Arguments& arguments, ViewSource& source);

}  // namespace somato::program
