#pragma once

#include <string>

#include "somato/studies/results.h"
#include "studies/inference/inference_results.h"
#include "studies/sweep/sweep_results.h"

namespace somato::program {

// Tables for the terminal.

/// The main measures, one line per system, variation and protocol; then the claims.
std::string reproduction_table(const Results& results);

/// The claims of a sweep: the share of the points at which each holds, and the unknowns that decide
/// it.
std::string sweep_table(const SweepResults& results);

/// The unknowns with what the observations say about them, and the shares of the claims.
std::string inference_table(const InferenceResults& results);

/// The unknowns of an inference with their posterior, one in a line; `adjusted` is whether the rule
/// asks for adjustment.
std::string inferred_unknowns_table(const SweepDescription& sweep, const Inference& inference,
                                    bool adjusted);

}  // namespace somato::program
