#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/samples.h"

namespace somato {

/// The Euclidean distance of every sample from every other: count x count.
Matrix<double> distances_between(const Samples& samples, std::size_t threads);

/// Share of samples whose nearest sample has the same class.
struct NeighbourAccuracy {
  double accuracy = 0.0;  ///< Share of the samples whose nearest candidate has their class.
  double chance = 0.0;    ///< The same, expected for a randomly drawn candidate.
};

/// Each sample's candidates are the samples of other groups; the nearest is the first in a tie.
/// With a group for each sample that is leaving one out. Throws InvalidArgument unless there is a
/// class and a group a sample, and two groups.
NeighbourAccuracy neighbour_accuracy(const Matrix<double>& distances,
                                     const std::vector<std::size_t>& classes,
                                     const std::vector<std::size_t>& groups);

/// The mean distance of samples of different classes, divided by that of samples of one class;
/// nothing when there are no such pairs, or all those within classes are 0 apart. Throws
/// InvalidArgument unless there is a class a sample.
std::optional<double> between_to_within(const Matrix<double>& distances,
                                        const std::vector<std::size_t>& classes);

}  // namespace somato
