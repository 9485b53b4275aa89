#pragma once

#include <string>

#include "somato/graph/system.h"

namespace somato::program {

/// What a system is made of, for a person: each module with its type, output and memory, and the
/// phases of learning.
std::string explanation(const System& system);

}  // namespace somato::program
