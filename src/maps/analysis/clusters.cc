#include "somato/maps/clusters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "maps/analysis/cluster_index.h"
#include "maps/analysis/k_means.h"
#include "maps/analysis/ward.h"
#include "maps/analysis/watershed.h"
#include "maps/analysis/weighted_points.h"
#include "somato/core/check.h"
#include "somato/maps/som_quality.h"

namespace somato {
namespace {

// The neurons that count, as points, and for each neuron the place of the point that it joins.
struct CountedNeurons {
  WeightedPoints points;
  std::vector<std::size_t> neurons;
  std::vector<std::size_t> point_of_neuron;
};

Matrix<double> weights_in_double(const Som& som, const std::vector<std::size_t>& neurons) {
  Matrix<double> rows(neurons.size(), som.weights().columns());
  for (std::size_t i = 0; i < neurons.size(); ++i) {
    for (std::size_t d = 0; d < rows.columns(); ++d) {
      rows(i, d) = double{som.weights()(neurons[i], d)};
    }
  }
  return rows;
}

std::size_t nearest_point(const WeightedPoints& points, std::span<const double> row) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.count(); ++i) {
    const double distance = squared_distance(points.rows.row(i), row);
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

CountedNeurons counted_neurons(const Som& som, const std::vector<std::size_t>& hits) {
  require(hits.empty() || hits.size() == som.neurons(), "clusters: each neuron needs its hits");
  CountedNeurons counted;
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    if (!hits.empty() && hits[neuron] == 0) continue;
    counted.neurons.push_back(neuron);
    counted.points.weights.push_back(hits.empty() ? 1.0 : static_cast<double>(hits[neuron]));
  }
  counted.points.rows = weights_in_double(som, counted.neurons);
  for (std::size_t neuron = 0, next = 0; neuron < som.neurons(); ++neuron) {
    const bool counts = next < counted.neurons.size() && counted.neurons[next] == neuron;
    counted.point_of_neuron.push_back(
        counts ? next++ : nearest_point(counted.points, weights_in_double(som, {neuron}).row(0)));
  }
  return counted;
}

// The neighbours of each point among the points. Neurons that do not count belong to their points.
std::vector<std::vector<std::size_t>> neighbours_of_points(const Grid& grid,
                                                           const CountedNeurons& counted) {
  std::vector<std::vector<std::size_t>> neighbours(counted.points.count());
  for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
    const std::size_t point = counted.point_of_neuron[neuron];
    for (const std::size_t other : grid.neighbours(neuron)) {
      neighbours[point].push_back(counted.point_of_neuron[other]);
    }
  }
  return neighbours;
}

std::vector<std::vector<std::size_t>> neighbours_of_neurons(const Grid& grid) {
  std::vector<std::vector<std::size_t>> neighbours(grid.size());
  for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
    neighbours[neuron] = grid.neighbours(neuron);
  }
  return neighbours;
}

std::size_t number_of(const std::vector<std::size_t>& clusters) {
  return clusters.empty() ? 0 : *std::max_element(clusters.begin(), clusters.end()) + 1;
}

// The merges of all neurons: those that do not count join their points first.
std::vector<ClusterMerge> merges_of_neurons(const std::vector<ClusterMerge>& merges,
                                            const CountedNeurons& counted) {
  const std::size_t neurons = counted.point_of_neuron.size();
  std::vector<ClusterMerge> all;
  std::vector<std::size_t> number = counted.neurons;  // of each cluster of points
  std::vector<std::size_t> size(counted.neurons.size(), 1);
  for (std::size_t neuron = 0; neuron < neurons; ++neuron) {
    const std::size_t point = counted.point_of_neuron[neuron];
    if (counted.neurons[point] == neuron) continue;
    const auto [low, high] = std::minmax({neuron, number[point]});
    all.push_back({low, high, 0.0, ++size[point]});
    number[point] = neurons + all.size() - 1;
  }
  for (const ClusterMerge& merge : merges) {
    const auto [low, high] = std::minmax({number[merge.first], number[merge.second]});
    size.push_back(size[merge.first] + size[merge.second]);
    number.push_back(neurons + all.size());
    all.push_back({low, high, merge.height, size.back()});
  }
  return all;
}

