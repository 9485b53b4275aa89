#pragma once

#include <cstddef>

#include "maps/analysis/weighted_points.h"

namespace somato {

/// Lloyd's k-means from the means of `start`, which are `count` clusters that all have points. A
/// point that is equally near to several means stays where it is if it can, or goes to the lowest;
/// a cluster never loses its last point.
PointClusters k_means(const WeightedPoints& points, PointClusters start, std::size_t count);

}  // namespace somato
