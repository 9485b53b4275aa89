#include "somato/maps/clusters.h"

#include <utility>

#include "somato/core/check.h"
#include "somato/maps/labels.h"

namespace somato {
namespace {

std::vector<std::size_t> regions_of_clusters(const Grid& grid, const Clusters& clusters) {
  std::vector<std::size_t> regions(clusters.count);
  std::vector<bool> seen(grid.size());
  for (std::size_t start = 0; start < grid.size(); ++start) {
    if (seen[start]) continue;
    ++regions[clusters.of_neuron[start]];
    std::vector<std::size_t> open{start};
    seen[start] = true;
    while (!open.empty()) {
      const std::size_t neuron = open.back();
      open.pop_back();
      for (const std::size_t other : grid.neighbours(neuron)) {
        if (seen[other] || clusters.of_neuron[other] != clusters.of_neuron[start]) continue;
        seen[other] = true;
        open.push_back(other);
      }
    }
  }
  return regions;
}

void name_by_majority(const std::vector<std::size_t>& clusters,
                      const std::vector<std::size_t>& classes, std::vector<ClusterSamples>& all) {
  NeuronVotes votes(all.size());
  votes.add_all(clusters, classes);
  const NeuronLabels labels = votes.labels();
  for (std::size_t c = 0; c < all.size(); ++c) {
    all[c].name = labels[c];
    if (!all[c].name) continue;
    all[c].purity =
        static_cast<double>(votes.of(c, *all[c].name)) / static_cast<double>(all[c].samples);
  }
}

}  // namespace

std::vector<ClusterSamples> samples_of_clusters(const Grid& grid, const Clusters& clusters,
                                                const std::vector<std::size_t>& winners,
                                                const std::vector<std::size_t>& classes) {
  require(clusters.of_neuron.size() == grid.size(), "clusters: each neuron needs a cluster");
  std::vector<ClusterSamples> all(clusters.count);
  for (const std::size_t cluster : clusters.of_neuron) ++all[cluster].neurons;
  const std::vector<std::size_t> regions = regions_of_clusters(grid, clusters);
  for (std::size_t c = 0; c < all.size(); ++c) all[c].regions = regions[c];
  std::vector<std::size_t> of_samples;
  for (const std::size_t winner : winners) {
    require(winner < grid.size(), "a winner is not on the map");
    of_samples.push_back(clusters.of_neuron[winner]);
    ++all[of_samples.back()].samples;
  }
  if (!classes.empty()) name_by_majority(of_samples, classes, all);
  return all;
}

}  // namespace somato