bool are_equal(const WeightedPoints& points) {
  for (std::size_t d = 0; d < points.rows.columns(); ++d) {
    double low = points.rows(0, d);
    double high = low;
    for (std::size_t i = 1; i < points.count(); ++i) {
      low = std::min(low, points.rows(i, d));
      high = std::max(high, points.rows(i, d));
    }
    if (differ(low, high)) return false;
  }
  return true;
}

std::size_t most_to_try(const ClusterParameters& parameters, std::size_t points) {
  const auto root = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(points))));
  // As many clusters as points would have the best index for any points.
  return std::min(parameters.most_clusters.value_or(std::max<std::size_t>(2, root)), points - 1);
}

PointClusters clustered(const WeightedPoints& points, const std::vector<ClusterMerge>& merges,
                        ClusterMethod method, std::size_t count) {
  PointClusters clusters = cut_merges(merges, count);
  if (method != ClusterMethod::kKMeans) return clusters;
  return k_means(points, std::move(clusters), count);
}

PointClusters best_clusters(const WeightedPoints& points, const std::vector<ClusterMerge>& merges,
                            const ClusterParameters& parameters) {
  if (are_equal(points)) return PointClusters(points.count(), 0);
  if (points.count() == 2) return cut_merges(merges, 2);
  std::vector<PointClusters> tried;
  std::vector<std::size_t> counts;
  for (std::size_t count = 2; count <= most_to_try(parameters, points.count()); ++count) {
    tried.push_back(clustered(points, merges, parameters.method, count));
    counts.push_back(count);
  }
  return tried[best_clustering(points, tried, counts, parameters.index)];
}

Result<void> check_effect(const ClusterParameters& p) {
  const bool is_ward = p.method == ClusterMethod::kWard;
  const bool is_watershed = p.method == ClusterMethod::kWatershed;
  const std::string reason = "method is " + choice_name(p.method);
  if (p.connected && !is_ward) return fail(without_effect("connected", reason, "connected"));
  if (p.by_hits && is_watershed) return fail(without_effect("by_hits", reason, "by_hits"));
  const bool chooses = p.most_clusters || p.index != ClusterParameters().index;
  const std::string name = p.most_clusters ? "most_clusters" : "index";
  if (chooses && is_watershed) return fail(without_effect(name, reason, name));
  if (chooses && p.count) return fail(without_effect(name, "the number is given", name));
  return {};
}

Result<void> check_count(std::optional<std::size_t> count, std::size_t most,
                         const std::string& what) {
  if (count.value_or(1) >= 1 && count.value_or(1) <= most) return {};
  return fail(ErrorKind::kUsage,
              fmt::format("there are {} clusters to form, but only {} {}", *count, most, what),
              "count", fmt::format("use a number from 1 to {}", most));
}

Result<Clusters> watershed(const Som& som, std::optional<std::size_t> count) {
  const std::vector<double> heights = u_matrix(som);
  const auto neighbours = neighbours_of_neurons(som.grid());
  const std::size_t most = number_of(basins(heights, neighbours));
  SOMATO_TRY_VOID(check_count(count, most, "basins of the U-matrix"));
  Clusters clusters;
  clusters.of_neuron = basins(heights, neighbours, count);
  clusters.count = number_of(clusters.of_neuron);
  return clusters;
}

std::vector<std::size_t> spread_to_neurons(const PointClusters& of_point,
                                           const CountedNeurons& counted) {
  std::vector<std::size_t> of_neuron;
  of_neuron.reserve(counted.point_of_neuron.size());
  for (const std::size_t point : counted.point_of_neuron) of_neuron.push_back(of_point[point]);
  return numbered_in_order(of_neuron);
}

PointClusters clusters_of_points(const Clusters& clusters, const CountedNeurons& counted) {
  require(clusters.of_neuron.size() == counted.point_of_neuron.size(),
          "clusters: each neuron needs a cluster");
  PointClusters of_points;
  for (const std::size_t neuron : counted.neurons) of_points.push_back(clusters.of_neuron[neuron]);
  return numbered_in_order(of_points);  // a cluster of neurons without hits has no index
}

}  // namespace

const std::vector<std::pair<ClusterMethod, std::string>>& Choices<ClusterMethod>::all() {
  static const std::vector<std::pair<ClusterMethod, std::string>> choices{
      {ClusterMethod::kWard, "ward"},
      {ClusterMethod::kKMeans, "k_means"},
      {ClusterMethod::kWatershed, "watershed"}};
  return choices;
}

