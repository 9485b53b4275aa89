#include "maps/analysis/weighted_points.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace somato {

ClusterMeans::ClusterMeans(const WeightedPoints& points, const PointClusters& clusters,
                           std::size_t count)
    : rows(count, points.rows.columns()), weights(count) {
  for (std::size_t i = 0; i < points.count(); ++i) {
    weights[clusters[i]] += points.weights[i];
    const std::span<double> sum = rows.row(clusters[i]);
    for (std::size_t d = 0; d < sum.size(); ++d) sum[d] += points.weights[i] * points.rows(i, d);
  }
  for (std::size_t c = 0; c < count; ++c) {
    if (weights[c] == 0.0) continue;
    for (double& value : rows.row(c)) value /= weights[c];
  }
}

bool differ(double low, double high) {
  return high - low > kRoundingOfWeights * std::max(std::abs(low), std::abs(high));
}

double squared_distance(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t d = 0; d < a.size(); ++d) {
    const double difference = a[d] - b[d];
    sum = std::fma(difference, difference, sum);
  }
  return sum;
}

PointClusters numbered_in_order(const PointClusters& clusters) {
  std::map<std::size_t, std::size_t> numbers;
  PointClusters numbered;
  numbered.reserve(clusters.size());
  for (const std::size_t cluster : clusters) {
    numbered.push_back(numbers.emplace(cluster, numbers.size()).first->second);
  }
  return numbered;
}

}  // namespace somato
