#pragma once

#include <string>

#include "studies/inference/inference_results.h"

namespace somato::program {

/// The unknowns of an inference with their posterior, one in a line; `adjusted` is whether the rule
/// asks for adjustment.
std::string inferred_unknowns_table(const SweepDescription& sweep, const Inference& inference,
                                    bool adjusted);

/// The unknowns with what the observations say about them, and the shares of the claims, as a table
/// for the terminal.
std::string inference_table(const InferenceResults& results);

}  // namespace somato::program
