#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/core/matrix.h"

namespace somato {

/// Where vectors lie along the direction in which they differ most (the first principal component),
/// up to sign and scale, from their inner products, n x n. All 0 when the vectors are equal.
std::vector<double> principal_positions(const Matrix<double>& inner_products);

/// Things of one kind, each with a number and a place on a line.
struct OrderedGroup {
  std::vector<double> numbers;
  std::vector<double> positions;
};

/// How well numbers are in the order of the places.
struct RankOrder {
  double correlation = 0.0;     ///< Absolute rank correlation, the mean over the groups: 0 to 1.
  double shuffled = 0.0;        ///< Its mean when the numbers are shuffled within each group.
  double shuffled_share = 1.0;  ///< Share of the shufflings, and the true order counted as one of
                                ///< them, that come as high: what luck would give.
};

/// Throws InvalidArgument without groups.
RankOrder rank_order(const std::vector<OrderedGroup>& groups, std::size_t shuffles,
                     std::uint64_t seed);

}  // namespace somato
