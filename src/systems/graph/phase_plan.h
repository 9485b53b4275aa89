#pragma once

#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system.h"

namespace somato {

/// The phases of a system whose modules are connected; see System::phases(). Errors (kUsage): a
/// phase names an unknown module, one that does not learn or one that another phase names; it
/// learns before its dependencies; its modules cannot learn together.
Result<std::vector<Phase>> plan_phases(const System& system);

/// The modules that must be computed for every draw of a phase, in execution order: its learners
/// and the modules between them; in a phase that settles, also those before them whose output is a
/// value of an exploration.
std::vector<std::size_t> computed_in(const System& system, const Phase& phase);

/// Whether the only learner of a phase learns from all explorations at once.
bool learns_separately(const System& system, const Phase& phase);

}  // namespace somato
