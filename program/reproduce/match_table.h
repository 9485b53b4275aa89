#pragma once

#include <string>

#include "studies/inference/match.h"

namespace somato::program {

/// A table for the terminal with the compared channels, the distances before and after, and the
/// unknowns.
std::string match_table(const Match& match);

}  // namespace somato::program
