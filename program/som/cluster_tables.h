#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "som/map_and_rows.h"
#include "somato/core/value.h"
#include "somato/maps/clusters.h"
#include "somato/maps/som_measures.h"

namespace somato::program {

/// A map with clusters of its neurons, and their samples.
struct ClusteredMap {
  MapAndRows both;
  bool has_data = false;
  SomMeasures measures;  ///< Measures for the data; empty without data.
  Clusters clusters;
  double index = 0.0;                   ///< The Davies-Bouldin index.
  std::vector<ClusterSamples> samples;  ///< One for each cluster.
  std::vector<std::string> names;       ///< One for each cluster; empty without classes.
  std::vector<std::vector<FeatureDifference>>
      differences;  ///< One list for each cluster; only with data.
};

/// Finds samples and names: by the classes of the samples, or without labelled data by those of the
/// map's neurons.
void name_clusters(ClusteredMap& clustered);

/// CSV: neuron, row, column, cluster, and with data samples, with classes name.
std::string csv_of_neurons(const ClusteredMap& clustered);

/// CSV: sample, winner, cluster, and with classes name.
std::string csv_of_samples(const ClusteredMap& clustered);

/// CSV: first, second, height, neurons.
std::string csv_of_merges(const Clusters& clusters);

/// CSV: cluster, feature, difference.
std::string csv_of_differences(const ClusteredMap& clustered);

/// All of these as JSON.
Table json_of(const ClusteredMap& clustered);

/// The clusters, one per line.
std::string summary_of(const ClusteredMap& clustered);

}  // namespace somato::program
