#include "som/cluster_tables.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "flags/result_output.h"
#include "som/map_and_rows.h"
#include "somato/files/csv.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

std::string name_field(const ClusteredMap& clustered, std::size_t cluster) {
  return clustered.names.empty() ? std::string() : "," + csv_field(clustered.names[cluster]);
}

std::string name_column(const ClusteredMap& clustered) {
  return clustered.names.empty() ? "" : ",name";
}

void add_name(const ClusteredMap& clustered, std::size_t cluster, Table& table) {
  if (!clustered.names.empty()) table.entries.push_back(entry("name", clustered.names[cluster]));
}

// A vote of each neuron that has a label, as if it were a sample.
void name_by_neurons(ClusteredMap& clustered) {
  const NeuronLabels& labels = clustered.both.model.labels;
  std::vector<std::size_t> classes;
  for (const std::size_t neuron : labels.labelled()) classes.push_back(*labels[neuron]);
  const std::vector<ClusterSamples> voted = samples_of_clusters(
      clustered.both.model.som.grid(), clustered.clusters, labels.labelled(), classes);
  for (std::size_t c = 0; c < voted.size(); ++c) clustered.samples[c].name = voted[c].name;
}

Table json_of_neuron(const ClusteredMap& clustered, std::size_t neuron) {
  const Grid& grid = clustered.both.model.som.grid();
  const std::size_t cluster = clustered.clusters.of_neuron[neuron];
  Table table{{},
              {entry("neuron", neuron), entry("row", grid.row_of(neuron)),
               entry("column", grid.column_of(neuron)), entry("cluster", cluster)}};
  if (clustered.has_data) {
    table.entries.push_back(entry("samples", clustered.measures.neurons[neuron].samples));
  }
  return table;
}

Table json_of_cluster(const ClusteredMap& clustered, std::size_t cluster) {
  const ClusterSamples& of = clustered.samples[cluster];
  Table table{
      {}, {entry("cluster", cluster), entry("neurons", of.neurons), entry("regions", of.regions)}};
  add_name(clustered, cluster, table);
  if (!clustered.has_data) return table;
  table.entries.push_back(entry("samples", of.samples));
  if (clustered.both.rows.labelled()) table.entries.push_back(entry("purity", of.purity));
  const auto make = [&](const FeatureDifference& difference) {
    return Table{{},
                 {entry("feature", feature_name(clustered.both.model, difference.feature)),
                  entry("difference", difference.difference)}};
  };
  table.entries.push_back(entry("features", clustered.differences[cluster], make));
  return table;
}

Table json_of_merge(const ClusterMerge& merge) {
  return {{},
          {entry("first", merge.first), entry("second", merge.second),
           entry("height", merge.height), entry("neurons", merge.neurons)}};
}

Table json_of_sample(const ClusteredMap& clustered, std::size_t sample) {
  const std::size_t winner = clustered.measures.winners[sample];
  return {{},
          {entry("sample", sample + 1), entry("winner", winner),
           entry("cluster", clustered.clusters.of_neuron[winner])}};
}

std::vector<std::size_t> numbers_below(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

}  // namespace

void name_clusters(ClusteredMap& clustered) {
  const Classes& classes = clustered.both.rows.classes;
  const SomModel& model = clustered.both.model;
  clustered.samples = samples_of_clusters(model.som.grid(), clustered.clusters,
                                          clustered.measures.winners, classes.of_sample);
  const bool labelled = !classes.of_sample.empty();
  if (!labelled && model.classes.empty()) return;
  if (!labelled) name_by_neurons(clustered);
  const std::vector<std::string>& names = labelled ? classes.names : model.classes;
  for (const ClusterSamples& of : clustered.samples) {
    clustered.names.push_back(of.name ? names[*of.name] : std::string());
  }
}

std::string csv_of_neurons(const ClusteredMap& clustered) {
  const Grid& grid = clustered.both.model.som.grid();
  std::string csv = fmt::format("neuron,row,column,cluster{}{}\n",
                                clustered.has_data ? ",samples" : "", name_column(clustered));
  for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
    const std::size_t cluster = clustered.clusters.of_neuron[neuron];
    csv += fmt::format("{},{},{},{}", neuron, grid.row_of(neuron), grid.column_of(neuron), cluster);
    if (clustered.has_data) {
      csv += fmt::format(",{}", clustered.measures.neurons[neuron].samples);
    }
    csv += name_field(clustered, cluster) + "\n";
  }
  return csv;
}

std::string csv_of_samples(const ClusteredMap& clustered) {
  std::string csv = "sample,winner,cluster" + name_column(clustered) + "\n";
  std::size_t sample = 0;
  for (const std::size_t winner : clustered.measures.winners) {
    const std::size_t cluster = clustered.clusters.of_neuron[winner];
    csv += fmt::format("{},{},{}{}\n", ++sample, winner, cluster, name_field(clustered, cluster));
  }
  return csv;
}

std::string csv_of_merges(const Clusters& clusters) {
  std::string csv = "first,second,height,neurons\n";
  for (const ClusterMerge& merge : clusters.merges) {
    csv +=
        fmt::format("{},{},{:.17g},{}\n", merge.first, merge.second, merge.height, merge.neurons);
  }
  return csv;
}

std::string csv_of_differences(const ClusteredMap& clustered) {
  std::string csv = "cluster,feature,difference\n";
  for (std::size_t c = 0; c < clustered.differences.size(); ++c) {
    for (const FeatureDifference& of : clustered.differences[c]) {
      csv += fmt::format("{},{},{:.9g}\n", c,
                         csv_field(feature_name(clustered.both.model, of.feature)), of.difference);
    }
  }
  return csv;
}

Table json_of(const ClusteredMap& clustered) {
  const auto neuron = [&](std::size_t i) { return json_of_neuron(clustered, i); };
  const auto cluster = [&](std::size_t i) { return json_of_cluster(clustered, i); };
  const auto sample = [&](std::size_t i) { return json_of_sample(clustered, i); };
  const Clusters& clusters = clustered.clusters;
  Table table{{},
              {entry("count", clusters.count), entry("davies_bouldin_index", clustered.index),
               entry("clusters", numbers_below(clusters.count), cluster),
               entry("neurons", numbers_below(clusters.of_neuron.size()), neuron)}};
  if (!clusters.merges.empty()) {
    table.entries.push_back(entry("merges", clusters.merges, json_of_merge));
  }
  if (clustered.has_data) {
    table.entries.push_back(
        entry("samples", numbers_below(clustered.measures.winners.size()), sample));
  }
  return table;
}

std::string summary_of(const ClusteredMap& clustered) {
  std::string text = fmt::format("clusters {}\ndavies_bouldin_index {:.6g}\n",
                                 clustered.clusters.count, clustered.index);
  for (std::size_t c = 0; c < clustered.samples.size(); ++c) {
    const ClusterSamples& of = clustered.samples[c];
    text += fmt::format("cluster {}: {} in {}", c, counted(of.neurons, "neuron"),
                        counted(of.regions, "region"));
    if (clustered.has_data) text += ", " + counted(of.samples, "sample");
    if (!clustered.names.empty()) text += ", " + printable(clustered.names[c]);
    if (clustered.both.rows.labelled()) text += fmt::format(", purity {:.6g}", of.purity);
    text += "\n";
  }
  return text;
}

}  // namespace somato::program
