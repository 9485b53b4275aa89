#pragma once

#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system.h"

namespace somato {

/// The phases of a system whose modules are connected; see System::phases(). Errors (kUsage): a
/// phase names an unknown module, one that does not learn or one that another phase names; learns
/// before what it depends on has learned; modules learn together that cannot.
Result<std::vector<Phase>> plan_phases(const System& system);

/// The modules that have to be computed anew for every draw of a phase: its learners and what lies
/// between them, in the order in which they run.
std::vector<std::size_t> computed_in(const System& system, const Phase& phase);

}  // namespace somato
