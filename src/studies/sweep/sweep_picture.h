#pragma once

#include <string>

#include "studies/sweep/sweep_results.h"

namespace somato {

/// The results of a sweep as a picture in SVG: a panel for each claim, in it a strip for each
/// unknown with the share of the pairs in which the claim holds at each of its values.
std::string sweep_picture(const SweepResults& results);

}  // namespace somato
