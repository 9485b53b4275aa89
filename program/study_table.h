#pragma once

#include <string>

#include "somato/studies/results.h"

namespace somato::program {

/// What a study has found, for a person: the metrics of each protocol, why one is missing, and what
/// may help a map that is much worse than the nearest known sample.
std::string study_table(const StudyResults& results);

}  // namespace somato::program
