#pragma once

#include <cstddef>
#include <vector>

#include "maps/analysis/weighted_points.h"
#include "somato/maps/clusters.h"

namespace somato {

/// Ward's hierarchy of points, in the order of heights. Of several equally near pairs, the one of
/// the lower numbers is merged. Takes points^2 x columns operations, and memory for the points.
std::vector<ClusterMerge> ward_merges(const WeightedPoints& points);

/// The same, but only clusters that have neighbours in each other are merged, as long as there are
/// such, in the order of the merges. `neighbours[i]` are those of point i.
std::vector<ClusterMerge> connected_ward_merges(
    const WeightedPoints& points, const std::vector<std::vector<std::size_t>>& neighbours);

}  // namespace somato
