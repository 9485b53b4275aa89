#include <fmt/format.h>

#include <utility>

#include "commands.h"
#include "data.h"
#include "output.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"
#include "terminal.h"

namespace somato::program {
namespace {

Result<Data> read_training_data(const Arguments& arguments) {
  auto data = read_data(arguments);
  if (!data) return data;
  const std::string path = arguments.text("DATA");
  if (data->samples.count() < 2) {
    return fail(ErrorKind::kData, "there is only one sample", path,
                "a map needs at least two rows to learn from");
  }
  if (!arguments.has("keep-constant-columns")) {
    if (auto varied = refuse_constant_columns(*data, path); !varied) return fail(varied.error());
  }
  return data;
}

Result<std::optional<Standardization>> fit_standardization(const Arguments& arguments,
                                                           const Data& data) {
  if (!arguments.has("standardize")) return std::optional<Standardization>{};
  return Standardization::fit(data.samples, {ConstantColumns::kZero}, data.features)
      .map(
          [](Standardization fitted) { return std::optional<Standardization>(std::move(fitted)); });
}

void add_labels(SomModel& model, const std::vector<std::string>& names,
                const std::vector<std::size_t>& winners) {
  if (names.empty()) return;
  Classes classes = Classes::from_names(names);
  model.labels = NeuronLabels::by_majority(winners, classes.of_sample, model.som.neurons());
  model.classes = std::move(classes.names);
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

Result<void> train(const Arguments& arguments) {
  auto parameters = read_som_parameters(arguments);
  if (!parameters) return fail(std::move(parameters.error()));
  auto threads = read_threads(arguments);
  if (!threads) return fail(std::move(threads.error()));
  if (auto savable = check_output(arguments, "output"); !savable) return savable;
  auto data = read_training_data(arguments);
  if (!data) return fail(std::move(data.error()));
  SomModel model;
  model.features = data->features;
  auto standardization = fit_standardization(arguments, *data);
  if (!standardization) return fail(std::move(standardization.error()));
  model.standardization = std::move(*standardization);
  const Samples samples = model.prepare(data->samples);
  auto som = train_som(*parameters, samples, {*threads, terminal_progress("training")});
  if (!som) return fail(std::move(som.error()));
  model.som = std::move(*som);
  const SomQuality quality = measure_quality(model.som, samples, *threads);
  add_labels(model, data->labels, quality.winners);
  const std::string path = arguments.text("output");
  if (auto saved = save_som_model(path, model); !saved) return saved;
  fmt::print("{}: {} x {} neurons trained on {} samples of {} features\n", path,
             model.som.grid().rows(), model.som.grid().columns(), samples.count(), samples.size());
  fmt::print("quantization_error {:.6g}\ntopographic_error {:.6g}\n", quality.quantization_error,
             quality.topographic_error);
  return {};
}

}  // namespace

Command som_train_command() {
  std::vector<Flag> flags = data_flags();
  flags.push_back({"-o,--output", "File for the trained map", true});
  flags.push_back({"--standardize",
                   "Give each column mean 0 and standard deviation 1; kept with the map", false,
                   false});
  flags.push_back({"--keep-constant-columns",
                   "Accept columns that have the same value in every row", false, false});
  flags.push_back(threads_flag());
  return {"som train",
          "Train a map on rows of numbers",
          {{"DATA",
            "NPY file, or text: one sample a line, numbers between commas, semicolons, "
            "tabs or blanks",
            true}},
          std::move(flags),
          parameter_flags<SomParameters>(),
          train,
          "map"};
}

}  // namespace somato::program
