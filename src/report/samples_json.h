#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "report/evidence.h"

namespace somato::detail {

/// The labels of the explorations that were asked about, in the order of the samples; null without
/// a recording.
nlohmann::ordered_json samples_json(const Evidence& evidence);

/// The things that were explored, as ThingData of web/src/parts/data.ts, in the order of their
/// first appearance: by the labels of the recording, or without one by what the results were asked.
/// What nobody labelled is taken from the one of `known` that has the name and contradicts no
/// label.
nlohmann::ordered_json things_json(const Evidence& evidence, const std::vector<ReportThing>& known);

/// One exploration of each thing, as MomentData of web/src/report/data.ts: the frame where the
/// channel `touch` has the greatest sum (of equals the first), of other channels the one nearest to
/// it in time, or the last where there is no `touch`; beside it at most 200 frames evenly chosen,
/// of channels with up to 64 elements.
nlohmann::ordered_json moments_json(const Evidence& evidence);

/// A channel, with names for all of its elements.
nlohmann::ordered_json channel_json(const std::string& name, const std::string& unit,
                                    const std::vector<std::string>& elements,
                                    const std::vector<std::size_t>& shape);

}  // namespace somato::detail
