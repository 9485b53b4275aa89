#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/matrix.h"

namespace somato {

/// Points that are clustered; each counts as often as its weight, above 0.
struct WeightedPoints {
  Matrix<double> rows;
  std::vector<double> weights;

  std::size_t count() const { return rows.rows(); }
};

/// A cluster of each point, below `count`.
using PointClusters = std::vector<std::size_t>;

/// The weighted means of clusters.
struct ClusterMeans {
  Matrix<double> rows;
  std::vector<double> weights;

  ClusterMeans(const WeightedPoints& points, const PointClusters& clusters, std::size_t count);
};

/// The share of the greatest absolute weight of a column by which rounding may change its weights:
/// online training moves those of a constant column by some units in the last place.
inline constexpr double kRoundingOfWeights = 0x1p-18;

/// Whether numbers from `low` to `high` differ by more than training in single precision rounds: by
/// more than kRoundingOfWeights of the greatest absolute number.
bool differ(double low, double high);

double squared_distance(std::span<const double> a, std::span<const double> b);

/// The same clusters, numbered in the order of their first points.
PointClusters numbered_in_order(const PointClusters& clusters);

}  // namespace somato
