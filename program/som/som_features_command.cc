#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/files/whole_file.h"
#include "base/text/json_table.h"
#include "flags/commands.h"
#include "flags/memory_flag.h"
#include "flags/neuron_flag.h"
#include "flags/result_output.h"
#include "som/column_report.h"
#include "som/data.h"
#include "som/map_and_rows.h"
#include "som/processes.h"
#include "som/row_output.h"
#include "somato/files/csv.h"

namespace somato::program {
namespace {

// Features in the order of their planes; all in the order of the map if there are too many to
// compare.
PlaneOrder order_of_planes(const Som& som) {
  if (som.input_size() <= kMostPlanes) return order_planes(som);
  PlaneOrder order;
  order.order.resize(som.input_size());
  std::iota(order.order.begin(), order.order.end(), std::size_t{0});
  return order;
}

struct FeatureTable {
  std::string csv;
  Table json;
};

FeatureTable features_in_order(const SomModel& model, const FeatureMeasurement& measurement) {
  const PlaneOrder order = order_of_planes(model.som);
  const std::vector<FeatureMeasures> features = measurement.features();
  const bool grouped = order.groups > 0;
  FeatureTable table{
      grouped ? "feature,explained_variance,group\n" : "feature,explained_variance\n", {}};
  std::vector<Table> rows;
  for (const std::size_t d : order.order) {
    const std::string name = feature_name(model, d);
    const double share = features[d].explained_variance;
    table.csv += fmt::format("{},{:.9g}", csv_field(name), share);
    Table& row =
        rows.emplace_back(Table{{}, {entry("feature", name), entry("explained_variance", share)}});
    if (grouped) {
      table.csv += fmt::format(",{}", order.group_of_feature[d]);
      row.entries.push_back(entry("group", order.group_of_feature[d]));
    }
    table.csv += "\n";
  }
  table.json.entries = {entry("explained_variance", measurement.explained_variance()),
                        entry("features", std::move(rows))};
  return table;
}

// A neuron as the only group.
std::vector<std::size_t> only_neuron(std::size_t neurons, std::size_t neuron) {
  std::vector<std::size_t> groups(neurons, 1);
  groups[neuron] = 0;
  return groups;
}

Result<FeatureTable> differences_of_neuron(const Arguments& arguments, const MapAndRows& both,
                                           const SomMeasures& measures, std::size_t threads) {
  const Som& som = both.model.som;
  SOMATO_TRY(const auto neuron, chosen_neuron(arguments.text("neuron"), som.grid()));
  if (measures.neurons[neuron].samples == 0) {
    return fail(ErrorKind::kData, "the neuron wins no sample", "--neuron",
                "choose one that does: --measures neurons of 'som quality' lists them");
  }
  FeatureMeasurement measurement(som, threads, only_neuron(som.neurons(), neuron), 1);
  SOMATO_TRY_VOID(measure_features(both, measures.winners, measurement));
  FeatureTable table{"feature,difference\n", {}};
  std::vector<Table> rows;
  for (const FeatureDifference& of : measurement.differences(0)) {
    const std::string name = feature_name(both.model, of.feature);
    table.csv += fmt::format("{},{:.9g}\n", csv_field(name), of.difference);
    rows.push_back({{}, {entry("feature", name), entry("difference", of.difference)}});
  }
  table.json.entries = {entry("neuron", neuron), entry("samples", measures.neurons[neuron].samples),
                        entry("features", std::move(rows))};
  return table;
}

Result<FeatureTable> all_features(const MapAndRows& both, const SomMeasures& measures,
                                  std::size_t threads) {
  FeatureMeasurement measurement(both.model.som, threads);
  return measure_features(both, measures.winners, measurement).map([&] {
    return features_in_order(both.model, measurement);
  });
}

Result<void> features(const Arguments& arguments) {
  SOMATO_TRY_VOID(refuse_several_processes("som features"));
  SOMATO_TRY(const auto threads, read_threads(arguments));
  SOMATO_TRY(const auto both, read_map_and_rows(arguments));
  SOMATO_TRY(const auto measures, measure_rows(both, {}, {}, threads));
  SOMATO_TRY(const auto table, arguments.has("neuron")
                                   ? differences_of_neuron(arguments, both, measures, threads)
                                   : all_features(both, measures, threads));
  SOMATO_TRY(auto output, RowOutput::begin(arguments.text("output"), nullptr));
  SOMATO_TRY_VOID(
      output.commit(output.write(arguments.has("json") ? to_json(table.json) : table.csv)));
  note_columns_and_filled(both.rows);
  return {};
}

}  // namespace

Command som_features_command() {
  std::vector<Flag> flags{output_flag("-o,--output", "CSV file instead of standard output"),
                          {"--neuron",
                           "The features that set the samples of one neuron apart, instead of the "
                           "variance that the map explains: ROW,COLUMN from 1, or its number in a "
                           "map that grows"}};
  const std::vector<Flag> of_table = table_flags();
  flags.insert(flags.end(), of_table.begin(), of_table.end());
  flags.push_back(threads_flag());
  flags.push_back(memory_flag());
  flags.push_back({"--json", "Write JSON instead of CSV", false, false});
  return {"som features",
          "Measure which features a map explains, in the order of similar component planes",
          {{"MAP", "A trained map", true}, data_positional("NPY file or text, as for training")},
          std::move(flags),
          {},
          features};
}

}  // namespace somato::program
