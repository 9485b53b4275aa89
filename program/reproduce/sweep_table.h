#pragma once

#include <string>

#include "studies/sweep/sweep_results.h"

namespace somato::program {

/// A table of claims: the share of the points at which a claim holds, and the unknowns that decide
/// it.
std::string sweep_table(const SweepResults& results);

}  // namespace somato::program
