#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "somato/studies/results.h"

namespace somato::detail {

/// The accuracy after the first share of the frames of a test exploration, as a list of CurveReport
/// of web/schema/report.json: one curve for each question and held-out protocol, one line for each
/// of its unchanged systems. The points are the alterations of a study that set `first` only, and
/// the whole exploration. A curve has at least three points in one line.
nlohmann::ordered_json frame_curves_json(const std::vector<const PartResults*>& parts);

}  // namespace somato::detail
