#pragma once

#include <string>

#include "somato/studies/study.h"

namespace somato {

/// The winners of all explorations on the map trained on all of them, as SVG.
std::string winners_picture(const StudyDescription& description, const StudyOutcome& outcome);

}  // namespace somato
