#pragma once

#include <optional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system.h"
#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"

namespace somato::detail {

/// The settings of that part, or nullptr.
const Settings* find_part(const std::vector<Settings>& settings, const std::string& part);

/// The type that the settings of a module name, or nullptr.
const ModuleType* type_of(const Settings& module);

/// The value of a setting as TOML writes it, or nullptr.
const std::string* find_setting(const std::vector<Settings>& settings, const std::string& part,
                                const std::string& name);

/// The study that has these settings, as results.json tells them all: what stands there by default
/// is left out again. Errors (kUsage): settings that are none of a study.
Result<StudyDescription> rebuilt_study(const std::vector<Settings>& settings);

/// Whether modules and phases of `settings` are those of `own`, setting by setting; where `own`
/// says "automatic", whatever was decided will do.
bool same_system(const std::vector<Settings>& own, const std::vector<Settings>& settings);

}  // namespace somato::detail
