#pragma once

#include <cstddef>
#include <vector>

#include "maps/analysis/weighted_points.h"
#include "somato/maps/clusters.h"

namespace somato {

/// davies_bouldin_index() of points in `count` clusters.
double davies_bouldin(const WeightedPoints& points, const PointClusters& clusters,
                      std::size_t count);

/// silhouette_index() of points in several ways of clustering, each with its number of clusters.
std::vector<double> silhouettes(const WeightedPoints& points,
                                const std::vector<PointClusters>& clusterings,
                                const std::vector<std::size_t>& counts);

/// The place of the best clustering, the first in a tie. Those that have no index are not selected
/// unless all have none.
std::size_t best_clustering(const WeightedPoints& points,
                            const std::vector<PointClusters>& clusterings,
                            const std::vector<std::size_t>& counts, ClusterIndex index);

}  // namespace somato
