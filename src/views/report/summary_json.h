#pragma once

#include <nlohmann/json.hpp>

#include "views/report/evidence.h"

namespace somato::detail {

/// The main result of a part, what was confused with what, and what to try next, as SystemSummary
/// of web/schema/report.json; null without a main_result().
nlohmann::ordered_json summary_json(const Evidence& evidence, const ReportSources& sources);

/// For each sample of a protocol the number of the training by which it was tested; empty if it is
/// unknown, or if there were as many trainings as samples, or only one. See tested_folds().
std::vector<std::size_t> folds_of(const Evidence& evidence, const ProtocolResults& protocol);

}  // namespace somato::detail
