#pragma once

#include <span>
#include <vector>

#include "somato/codes/spectrum.h"

namespace somato {

/// The `parameters.bands` + 1 edges of the bands from `parameters.low` to `high`.
std::vector<double> band_edges(const SpectrumParameters& parameters, double high);

/// The content of `bins` between the positions `low` and `high` >= `low` >= 0, in units of bins:
/// bin k is distributed uniformly from k - 1/2 to k + 1/2, so that an edge divides a bin at its
/// position, a band may be narrower than a bin, and nothing is counted twice.
double sum_between(std::span<const double> bins, double low, double high);

}  // namespace somato
