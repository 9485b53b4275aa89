#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "somato/studies/claim.h"
#include "somato/studies/results.h"

namespace somato::detail {

/// Parts of results.json that a report or a sweep shares.
nlohmann::ordered_json protocol_json(const ProtocolResults& protocol);
nlohmann::ordered_json fold_comparison_json(const FoldComparison& comparison);
nlohmann::ordered_json parameters_json(const std::vector<Settings>& parts);

/// The claim.
nlohmann::ordered_json claim_json(const Claim& claim);

}  // namespace somato::detail
