#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "somato/report/results_file.h"

namespace somato::detail {

/// A part with all that its settings are known to be, those of exploring among them.
struct CurvePart {
  const PartResults* part = nullptr;
  std::vector<Settings> settings;
};

/// How metrics change with a setting, as a list of CurveReport of web/src/report/data.ts: parts of
/// a system that differ in one numeric setting (of one module, or of several by the same number)
/// are the points of its line, systems of one question the lines of a curve. A curve has at least
/// three points in one line. The metrics are accuracy under each protocol and those of `claims`
/// about the same question. `units` are those of settings of exploring, by `PART.NAME`.
nlohmann::ordered_json curves_json(const std::vector<CurvePart>& parts,
                                   const std::vector<JudgedClaim>& claims,
                                   const std::map<std::string, std::string>& units);

}  // namespace somato::detail
