#pragma once

#include <vector>

#include "somato/graph/system.h"
#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"

namespace somato {

/// Every setting of the modules and phases of a system, as results.json has them: `module.NAME` and
/// `phase.N`, defaults written out. What a map leaves automatic stands as it was decided where the
/// map has learned.
std::vector<Settings> system_settings(const System& system);

/// Those of the study and its recording, then those of its system.
std::vector<Settings> study_settings(const StudyDescription& description, const System& trained);

}  // namespace somato