const std::vector<std::pair<ClusterIndex, std::string>>& Choices<ClusterIndex>::all() {
  static const std::vector<std::pair<ClusterIndex, std::string>> choices{
      {ClusterIndex::kDaviesBouldin, "davies_bouldin"}, {ClusterIndex::kSilhouette, "silhouette"}};
  return choices;
}

const Declarations<ClusterParameters>& ClusterParameters::declarations() {
  using P = ClusterParameters;
  static const auto declared =
      Declarations<P>()
          .add("method", &P::method, "", Range::any(),
               "How neurons are clustered: Ward's method or k-means on the weights, or the "
               "watershed of the U-matrix.")
          .add("count", &P::count, "clusters", Range::between(1, 1 << 24),
               "The number of clusters. Automatic: the one with the best index; with the "
               "watershed, the number of basins.")
          .add("index", &P::index, "", Range::any(),
               "The index that selects the number of clusters: the lowest Davies-Bouldin index, as "
               "Vesanto and Alhoniemi (2000) use it for maps, or the highest mean silhouette, "
               "which takes more time.")
          .add("most_clusters", &P::most_clusters, "clusters", Range::between(2, 1 << 24),
               "The most clusters that are tried. Automatic: the square root of the number of "
               "neurons, as in Vesanto and Alhoniemi (2000), at least 2.")
          .add("by_hits", &P::by_hits, "", Range::any(),
               "Whether a neuron counts as many times as it wins samples, so that neurons without "
               "samples have no influence; otherwise all neurons count alike.")
          .add("connected", &P::connected, "", Range::any(),
               "Whether Ward's method only merges clusters that share an edge of the map.");
  return declared;
}

std::vector<std::size_t> cut_merges(const std::vector<ClusterMerge>& merges, std::size_t count) {
  const std::size_t points = merges.size() + 1;
  require(count >= 1 && count <= points, "cut_merges: no such number of clusters");
  // Every cluster has the number of the last one that contains it.
  std::vector<std::size_t> last(points + merges.size());
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = points - count; i-- > 0;) {
    last[merges[i].first] = last[merges[i].second] = last[points + i];
  }
  last.resize(points);
  return numbered_in_order(last);
}

Result<Clusters> cluster_neurons(const Som& som, const ClusterParameters& parameters,
                                 const std::vector<std::size_t>& hits) {
  SOMATO_TRY_VOID(check_ranges(parameters));
  SOMATO_TRY_VOID(check_effect(parameters));
  require(som.neurons() > 0, "cluster_neurons: a map without neurons");
  if (parameters.method == ClusterMethod::kWatershed) return watershed(som, parameters.count);
  if (parameters.by_hits && std::all_of(hits.begin(), hits.end(), [](auto h) { return h == 0; })) {
    return fail(ErrorKind::kUsage, "no neuron wins a sample, so that none counts", "by_hits",
                "provide data, or let all neurons count");
  }
  const CountedNeurons counted =
      counted_neurons(som, parameters.by_hits ? hits : std::vector<std::size_t>());
  SOMATO_TRY_VOID(check_count(parameters.count, counted.points.count(),
                              parameters.by_hits ? "neurons that win samples" : "neurons"));
  const std::vector<ClusterMerge> merges =
      parameters.connected
          ? connected_ward_merges(counted.points, neighbours_of_points(som.grid(), counted))
          : ward_merges(counted.points);
  const PointClusters found =
      parameters.count ? clustered(counted.points, merges, parameters.method, *parameters.count)
                       : best_clusters(counted.points, merges, parameters);
  Clusters clusters;
  clusters.of_neuron = spread_to_neurons(found, counted);
  clusters.count = number_of(clusters.of_neuron);
  if (parameters.method == ClusterMethod::kWard) {
    clusters.merges = merges_of_neurons(merges, counted);
  }
  return clusters;
}

double davies_bouldin_index(const Som& som, const Clusters& clusters,
                            const std::vector<std::size_t>& hits) {
  const CountedNeurons counted = counted_neurons(som, hits);
  const PointClusters of_points = clusters_of_points(clusters, counted);
  return davies_bouldin(counted.points, of_points, number_of(of_points));
}

double silhouette_index(const Som& som, const Clusters& clusters,
                        const std::vector<std::size_t>& hits) {
  const CountedNeurons counted = counted_neurons(som, hits);
  const PointClusters of_points = clusters_of_points(clusters, counted);
  return silhouettes(counted.points, {of_points}, {number_of(of_points)}).front();
}

}  // namespace somato
