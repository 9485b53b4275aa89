#include "maps/analysis/cluster_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace somato {
namespace {

// The weighted mean distance of the points of each cluster from its mean.
std::vector<double> spreads(const WeightedPoints& points, const PointClusters& clusters,
                            const ClusterMeans& means) {
  std::vector<double> sums(means.weights.size());
  for (std::size_t i = 0; i < points.count(); ++i) {
    const double square = squared_distance(points.rows.row(i), means.rows.row(clusters[i]));
    sums[clusters[i]] += points.weights[i] * std::sqrt(square);
  }
  for (std::size_t c = 0; c < sums.size(); ++c) sums[c] /= means.weights[c];
  return sums;
}

// The silhouette of point i, whose distances from the points of cluster c sum up to sums[c].
double silhouette_of(const std::vector<double>& sums, const std::vector<double>& weights,
                     std::size_t own) {
  if (weights[own] <= 1.0) return 0.0;
  const double inside = sums[own] / (weights[own] - 1.0);
  double outside = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < sums.size(); ++c) {
    if (c != own) outside = std::min(outside, sums[c] / weights[c]);
  }
  const double greater = std::max(inside, outside);
  return greater > 0.0 ? (outside - inside) / greater : 0.0;
}

std::vector<double> weights_of(const WeightedPoints& points, const PointClusters& clusters,
                               std::size_t count) {
  std::vector<double> weights(count);
  for (std::size_t i = 0; i < points.count(); ++i) weights[clusters[i]] += points.weights[i];
  return weights;
}

}  // namespace

double davies_bouldin(const WeightedPoints& points, const PointClusters& clusters,
                      std::size_t count) {
  if (count < 2) return std::numeric_limits<double>::quiet_NaN();
  const ClusterMeans means(points, clusters, count);
  const std::vector<double> spread = spreads(points, clusters, means);
  double sum = 0.0;
  for (std::size_t a = 0; a < count; ++a) {
    double greatest = 0.0;
    for (std::size_t b = 0; b < count; ++b) {
      if (a == b) continue;
      const double apart = std::sqrt(squared_distance(means.rows.row(a), means.rows.row(b)));
      const double ratio =
          apart > 0.0 ? (spread[a] + spread[b]) / apart : std::numeric_limits<double>::infinity();
      greatest = std::max(greatest, ratio);
    }
    sum += greatest;
  }
  return sum / static_cast<double>(count);
}

std::vector<double> silhouettes(const WeightedPoints& points,
                                const std::vector<PointClusters>& clusterings,
                                const std::vector<std::size_t>& counts) {
  std::vector<double> totals(clusterings.size());
  std::vector<std::vector<double>> weights;
  weights.reserve(clusterings.size());
  for (std::size_t k = 0; k < clusterings.size(); ++k) {
    weights.push_back(weights_of(points, clusterings[k], counts[k]));
  }
  std::vector<double> distances(points.count());
  for (std::size_t i = 0; i < points.count(); ++i) {
    for (std::size_t j = 0; j < points.count(); ++j) {
      distances[j] =
          points.weights[j] * std::sqrt(squared_distance(points.rows.row(i), points.rows.row(j)));
    }
    for (std::size_t k = 0; k < clusterings.size(); ++k) {
      std::vector<double> sums(counts[k]);
      for (std::size_t j = 0; j < distances.size(); ++j) sums[clusterings[k][j]] += distances[j];
      totals[k] += points.weights[i] * silhouette_of(sums, weights[k], clusterings[k][i]);
    }
  }
  const double all = std::accumulate(points.weights.begin(), points.weights.end(), 0.0);
  for (std::size_t k = 0; k < totals.size(); ++k) {
    totals[k] = counts[k] < 2 ? std::numeric_limits<double>::quiet_NaN() : totals[k] / all;
  }
  return totals;
}

std::size_t best_clustering(const WeightedPoints& points,
                            const std::vector<PointClusters>& clusterings,
                            const std::vector<std::size_t>& counts, ClusterIndex index) {
  std::vector<double> costs;
  if (index == ClusterIndex::kSilhouette) {
    costs = silhouettes(points, clusterings, counts);
    for (double& cost : costs) cost = -cost;
  } else {
    for (std::size_t k = 0; k < clusterings.size(); ++k) {
      costs.push_back(davies_bouldin(points, clusterings[k], counts[k]));
    }
  }
  std::size_t best = 0;
  for (std::size_t k = 1; k < costs.size(); ++k) {
    if (costs[k] < costs[best] || (std::isnan(costs[best]) && !std::isnan(costs[k]))) best = k;
  }
  return best;
}

}  // namespace somato
