#include <fmt/format.h>

#include <utility>

#include "base/text/json_table.h"
#include "flags/commands.h"
#include "flags/memory_flag.h"
#include "flags/result_output.h"
#include "som/cluster_tables.h"
#include "som/column_report.h"
#include "som/data.h"
#include "som/map_and_rows.h"
#include "som/processes.h"
#include "som/row_output.h"

namespace somato::program {
namespace {

Result<void> check_cluster_flags(const Arguments& arguments) {
  if (!data_files(arguments).empty()) return {};
  std::vector<Flag> flags = data_flags();
  for (const char* name : {"--samples", "--features", "--by-hits"}) flags.push_back({name, ""});
  for (const Flag& flag : flags) {
    if (!arguments.has(key_of(flag.name))) continue;
    return fail(ErrorKind::kUsage, "has no effect without data", flag.name, "provide DATA");
  }
  return {};
}

Result<void> write_text(const std::string& path, const std::string& text) {
  SOMATO_TRY(auto output, RowOutput::begin(path, nullptr));
  return output.commit(output.write(text));
}

// The files that flags name besides the neurons.
Result<void> write_files(const Arguments& arguments, const ClusteredMap& clustered) {
  if (arguments.has("merges")) {
    if (clustered.clusters.merges.empty() && clustered.both.model.som.neurons() > 1) {
      return fail(ErrorKind::kUsage, "only method ward merges clusters", "--merges",
                  "use --method ward, or omit it");
    }
    SOMATO_TRY_VOID(write_text(arguments.text("merges"), csv_of_merges(clustered.clusters)));
  }
  if (arguments.has("samples")) {
    SOMATO_TRY_VOID(write_text(arguments.text("samples"), csv_of_samples(clustered)));
  }
  if (!arguments.has("features")) return {};
  return write_text(arguments.text("features"), csv_of_differences(clustered));
}

Result<ClusteredMap> clustered_map(const Arguments& arguments) {
  SOMATO_TRY(const auto parameters, read_flags<ClusterParameters>(arguments));
  SOMATO_TRY(const auto threads, read_threads(arguments));
  ClusteredMap clustered;
  clustered.has_data = !data_files(arguments).empty();
  if (clustered.has_data) {
    SOMATO_TRY(clustered.both, read_map_and_rows(arguments));
    SOMATO_TRY(clustered.measures, measure_rows(clustered.both, {}, {}, threads));
  } else {
    SOMATO_TRY(clustered.both.model, load_som_model(arguments.text("MAP")));
  }
  const std::vector<std::size_t> hits = hits_of(clustered.measures);
  auto clusters = cluster_neurons(clustered.both.model.som, parameters, hits);
  if (!clusters) {
    clusters.error().where = flag_of(clusters.error().where);
    return fail(std::move(clusters.error()));
  }
  clustered.clusters = *std::move(clusters);
  clustered.index = davies_bouldin_index(clustered.both.model.som, clustered.clusters,
                                         parameters.by_hits ? hits : std::vector<std::size_t>());
  name_clusters(clustered);
  if (!clustered.has_data) return clustered;
  FeatureMeasurement measurement(clustered.both.model.som, threads, clustered.clusters.of_neuron,
                                 clustered.clusters.count);
  return measure_features(clustered.both, clustered.measures.winners, measurement).map([&] {
    for (std::size_t c = 0; c < clustered.clusters.count; ++c) {
      clustered.differences.push_back(measurement.differences(c));
    }
    return std::move(clustered);
  });
}

Result<void> cluster(const Arguments& arguments) {
  SOMATO_TRY_VOID(refuse_several_processes("som cluster"));
  SOMATO_TRY_VOID(check_cluster_flags(arguments));
  SOMATO_TRY(const auto clustered, clustered_map(arguments));
  SOMATO_TRY_VOID(write_files(arguments, clustered));
  const std::string neurons = csv_of_neurons(clustered);
  const std::string json = arguments.has("json") ? to_json(json_of(clustered)) : std::string();
  if (arguments.has("output")) {
    SOMATO_TRY_VOID(write_text(arguments.text("output"), neurons));
    print_summary(arguments, summary_of(clustered), json);
  } else {
    print_result(arguments, neurons, json);
  }
  if (clustered.has_data) note_columns_and_filled(clustered.both.rows);
  return {};
}

}  // namespace

Command som_cluster_command() {
  std::vector<Flag> flags = data_flags();
  flags.push_back(output_flag(
      "-o,--output", "CSV file for the cluster of each neuron instead of standard output"));
  flags.push_back(output_flag("--samples", "CSV file for the cluster of each row of DATA"));
  flags.push_back(output_flag("--features",
                              "CSV file for the features by which each cluster differs from all "
                              "rows of DATA"));
  flags.push_back(output_flag("--merges", "CSV file for the merges of method ward: a dendrogram"));
  flags.push_back(threads_flag());
  flags.push_back(memory_flag());
  flags.push_back(json_flag());
  return {
      "som cluster",
      "Cluster the neurons of a map, and with data its samples",
      {{"MAP", "A trained map", true},
       data_positional("NPY file or text, as for training, for hits, names and samples", false)},
      std::move(flags),
      ClusterParameters::declarations().infos(),
      cluster,
      {"clusters"}};
}

}  // namespace somato::program
