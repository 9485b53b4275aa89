#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/samples.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// The squared Euclidean distance of two signals of equal size; of sparse ones through their inner
/// products, so that equal ones may come out a rounding error away from 0.
double squared_distance(const SignalView& a, const SignalView& b);

/// The Manhattan distance of two signals of equal size, both dense or both sparse, summed in the
/// order of their elements.
double manhattan_distance(const SignalView& a, const SignalView& b);

/// The training sample nearest to `samples[test]` in Euclidean distance, the first in a tie: its
/// class is the prediction of the baseline for the test sample. Throws InvalidArgument without
/// training samples.
std::size_t nearest_neighbour(const Samples& samples, const std::vector<std::size_t>& training,
                              std::size_t test);

/// The same for each of `tests`, in Euclidean or Manhattan distance. Throws InvalidArgument for
/// other distances as well.
std::vector<std::size_t> nearest_neighbours(const Samples& samples,
                                            const std::vector<std::size_t>& training,
                                            const std::vector<std::size_t>& tests,
                                            Similarity distance = Similarity::kEuclidean);

}  // namespace somato
