#pragma once

#include <string>

#include "somato/core/value.h"
#include "somato/graph/system.h"

namespace somato::program {

/// A readable description of a system: each module with its type, output and memory, and the
/// training phases.
std::string explanation(const System& system);

/// The same with sizes in bytes: `modules`, `phases` and `learned_memory`.
Table explanation_table(const System& system);

}  // namespace somato::program
