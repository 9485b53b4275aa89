#pragma once

#include <vector>

#include "somato/core/samples.h"
#include "somato/maps/labels.h"

namespace somato {

/// For each element of the samples, the share of its variance that lies between the classes: the
/// sum of squares of the class means around the mean of all, divided by that of the samples, 0 to 1
/// (the correlation ratio; Fisher 1925). 0 for an element with a single value.
std::vector<double> explained_shares(const Samples& samples, const Classes& classes);

}  // namespace somato
