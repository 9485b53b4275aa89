#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/own_plans.h"
#include "somato/report/results_file.h"

namespace somato::detail {

/// The claims of a reproduction; of a study those of the library's own system of that name and
/// these settings. `layout` is that of its recording, or empty.
std::vector<JudgedClaim> claims_of(const ResultsFile& file, const RecordingLayout& layout,
                                   OwnPlans& plans);

/// A claim as ClaimReport of web/src/report/data.ts.
nlohmann::ordered_json claim_json(const JudgedClaim& judged, const std::string& file);

}  // namespace somato::detail
