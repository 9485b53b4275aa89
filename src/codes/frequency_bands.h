#pragma once

#include <span>
#include <vector>

#include "somato/codes/spectrum_parameters.h"

namespace somato {

/// The `parameters.bands` + 1 edges of the bands from `parameters.low` to `high`.
std::vector<double> band_edges(const SpectrumParameters& parameters, double high);

/// What `bins` hold between the places `low` and `high` >= `low` >= 0, counted in bins: bin k is
/// spread evenly from k - 1/2 to k + 1/2, so that an edge cuts bins where it lies, a band may be
/// narrower than a bin, and nothing is counted twice.
double sum_between(std::span<const double> bins, double low, double high);

}  // namespace somato
