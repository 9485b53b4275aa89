#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/own_plans.h"
#include "somato/report/results_file.h"

namespace somato::detail {

/// Claims, and sentences about those that are left out.
struct ClaimsOfFile {
  std::vector<JudgedClaim> claims;
  std::vector<std::string> missing;
};

/// The claims of a reproduction, as it judged them; of a study those of the library's own system of
/// that name and these settings, but for what its explorations cannot decide: too few of them, or
/// not of the things that the claim is about. `layout` is that of its recording, or empty.
ClaimsOfFile claims_of(const ResultsFile& file, const RecordingLayout& layout, OwnPlans& plans);

/// A claim as ClaimReport of web/src/report/data.ts.
nlohmann::ordered_json claim_json(const JudgedClaim& judged, const std::string& file);

}  // namespace somato::detail
