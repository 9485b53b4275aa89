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

// Means are those of the known values; the nearest row is the nearest one for the map, which sees
// columns in standard deviations where they are standardized.
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
    return fail(ErrorKind::kData, "there is only one sample", path,
                "a map needs at least two rows to learn from");
  }
  if (!arguments.has("keep-constant-columns")) {
    if (auto varied = refuse_constant_columns(*rows, path); !varied) return fail(varied.error());
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
      fmt::format("online training draws from all rows, and these {} x {} numbers take more "
                  "memory than they may",
                  rows.count, rows.size()),
      path, "use --training batch, or allow them more with --memory");
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
  const auto parameters = read_som_parameters(arguments);
  if (!parameters) return fail(parameters.error());
  const auto threads = read_threads(arguments);
  if (!threads) return fail(threads.error());
  auto rows = read_training_rows(arguments);
  if (!rows) return fail(rows.error());
  if (auto fits = check_training(*parameters, *rows, arguments.text("DATA")); !fits) return fits;
  std::vector<double> means;
  if (auto filled = fill_missing(arguments, *rows, means); !filled) return filled;
  auto model = start_model(arguments, *rows, std::move(means));
  if (!model) return fail(std::move(model.error()));
  auto som = train_map(*parameters, *model, *rows, *threads);
  if (!som) return fail(std::move(som.error()));
  model->som = std::move(*som);
  const auto quality = measure_rows(*model, *rows, *threads);
  if (!quality) return fail(quality.error());
  add_labels(*model, rows->classes, quality->winners);
  const std::string path = arguments.text("output");
  if (auto saved = save_som_model(path, *model); !saved) return saved;
  print_trained(path, model->som, *rows, *quality);
  return {};
}

}  // namespace

Command som_train_command() {
  std::vector<Flag> flags = data_flags();
  flags.push_back(output_flag("-o,--output", "File for the trained map", true));
  flags.push_back({"--standardize",
                   "Give each column mean 0 and standard deviation 1; kept with the map", false,
                   false});
  flags.push_back({"--keep-constant-columns",
                   "Accept columns that have the same value in every row", false, false});
  flags.push_back(threads_flag());
  flags.push_back(memory_flag());
  return {"som train",
          "Train a map on rows of numbers",
          {{"DATA",
            "NPY file, or text: one sample a line, numbers between commas, semicolons, "
            "tabs or blanks",
            true}},
          std::move(flags),
          SomParameters::declarations().infos(),
          train,
          "map"};
}

}  // namespace somato::program
