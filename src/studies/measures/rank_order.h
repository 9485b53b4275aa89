#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/core/matrix.h"

namespace somato {

/// The positions of vectors along the direction of greatest variance (the first principal
/// component), up to sign and scale, from their inner products, n x n. All 0 if the vectors are
/// equal.
std::vector<double> principal_positions(const Matrix<double>& inner_products);

/// Things of one kind, each with a number and a place on a line.
struct OrderedGroup {
  std::vector<double> numbers;
  std::vector<double> positions;
};

/// The correlation of numbers with the order of the places.
struct RankOrder {
  double correlation = 0.0;     ///< Absolute rank correlation, the mean over the groups: 0 to 1.
  double shuffled = 0.0;        ///< Its mean when the numbers are shuffled within each group.
  double shuffled_share = 1.0;  ///< Share of the shuffles, with the true order counted as one of
                                ///< them, that have an equal or higher value: the value by chance.
};

/// Throws InvalidArgument without groups.
RankOrder rank_order(const std::vector<OrderedGroup>& groups, std::size_t shuffles,
                     std::uint64_t seed);

}  // namespace somato
