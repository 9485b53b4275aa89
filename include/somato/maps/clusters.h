#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/maps/som.h"

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

/// How neurons are clustered.
enum class ClusterMethod {
  /// Merges the two clusters whose union increases the sum of squared distances from the means
  /// least (Ward, Hierarchical grouping to optimize an objective function, Journal of the American
  /// Statistical Association 58, 1963). Heights are sqrt(2 a b / (a + b)) |mean a - mean b| for
  /// clusters of a and b neurons, as in SciPy and scikit-learn.
  kWard,

  /// Lloyd's k-means, which starts from the means of Ward's clusters and therefore needs no random
  /// numbers.
  kKMeans,

  /// The catchment basins of the U-matrix: a neuron belongs to the basin of the lowest neighbour
  /// that the rising flood has reached before (Vincent and Soille, Watersheds in digital spaces,
  /// IEEE Transactions on Pattern Analysis and Machine Intelligence 13, 1991; without lines between
  /// basins).
  kWatershed,
};

/// The measure of clusters that selects their number.
enum class ClusterIndex {
  kDaviesBouldin,  ///< The lowest is selected (Davies and Bouldin 1979).
  kSilhouette,     ///< The highest mean is selected (Rousseeuw 1987).
};

template <>
struct Choices<ClusterMethod> {
  static const std::vector<std::pair<ClusterMethod, std::string>>& all();
};
template <>
struct Choices<ClusterIndex> {
  static const std::vector<std::pair<ClusterIndex, std::string>>& all();
};

/// Parameters of cluster_neurons(); declarations() gives the meaning and range of each.
struct ClusterParameters {
  ClusterMethod method = ClusterMethod::kWard;
  std::optional<std::size_t> count = {};
  ClusterIndex index = ClusterIndex::kDaviesBouldin;
  std::optional<std::size_t> most_clusters = {};
  bool by_hits = false;
  bool connected = false;

  static const Declarations<ClusterParameters>& declarations();
};

/// Clusters the neurons of a map by their weights: by Euclidean distances, as Ward's method and
/// k-means require, whatever the distance of the map is; the watershed by u_matrix().
///
/// With `by_hits`, a neuron counts as many times as it wins samples, `hits`. A neuron that wins
/// none has no influence then, and joins the cluster of the nearest neuron that wins one; in a
/// hierarchy it does so first, at height 0. Otherwise all neurons count alike, whether they win
/// samples or not.
///
/// Without `count`, the number with the best index from 2 to `most_clusters` is selected, the lower
/// one in a tie; weights that are equal up to rounding, 2^-18 of the greatest, are one cluster, and
/// the watershed gives as many as the U-matrix has basins. With `count`, it fills the shallowest
/// basin into its lowest neighbour until so many are left.
///
/// Errors (kUsage): more clusters than neurons that count, or than basins; no hits with `by_hits`;
/// a parameter that has no effect with the method. Throws InvalidArgument if `hits` has another
/// size. Takes neurons^2 x features operations.
Result<Clusters> cluster_neurons(const Som& som, const ClusterParameters& parameters = {},
                                 const std::vector<std::size_t>& hits = {});

/// The Davies-Bouldin index: the mean over the clusters of the greatest (s_i + s_j) / |m_i - m_j|,
/// where m is the mean of a cluster's weights and s the mean distance of its neurons from it.
/// Infinite if two clusters have the same mean, NaN for fewer than two clusters. `hits` as for
/// `by_hits`, or empty. Throws InvalidArgument if sizes differ.
double davies_bouldin_index(const Som& som, const Clusters& clusters,
                            const std::vector<std::size_t>& hits = {});

/// The mean silhouette of the neurons: (b - a) / max(a, b), where a is the mean distance from the
/// other neurons of the cluster and b the least mean distance from the neurons of another cluster;
/// 0 for a neuron that is a cluster. NaN for fewer than two clusters. As above otherwise.
double silhouette_index(const Som& som, const Clusters& clusters,
                        const std::vector<std::size_t>& hits = {});

/// The clusters that the first merges give, until `count` are left. Throws InvalidArgument unless
/// `count` is from 1 to the number of neurons, and there are merges for all.
std::vector<std::size_t> cut_merges(const std::vector<ClusterMerge>& merges, std::size_t count);

/// The samples of a cluster.
struct ClusterSamples {
  std::size_t neurons = 0;  ///< The number of its neurons.
  std::size_t regions = 0;  ///< The number of its parts that are connected on the grid.
  std::size_t samples = 0;
  std::optional<std::size_t> name;  ///< The class of most of its samples, the lowest in a tie.
  double purity = 0.0;              ///< The share of its samples with that class.
};

/// The samples of each cluster; `winners[i]` and `classes[i]` belong to sample i.
/// `classes` may be empty. Throws InvalidArgument if sizes differ or a winner is not on the map.
std::vector<ClusterSamples> samples_of_clusters(const Grid& grid, const Clusters& clusters,
                                                const std::vector<std::size_t>& winners,
                                                const std::vector<std::size_t>& classes = {});

}  // namespace somato
