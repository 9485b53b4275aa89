#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "views/report/evidence.h"

namespace somato::detail {

/// The first exploration of each thing among the samples; things are named by the labels `object`
/// or `material`, or else by the studied label.
std::vector<std::size_t> first_of_each(const Evidence& evidence);

/// The labels of the studied explorations, in the order of the samples; null without a recording.
nlohmann::ordered_json samples_json(const Evidence& evidence);

/// The things that were explored, as ThingData of web/schema/parts.json, in the order of their
/// first appearance: by the labels of the recording, or without one by the classes in the results.
/// Properties without a label are those of the thing of `known` with the same name that contradicts
/// no label: one that the user describes, or a built-in one if the source of the exploration states
/// that a simulated body explored it (is_of_built_in_things()).
nlohmann::ordered_json things_json(const Evidence& evidence, const ReportSources& known);

}  // namespace somato::detail
