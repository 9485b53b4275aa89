#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "somato/studies/results.h"

namespace somato::detail {

/// Those of the parameters of modules that no paper gives, as a list of NotGiven of
/// web/schema/report.json.
nlohmann::ordered_json not_given_json(const std::vector<Settings>& parameters);

}  // namespace somato::detail
