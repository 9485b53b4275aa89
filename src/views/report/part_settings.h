#pragma once

#include <string>
#include <vector>

#include "somato/graph/module.h"
#include "somato/studies/results.h"

namespace somato::detail {

/// The settings of that part, or nullptr.
const Settings* find_part(const std::vector<Settings>& settings, const std::string& part);

/// The type that the settings of a module name, or nullptr.
const ModuleType* type_of(const Settings& module);

}  // namespace somato::detail
