#include "maps/analysis/k_means.h"

#include <vector>

namespace somato {
namespace {

std::size_t nearest_mean(const ClusterMeans& means, std::span<const double> point,
                         std::size_t current) {
  std::size_t nearest = current;
  double least = squared_distance(point, means.rows.row(current));
  for (std::size_t c = 0; c < means.weights.size(); ++c) {
    const double distance = squared_distance(point, means.rows.row(c));
    if (distance < least) {
      least = distance;
      nearest = c;
    }
  }
  return nearest;
}

}  // namespace

PointClusters k_means(const WeightedPoints& points, PointClusters start, std::size_t count) {
  // Each round decreases the sum of squares, so that rounds end; the limit is that of scikit-learn.
  constexpr int kMostRounds = 300;
  PointClusters clusters = std::move(start);
  std::vector<std::size_t> sizes(count);
  for (const std::size_t cluster : clusters) ++sizes[cluster];
  bool changed = true;
  for (int round = 0; round < kMostRounds && changed; ++round) {
    changed = false;
    const ClusterMeans means(points, clusters, count);
    for (std::size_t i = 0; i < points.count(); ++i) {
      if (sizes[clusters[i]] == 1) continue;
      const std::size_t nearest = nearest_mean(means, points.rows.row(i), clusters[i]);
      if (nearest == clusters[i]) continue;
      --sizes[clusters[i]];
      ++sizes[nearest];
      clusters[i] = nearest;
      changed = true;
    }
  }
  return clusters;
}

}  // namespace somato
