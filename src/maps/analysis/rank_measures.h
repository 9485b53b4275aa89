#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// Measures that compare the nearest samples of each sample with the nearest ones on the map.
struct RankMeasures {
  double trustworthiness = 0.0;
  double continuity = 0.0;
  double neighbourhood_preservation = 0.0;
};

/// Compares the `neighbours` nearest samples; `winners[i]` is the neuron of sample i. Samples at
/// equal distances, as all samples of one neuron are on the map, are put in a random order: the
/// result is its expected value over all orders, which needs no random numbers. All are NaN unless
/// there are more than 2 `neighbours` samples, and at least 1 neighbour. Takes samples^2 x features
/// operations.
RankMeasures measure_ranks(const Som& som, const Samples& samples,
                           const std::vector<std::size_t>& winners, std::size_t neighbours,
                           std::size_t threads);

}  // namespace somato
