#pragma once

#include <string>

#include "somato/studies/sweep_results.h"

namespace somato::program {

/// For each claim the share of the points at which it holds, and the unknowns that decide it.
std::string sweep_table(const SweepResults& results);

}  // namespace somato::program
