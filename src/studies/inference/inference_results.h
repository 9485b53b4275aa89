#pragma once

#include <string>
#include <vector>

#include "studies/inference/claim_support.h"
#include "studies/inference/inference.h"
#include "studies/inference/match.h"
#include "studies/inference/targets.h"
#include "studies/sweep/sweep_results.h"

namespace somato {

/// An inference with its check on fresh seeds.
struct InferenceResults {
  SweepResults draws;
  Targets targets;
  Inference inference;
  SweepResults fresh;  ///< At settings of the posterior; without points if they have not been run.
  std::vector<ClaimShares> claims;  ///< One for each claim of the sweep.
  std::vector<ClaimConflict> conflicts;
};

/// The shares of the claims and their conflicts, for draws, an inference from them and its fresh
/// results.
InferenceResults with_claims(SweepResults draws, Targets targets, Inference inference,
                             SweepResults fresh);

/// The results as inference.json, version 1; the same bytes for the same results.
std::string to_json(const InferenceResults& results);

/// The results as match.json, version 1; likewise.
std::string to_json(const Match& match);

}  // namespace somato
