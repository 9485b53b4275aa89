#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "somato/studies/results.h"

namespace somato::detail {

/// The parameters of all modules in `settings` that no paper gives, as a list of NotGiven of
/// web/src/report/data.ts.
nlohmann::ordered_json not_given_json(const std::vector<Settings>& settings);

}  // namespace somato::detail
