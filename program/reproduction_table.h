#pragma once

#include <string>

#include "somato/studies/reproduction.h"

namespace somato::program {

/// The main figures, a line for each system, variation and protocol; then the claims.
std::string reproduction_table(const ReproductionResults& results);

}  // namespace somato::program
