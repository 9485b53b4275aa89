#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "somato/graph/module.h"
#include "somato/studies/results.h"

namespace somato::detail {

/// The settings of that part, or nullptr.
const Settings* find_part(const std::vector<Settings>& settings, const std::string& part);

/// The type that the settings of a module name, or nullptr.
const ModuleType* type_of(const Settings& module);

/// Those of the parameters of modules that no paper gives, as a list of NotGiven of
/// web/schema/report.json.
nlohmann::ordered_json not_given_json(const std::vector<Settings>& parameters);

}  // namespace somato::detail
