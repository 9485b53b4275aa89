#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "report/evidence.h"

namespace somato::detail {

/// The labels of the studied explorations, in the order of the samples; null without a recording.
nlohmann::ordered_json samples_json(const Evidence& evidence);

/// The things that were explored, as ThingData of web/schema/parts.json, in the order of their
/// first appearance: by the labels of the recording, or without one by the classes in the results.
/// Properties without a label are those of the entry in `known` with the same name that contradicts
/// no label.
nlohmann::ordered_json things_json(const Evidence& evidence, const std::vector<ReportThing>& known);

/// One exploration of each thing, as MomentData of web/schema/report.json: the frame where the
/// channel `touch` has the greatest sum (of equals the first), of other channels the one nearest to
/// it in time, or the last where there is no `touch`; beside it at most 200 frames evenly chosen,
/// of channels with up to 64 elements.
nlohmann::ordered_json moments_json(const Evidence& evidence);

}  // namespace somato::detail
