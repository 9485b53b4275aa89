#pragma once

#include <string>

#include "somato/studies/results.h"

namespace somato::program {

/// The metrics shown in a table; results.json contains all of them.
enum class ShownMetrics { kMain, kAll };

/// A readable table of a study's results: the metrics of each protocol, the reason for a missing
/// one, and advice for a map far below the nearest-neighbour baseline.
std::string study_table(const PartResults& results, ShownMetrics shown);

}  // namespace somato::program
