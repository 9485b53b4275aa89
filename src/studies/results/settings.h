#pragma once

#include <vector>

#include "somato/graph/system.h"
#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"

namespace somato {

/// All settings of the modules and phases of a system, as in results.json: `module.NAME` and
/// `phase.N`, including defaults. Automatic parameters of a trained map have their resolved values.
std::vector<Settings> system_settings(const System& system);

/// Those of the study and its recording, then those of its system.
std::vector<Settings> study_settings(const StudyDescription& description, const System& trained);

}  // namespace somato
