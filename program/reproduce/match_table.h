#pragma once

#include <string>

#include "studies/inference/match.h"

namespace somato::program {

/// What was compared, the distances before and after, and the unknowns, as a table for the
/// terminal.
std::string match_table(const Match& match);

}  // namespace somato::program
