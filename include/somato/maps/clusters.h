#pragma once

#include <cstddef>
#include <vector>

namespace somato {

/// Two clusters that hierarchical clustering has merged, as in SciPy's linkage matrix: of n
/// neurons, the clusters below n are the neurons, and n + i is the cluster of merge i.
struct ClusterMerge {
  std::size_t first = 0;    ///< The lower number.
  std::size_t second = 0;   ///< The higher number.
  double height = 0.0;      ///< The distance of the two clusters, at least 0.
  std::size_t neurons = 0;  ///< The number of neurons in the merged cluster.

  bool operator==(const ClusterMerge&) const = default;
};

/// Clusters of the neurons of a map.
struct Clusters {
  /// The cluster of each neuron, from 0, numbered in the order of their first neurons.
  std::vector<std::size_t> of_neuron;

  /// The number of clusters.
  std::size_t count = 0;

  /// The n - 1 merges of n neurons in their order: the data of a dendrogram. No height is less than
  /// the one before unless merges are restricted to adjacent clusters. Empty unless the clustering
  /// is hierarchical.
  std::vector<ClusterMerge> merges;
};

}  // namespace somato
