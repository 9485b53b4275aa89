#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "somato/studies/claim.h"
#include "somato/studies/results.h"

namespace somato::detail {

/// Parts of results.json that studies, reproductions and sweeps share.
nlohmann::ordered_json system_json(const SystemResults& system);
nlohmann::ordered_json settings_json(const std::vector<Settings>& parts);

/// A value as TOML writes it; a text that is not one stays a text.
nlohmann::ordered_json setting_json(const std::string& value);

/// What is claimed.
nlohmann::ordered_json claim_json(const Claim& claim);

}  // namespace somato::detail
