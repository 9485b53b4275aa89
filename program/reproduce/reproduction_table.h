#pragma once

#include <string>

#include "somato/studies/results.h"

namespace somato::program {

/// The main measures, one line per system, variation and protocol; then the claims.
std::string reproduction_table(const Results& results);

}  // namespace somato::program
