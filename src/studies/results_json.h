#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "somato/studies/results.h"

namespace somato::detail {

/// Parts of results.json that studies and reproductions share.
nlohmann::ordered_json system_json(const SystemResults& system);
nlohmann::ordered_json settings_json(const std::vector<Settings>& parts);

}  // namespace somato::detail
