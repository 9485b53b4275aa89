#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/maps/som_parameters.h"
#include "studies/codes/views.h"

namespace somato {

/// The neighbourhoods of a sense.
struct Neighbourhoods {
  /// For every pair of explorations the rank of the second for the first, averaged over the
  /// candidates of the sense; see add_ranks().
  PerView<Matrix<float>> ranks;
  bool has_halves = true;  ///< Whether every exploration has several frames.
  /// The least imbalance with which a sense without halves predicts itself.
  double least = 0.0;
};

/// Squared distances of all explorations in a representation, divided by its spread, or Manhattan
/// distances, divided by the root of the spread; and the numbers of the senses that it uses.
struct Part {
  std::vector<std::size_t> senses;
  PerView<Matrix<float>> distances;
  Similarity similarity =
      Similarity::kEuclidean;  ///< Or Manhattan, whose distances are not squared.
};

/// A part of a combination, whose vectors are multiplied by the weight.
struct WeightedPart {
  const Part* part = nullptr;
  double weight = 1.0;
};

/// The prediction of each sense by a representation: the information imbalance from whole
/// explorations for a sense that it does not use, and the mean over kSplits for one that it uses. A
/// sense without halves is predicted from whole explorations, but not better than its `least`
/// if it is used. `nearest` are the nearest neighbours of the representation in each view.
std::vector<double> imbalances(const PerView<std::vector<std::uint32_t>>& nearest,
                               std::span<const std::size_t> used,
                               std::span<const Neighbourhoods> senses);

/// The same for a combination, in which only the parts that use the sense are seen in a half.
std::vector<double> imbalances(std::span<const WeightedPart> parts,
                               std::span<const Neighbourhoods> senses);

/// The mean of the imbalances; lower is better.
double score_of(std::span<const double> imbalances);

/// The errors of a combination for each exploration, by which combinations of different senses are
/// compared: as the imbalances, but every sense with halves is predicted from one half to the
/// other, also if no part uses it, so that all combinations predict the same ranks; and without
/// `least`. If all senses are used and have halves, score_of(imbalances()) is their mean.
std::vector<double> errors_of(std::span<const WeightedPart> parts,
                              std::span<const Neighbourhoods> senses);

}  // namespace somato
