#include "somato/maps/som_features.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "maps/analysis/cluster_index.h"
#include "maps/analysis/ward.h"
#include "somato/core/check.h"
#include "somato/maps/clusters.h"
#include "somato/maps/som_quality.h"

namespace somato {
namespace {

// The planes that vary, with mean 0 and length 1, and their features.
struct ScaledPlanes {
  WeightedPoints planes;
  std::vector<std::size_t> features;
  std::vector<std::size_t> constant;
};

// Scales to mean 0 and length 1; returns false for a constant plane.
bool scale_plane(std::vector<double>& plane) {
  const auto [low, high] = std::minmax_element(plane.begin(), plane.end());
  if (!differ(*low, *high)) return false;
  double mean = 0.0;
  for (const double value : plane) mean += value / static_cast<double>(plane.size());
  double squares = 0.0;
  for (double& value : plane) {
    value -= mean;
    squares += value * value;
  }
  for (double& value : plane) value /= std::sqrt(squares);
  return true;
}

ScaledPlanes scaled_planes(const Som& som) {
  ScaledPlanes scaled;
  std::vector<double> values;
  for (std::size_t d = 0; d < som.input_size(); ++d) {
    std::vector<double> plane = component_plane(som, d);
    const bool varies = scale_plane(plane);
    (varies ? scaled.features : scaled.constant).push_back(d);
    if (varies) values.insert(values.end(), plane.begin(), plane.end());
  }
  const std::size_t count = scaled.features.size();
  scaled.planes = {Matrix<double>(count, som.neurons(), std::move(values)),
                   std::vector<double>(count, 1.0)};
  return scaled;
}

// The points of a hierarchy from left to right; of two clusters, the one of the lowest point first.
std::vector<std::size_t> leaves(const std::vector<ClusterMerge>& merges) {
  const std::size_t points = merges.size() + 1;
  std::vector<std::vector<std::size_t>> members(points);
  for (std::size_t i = 0; i < points; ++i) members[i] = {i};
  for (const ClusterMerge& merge : merges) {
    auto first = std::move(members[merge.first]);
    auto second = std::move(members[merge.second]);
    const auto lowest = [](const std::vector<std::size_t>& of) {
      return *std::min_element(of.begin(), of.end());
    };
    if (lowest(second) < lowest(first)) std::swap(first, second);
    first.insert(first.end(), second.begin(), second.end());
    members.push_back(std::move(first));
  }
  return members.back();
}

// As many groups as the silhouette selects, because the Davies-Bouldin index prefers groups of one
// plane when there are few.
PointClusters plane_groups(const WeightedPoints& planes, const std::vector<ClusterMerge>& merges) {
  if (planes.count() < 3) return cut_merges(merges, planes.count());
  constexpr std::size_t kMostGroups = 20;
  std::vector<PointClusters> tried;
  std::vector<std::size_t> counts;
  for (std::size_t count = 2; count <= std::min(planes.count() - 1, kMostGroups); ++count) {
    tried.push_back(cut_merges(merges, count));
    counts.push_back(count);
  }
  return tried[best_clustering(planes, tried, counts, ClusterIndex::kSilhouette)];
}

}  // namespace

PlaneOrder order_planes(const Som& som) {
  require(som.input_size() <= kMostPlanes, "order_planes: the map has too many features");
  const ScaledPlanes scaled = scaled_planes(som);
  PlaneOrder order;
  order.group_of_feature.assign(som.input_size(), 0);
  if (!scaled.features.empty()) {
    const std::vector<ClusterMerge> merges = ward_merges(scaled.planes);
    const PointClusters groups = plane_groups(scaled.planes, merges);
    PointClusters in_order;
    for (const std::size_t leaf : leaves(merges)) {
      order.order.push_back(scaled.features[leaf]);
      in_order.push_back(groups[leaf]);
    }
    const PointClusters numbered = numbered_in_order(in_order);
    for (std::size_t i = 0; i < numbered.size(); ++i) {
      order.group_of_feature[order.order[i]] = numbered[i];
      order.groups = std::max(order.groups, numbered[i] + 1);
    }
  }
  for (const std::size_t feature : scaled.constant) {
    order.order.push_back(feature);
    order.group_of_feature[feature] = order.groups;
  }
  if (!scaled.constant.empty()) ++order.groups;
  return order;
}

}  // namespace somato
