#include <fmt/format.h>

#include <utility>

#include "column_report.h"
#include "commands.h"
#include "data.h"
#include "map_and_rows.h"
#include "memory_flag.h"
#include "somato/maps/som_training.h"
#include "terminal.h"
#include "wording.h"

namespace somato::program {
namespace {

// Means are those of the known values; the nearest row is determined in the units of the map,
// which are standard deviations for standardized columns.
Result<void> fill_missing(const Arguments& arguments, RowData& rows, std::vector<double>& means) {
  if (rows.missing == MissingFill::kRefuse) return {};
  auto known = rows.known.means(rows.features);
  if (!known) {
    known.error().where = rows.path;
    return fail(std::move(known.error()));
  }
  const bool scaled = rows.missing == MissingFill::kNearest && arguments.has("standardize");
  std::vector<double> scale;
  if (scaled && rows.in_memory()) scale = known_deviations(*rows.in_memory(), *known);
  if (rows.missing == MissingFill::kMean) means = *known;
  return rows.fill(*known, scale);
}

Result<RowData> read_training_rows(const Arguments& arguments) {
  auto rows = read_rows(arguments);
  if (!rows) return rows;
  const std::string path = arguments.text("DATA");
  if (rows->count < 2) {
    return fail(ErrorKind::kData, "the data have only one sample", path,
                "a map needs at least two rows for training");
  }
  if (!arguments.has("keep-constant-columns")) {
    SOMATO_TRY_VOID(refuse_constant_columns(*rows, path));
  }
  return rows;
}

// A model without its map.
Result<SomModel> start_model(const Arguments& arguments, const RowData& rows,
                             std::vector<double> means) {
  SomModel model;
  model.features = rows.features;
  model.means = std::move(means);
  if (!arguments.has("standardize")) return model;
  return Standardization::fit(rows.samples(), {ConstantColumns::kZero}, rows.features)
      .map([&](Standardization&& fitted) {
        model.standardization = std::move(fitted);
        return std::move(model);
      });
}

void add_labels(SomModel& model, const Classes& classes, const std::vector<std::size_t>& winners) {
  if (classes.of_sample.empty()) return;
  model.labels = NeuronLabels::by_majority(winners, classes.of_sample, model.som.neurons());
  model.classes = classes.names;
}

Result<SomParameters> read_som_parameters(const Arguments& arguments) {
  auto parameters = read_flags<SomParameters>(arguments);
  if (!parameters) return parameters;
  for (const std::string& name : SomParameters::declarations().names()) {
    const std::string reason = reason_without_effect(*parameters, name);
    if (reason.empty() || !arguments.has(flag_of(name).substr(2))) continue;
    return fail(without_effect(name, reason, flag_of(name)));
  }
  return parameters;
}

Result<void> check_training(const SomParameters& parameters, const RowData& rows,
                            const std::string& path) {
  if (rows.in_memory() || parameters.training == Training::kBatch) return {};
  return fail(
      ErrorKind::kSystem,
      fmt::format("online training needs all rows in memory, and {} x {} numbers exceed the "
                  "memory for rows",
                  rows.count, rows.size()),
      path, "use --training batch, or a larger --memory");
}

Result<Som> train_map(const SomParameters& parameters, const SomModel& model, const RowData& rows,
                      std::size_t threads) {
  const TrainingOptions options{threads, terminal_progress("training")};
  if (rows.in_memory()) return train_som(parameters, model.prepare(*rows.in_memory()), options);
  PreparedRows prepared(model, rows);
  return train_som(parameters, prepared.samples(), options);
}

void print_trained(const std::string& path, const Som& som, const RowData& rows,
                   const SomQuality& quality) {
  const std::string size = fmt::format(
      "{}: {} x {} neurons trained on {} of {}\n", path, som.grid().rows(), som.grid().columns(),
      counted(rows.count, "sample"), counted(rows.size(), "feature"));
  const std::string errors = fmt::format("quantization_error {:.6g}\ntopographic_error {:.6g}\n",
                                         quality.quantization_error, quality.topographic_error);
  print_summary(size + columns_and_filled(rows) + errors);
}

Result<void> train(const Arguments& arguments) {
  SOMATO_TRY(const auto parameters, read_som_parameters(arguments));
  SOMATO_TRY(const auto threads, read_threads(arguments));
  SOMATO_TRY(auto rows, read_training_rows(arguments));
  SOMATO_TRY_VOID(check_training(parameters, rows, arguments.text("DATA")));
  std::vector<double> means;
  SOMATO_TRY_VOID(fill_missing(arguments, rows, means));
  SOMATO_TRY(auto model, start_model(arguments, rows, std::move(means)));
  SOMATO_TRY(auto som, train_map(parameters, model, rows, threads));
  model.som = std::move(som);
  SOMATO_TRY(const auto quality, measure_rows(model, rows, threads));
  add_labels(model, rows.classes, quality.winners);
  const std::string path = arguments.text("output");
  SOMATO_TRY_VOID(save_som_model(path, model));
  print_trained(path, model.som, rows, quality);
  return {};
}

}  // namespace

Command som_train_command() {
  std::vector<Flag> flags = data_flags();
  flags.push_back(output_flag("-o,--output", "File for the trained map", true));
  flags.push_back({"--standardize",
                   "Scale each column to mean 0 and standard deviation 1; saved with the map",
                   false, false});
  flags.push_back({"--keep-constant-columns",
                   "Accept columns that have the same value in every row", false, false});
  flags.push_back(threads_flag());
  flags.push_back(memory_flag());
  return {
      "som train",
      "Train a map on a table of numbers",
      {{"DATA",
        "NPY, NPZ or MAT file, or text with one sample per line and numbers separated by commas, "
        "semicolons, tabs or blanks",
        true}},
      std::move(flags),
      SomParameters::declarations().infos(),
      train,
      "map"};
}

}  // namespace somato::program
