#pragma once

#include <string>

#include "studies/inference/inference_results.h"

namespace somato::program {

/// The unknowns with what the observations say about them, and the shares of the claims, as a table
/// for the terminal.
std::string inference_table(const InferenceResults& results);

}  // namespace somato::program
