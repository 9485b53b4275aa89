#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "somato/studies/results.h"

namespace somato::detail {

/// How metrics change with a parameter, as a list of CurveReport of web/schema/report.json: parts
/// of a system that differ in one numeric parameter (of one module, or of several by the same
/// number) are the points of its line, systems of one question the lines of a curve. A curve has at
/// least three points in one line. The metrics are accuracy under each protocol and those of
/// `claims` about the same question. `units` are those of parameters of exploring, by `PART.NAME`.
nlohmann::ordered_json curves_json(const std::vector<const PartResults*>& parts,
                                   const std::vector<const ClaimOutcome*>& claims,
                                   const std::map<std::string, std::string>& units);

}  // namespace somato::detail
