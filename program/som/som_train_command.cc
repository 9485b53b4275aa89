#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "flags/commands.h"
#include "flags/memory_flag.h"
#include "som/column_report.h"
#include "som/data.h"
#include "som/layer_flag.h"
#include "som/map_and_rows.h"
#include "som/processes.h"
#include "somato/maps/layers.h"
#include "somato/maps/measured_size.h"
#include "somato/maps/refinement.h"
#include "somato/maps/som_parameters.h"
#include "somato/maps/som_training.h"
#include "systems/model/complete_inputs.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

// Means are those of the known values; the nearest row is determined in the units of the map,
// which are standard deviations for standardized columns.
Result<void> fill_missing(const Arguments& arguments, RowData& rows, std::vector<double>& means) {
  if (rows.missing == MissingFill::kRefuse) return {};
  auto known = rows.known.means(rows.features);
  if (!known) {
    known.error().where = rows.path;
    known.error().advice += " with --skip";
    return fail(std::move(known.error()));
  }
  const bool scaled = rows.missing == MissingFill::kNearest && arguments.has("standardize");
  std::vector<double> scale;
  if (scaled && rows.in_memory()) scale = known_deviations(*rows.in_memory(), *known);
  if (rows.missing != MissingFill::kNearest) means = *known;
  return rows.fill(*known, scale);
}

Result<void> check_count(const RowData& rows) {
  if (rows.count >= 2) return {};
  return fail(ErrorKind::kData, "the data have only one sample", rows.path,
              "a map needs at least two rows for training");
}

Result<void> check_rows(const Arguments& arguments, const RowData& rows) {
  SOMATO_TRY_VOID(check_count(rows));
  if (arguments.has("keep-constant-columns")) return {};
  return refuse_constant_columns(rows, rows.path);
}

// The standardization of the known values, for rows whose missing values are left out.
Standardization standardization_of_known(const RowData& rows, const std::vector<double>& means) {
  Standardization fitted{means, known_deviations(*rows.in_memory(), means)};
  for (std::size_t d = 0; d < means.size(); ++d) {
    if (rows.low[d] == rows.high[d]) fitted.deviations[d] = 0.0;
  }
  return fitted;
}

// A model without its map.
Result<SomModel> start_model(const Arguments& arguments, const RowData& rows,
                             std::vector<double> means) {
  SomModel model;
  model.features = rows.features;
  model.means = std::move(means);
  if (!arguments.has("standardize")) return model;
  if (rows.holds_missing) {
    model.standardization = standardization_of_known(rows, model.means);
    return model;
  }
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

// Parameters that the command line gives without an effect are an error.
Result<RefinementParameters> read_refinement(const Arguments& arguments,
                                             const JoinedProcesses* processes) {
  SOMATO_TRY(const auto refinement, read_flags<RefinementParameters>(arguments));
  for (const std::string& name : RefinementParameters::declarations().names()) {
    const std::string reason = reason_without_effect(refinement, name);
    if (reason.empty() || !arguments.has(flag_of(name).substr(2))) continue;
    return fail(without_effect(name, reason, flag_of(name)));
  }
  if (processes == nullptr || refinement.refine == Refinement::kNone) return refinement;
  return fail(ErrorKind::kUsage, "several processes cannot share a refinement by labels",
              "--refine", "start one process");
}

Result<void> check_refinable(const RefinementParameters& refinement, const RowData& rows) {
  if (refinement.refine == Refinement::kNone) return {};
  if (!rows.labelled()) {
    return fail(ErrorKind::kUsage, "a refinement needs the labels of the rows", "--refine",
                "name their file or their column by --labels or --label-column");
  }
  if (rows.in_memory()) return {};
  return fail(ErrorKind::kSystem,
              fmt::format("a refinement needs all rows in memory, and {} x {} numbers exceed the "
                          "memory for rows",
                          rows.count, rows.size()),
              rows.path, "use a larger --memory");
}

Result<void> check_training(const SomParameters& parameters, const RowData& rows) {
  if (rows.in_memory() || parameters.training == Training::kBatch) return {};
  return fail(
      ErrorKind::kSystem,
      fmt::format("online training needs all rows in memory, and {} x {} numbers exceed the "
                  "memory for rows",
                  rows.count, rows.size()),
      rows.path, "use --training batch, or a larger --memory");
}

// Parameters that the command line gives although the size decides them are an error.
Result<SizeChoice> read_size(const Arguments& arguments, const JoinedProcesses* processes) {
  SOMATO_TRY(const auto parameters, read_flags<SizeParameters>(arguments));
  for (const std::string& name : SomParameters::declarations().names()) {
    const std::string reason = reason_without_effect(parameters.size, name);
    if (reason.empty() || !arguments.has(flag_of(name).substr(2))) continue;
    return fail(without_effect(name, reason, flag_of(name)));
  }
  if (processes == nullptr || parameters.size == SizeChoice::kByNumber) return parameters.size;
  return fail(ErrorKind::kUsage, "several processes cannot share the measurement of a size",
              "--size", "give --rows and --columns, or start one process");
}

// A measured size needs all rows.
Result<void> check_size(SizeChoice size, const RowData& rows) {
  if (size == SizeChoice::kByNumber || rows.in_memory()) return {};
  return fail(ErrorKind::kSystem,
              fmt::format("a measured size needs all rows in memory, and {} x {} numbers exceed "
                          "the memory for rows",
                          rows.count, rows.size()),
              rows.path, "give --rows and --columns, or a larger --memory");
}

Result<void> not_stopped() {
  if (!stop_requested()) return {};
  return fail(ErrorKind::kInterrupted, "the measurement of the size was stopped", {},
              "nothing was written");
}

Result<SomParameters> sized_parameters(const SomParameters& parameters, SizeChoice size,
                                       const SomModel& model, const RowData& rows,
                                       std::size_t threads) {
  if (size == SizeChoice::kByNumber) return parameters;
  SOMATO_TRY(auto sized, sized_by_measurement(parameters, model.prepare(*rows.in_memory()),
                                              {.threads = threads, .proceed = not_stopped}));
  return std::move(sized.parameters);
}

// The part of the command line that does not depend on the rows.
struct TrainingRequest {
  SomParameters parameters;
  SizeChoice size = SizeChoice::kByNumber;
  RefinementParameters refinement;
  TrainingOptions options;
};

Result<TrainingRequest> read_request(const Arguments& arguments, JoinedProcesses* processes) {
  SOMATO_TRY(const auto size, read_size(arguments, processes));
  SOMATO_TRY(const auto parameters, read_som_parameters(arguments));
  SOMATO_TRY(const auto threads, threads_of(arguments, processes));
  const bool is_batch = parameters.training == Training::kBatch || size == SizeChoice::kMeasured;
  SOMATO_TRY(const auto missing, read_missing(arguments));
  if (missing == MissingFill::kLeaveOut && arguments.has("checkpoint")) {
    return fail(ErrorKind::kUsage, "training that leaves missing values out saves no checkpoints",
                "--checkpoint", "leave it out, or use --missing mean");
  }
  if (!is_batch && arguments.has("checkpoint")) {
    return fail(without_effect("checkpoint", "training is online", "--checkpoint"));
  }
  if (processes && !is_batch) {
    return fail(ErrorKind::kUsage, "several processes cannot share online training", "--training",
                "use --training batch, or start one process");
  }
  if (processes && arguments.has("standardize")) {
    return fail(ErrorKind::kUsage, "several processes cannot share the work of this flag",
                "--standardize", "standardize the rows before, or start one process");
  }
  SOMATO_TRY(const auto refinement, read_refinement(arguments, processes));
  TrainingRequest request{parameters, size, refinement, {threads, terminal_progress("training")}};
  request.options.checkpoint = arguments.text("checkpoint");
  request.options.processes = processes;
  return request;
}

Result<Som> train_map(const TrainingRequest& request, const SomModel& model, const RowData& rows,
                      std::uint64_t& steps) {
  TrainingOptions options = request.options;
  options.steps_done = &steps;
  if (!rows.in_memory()) {
    PreparedRows prepared(model, rows);
    return train_som(request.parameters, prepared.samples(), options);
  }
  const Samples prepared = model.prepare(*rows.in_memory());
  if (rows.holds_missing) return train_leaving_out(request.parameters, prepared, options);
  if (options.checkpoint.empty() && !options.processes) {
    return train_som(request.parameters, prepared, options);
  }
  SamplesInMemory source(prepared);
  const bool is_only = !options.processes;  // that has all samples
  return train_som(is_only ? with_scales(request.parameters, prepared) : request.parameters, source,
                   options);
}

// The order before and after; nothing without a refinement.
Result<std::optional<RefinedOrder>> refine_map(const TrainingRequest& request, SomModel& model,
                                               const RowData& rows) {
  if (request.refinement.refine == Refinement::kNone) return std::nullopt;
  const auto& classes = rows.classes.of_sample;
  const RefinementOptions options{model.som.parameters().seed, request.options.threads,
                                  terminal_progress("refinement")};
  SOMATO_TRY(auto refined,
             refine_som(model.som, model.prepare(*rows.in_memory()),
                        {classes.begin(), classes.end()}, request.refinement, options));
  model.som = std::move(refined.som);
  return refined.order;
}

Result<void> save_trained(const Arguments& arguments, const SomModel& model,
                          const TrainingOptions& options) {
  if (options.processes && !options.processes->is_first()) return {};
  SOMATO_TRY_VOID(save_som_model(arguments.text("output"), model));
  std::error_code gone;
  if (!options.checkpoint.empty()) std::filesystem::remove(options.checkpoint, gone);
  return {};
}

// How long training of automatic length has taken.
std::string steps_text(const SomParameters& parameters, std::uint64_t steps) {
  if (!parameters.is_length_automatic()) return {};
  const bool batch = parameters.training == Training::kBatch;
  return fmt::format("{} {}\n", batch ? "epochs" : "iterations", steps);
}

// Online training of automatic length has seen more samples than `iterations`.
void add_steps(SomModel& model, std::uint64_t steps) {
  const SomParameters& p = model.som.parameters();
  if (p.is_length_automatic() && p.training == Training::kOnline) model.samples_seen = steps;
}

// Ranks are not measured for few samples.
std::string before_and_after(const std::string& name, double before, double after) {
  if (std::isnan(before)) return {};
  return fmt::format("unrefined_{0} {1:.6g}\nrefined_{0} {2:.6g}\n", name, before, after);
}

std::string order_text(const std::optional<RefinedOrder>& order) {
  if (!order) return {};
  const auto& [before, after, named_by_nearest, classes_without_neuron] = *order;
  std::string text =
      before_and_after("quantization_error", before.quantization_error, after.quantization_error) +
      before_and_after("topographic_error", before.topographic_error, after.topographic_error) +
      before_and_after("trustworthiness", before.trustworthiness, after.trustworthiness) +
      before_and_after("continuity", before.continuity, after.continuity);
  if (classes_without_neuron > 0) {
    text += fmt::format("classes_without_neuron {}\n", classes_without_neuron);
  }
  return text;
}

void print_trained(const std::string& path, const Som& som, const RowData& rows,
                   const SomQuality& quality, std::uint64_t steps,
                   const std::optional<RefinedOrder>& order) {
  const std::string size = fmt::format(
      "{}: {} x {} neurons trained on {} of {}\n", path, som.grid().rows(), som.grid().columns(),
      counted(rows.count, "sample"), counted(rows.size(), "feature"));
  const std::string errors = fmt::format("quantization_error {:.6g}\ntopographic_error {:.6g}\n",
                                         quality.quantization_error, quality.topographic_error);
  print_summary(size + columns_and_filled(rows) + steps_text(som.parameters(), steps) + errors +
                order_text(order));
}

// A model without its map, ready to train it on the rows.
Result<SomModel> start_on(const Arguments& arguments, const SomParameters& parameters,
                          RowData& rows) {
  SOMATO_TRY_VOID(check_rows(arguments, rows));
  SOMATO_TRY_VOID(check_training(parameters, rows));
  std::vector<double> means;
  SOMATO_TRY_VOID(fill_missing(arguments, rows, means));
  return start_model(arguments, rows, std::move(means));
}

// A standardization keeps what differs, however large the numbers are: nothing is lost of numbers
// from which an offset is subtracted first.
std::vector<ColumnScale> without_check(const std::vector<double>& offsets) {
  std::vector<ColumnScale> scales;
  scales.reserve(offsets.size());
  for (const double offset : offsets) {
    scales.push_back({offset, std::numeric_limits<double>::infinity()});
  }
  return scales;
}

// Rows that are standardized are read again without the offsets of their columns if these lie far
// from 0. Offsets of `rows` are added to those of `model` when it is saved.
Result<RowData> read_training_rows(const Arguments& arguments, JoinedProcesses* processes,
                                   std::vector<double>& offsets) {
  if (!arguments.has("standardize")) return read_rows(arguments, {}, processes);
  SOMATO_TRY(auto rows, read_rows(arguments, {}, processes, without_check({0.0})));
  SOMATO_TRY_VOID(check_count(rows));
  std::vector<double> means;
  SOMATO_TRY_VOID(fill_missing(arguments, rows, means));
  SOMATO_TRY(const auto model, start_model(arguments, rows, std::move(means)));
  offsets = model.standardization->offsets();
  const bool near = std::all_of(offsets.begin(), offsets.end(), [](double o) { return o == 0.0; });
  if (near) return rows;
  return read_rows(arguments, {}, processes, without_check(offsets), rows.text);
}

void add_offsets(SomModel& model, const std::vector<double>& offsets) {
  if (offsets.empty()) return;
  std::vector<double> back(offsets.size());
  std::transform(offsets.begin(), offsets.end(), back.begin(), std::negate<>());
  model.standardization = model.standardization->without(back);
  for (std::size_t d = 0; d < model.means.size(); ++d) model.means[d] += offsets[d];
}

Result<void> train_with(const Arguments& arguments, JoinedProcesses* processes) {
  SOMATO_TRY(auto request, agreed(read_request(arguments, processes), processes));
  std::vector<double> offsets;
  SOMATO_TRY(auto rows, read_training_rows(arguments, processes, offsets));
  SOMATO_TRY(request.parameters.layers, agreed(read_layers(arguments, rows), processes));
  SOMATO_TRY_VOID(agreed(check_refinement(request.refinement, request.parameters), processes));
  SOMATO_TRY_VOID(agreed(check_refinable(request.refinement, rows), processes));
  SOMATO_TRY_VOID(check_size(request.size, rows));
  SOMATO_TRY(auto model, agreed(start_on(arguments, request.parameters, rows), processes));
  SOMATO_TRY(request.parameters, sized_parameters(request.parameters, request.size, model, rows,
                                                  request.options.threads));
  std::uint64_t steps = 0;
  SOMATO_TRY(auto som, train_map(request, model, rows, steps));
  model.som = std::move(som);
  add_steps(model, steps);
  SOMATO_TRY(const auto order, refine_map(request, model, rows));
  SOMATO_TRY(const auto quality, measure_rows(model, rows, request.options.threads, processes));
  add_labels(model, rows.classes, quality.winners);
  add_offsets(model, offsets);
  SOMATO_TRY_VOID(agreed(save_trained(arguments, model, request.options), processes));
  print_trained(arguments.text("output"), model.som, rows, quality, steps, order);
  return {};
}

Result<void> train(const Arguments& arguments) {
  SOMATO_TRY(const auto processes, Processes::join());
  return processes.leave(train_with(arguments, processes.group()));
}

std::vector<KeySection> key_sections_of_maps() {
  return {
      {"Maps",
       "Keys of a module of type `som`; those of other types are listed with [them](modules.md).",
       {key_table<SomParameters>("map")}},
      {"Measured size of maps",
       "A flag of `somato som train`; it is no key of a file, in which "
       "[`suggest`](../suggest.md#size-and-length) writes the size that it measures.",
       {key_table<SizeParameters>("size")}},
      {"Refinement of maps by labels",
       "Further keys of a module of type `som`, and flags of `somato som train`. "
       "[refinement.md](../mathematics/refinement.md) gives the equations.",
       {key_table<RefinementParameters>("refinement")}}};
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
  flags.push_back(output_flag("--checkpoint",
                              "File for the map after each epoch of batch training, from which the "
                              "same command continues after an interruption"));
  flags.push_back(layers_flag());
  flags.push_back(threads_flag());
  flags.push_back(memory_flag());
  std::vector<ParameterInfo> parameters = SomParameters::declarations().infos();
  for (ParameterInfo& info : SizeParameters::declarations().infos()) {
    parameters.push_back(std::move(info));
  }
  for (ParameterInfo& info : RefinementParameters::declarations().infos()) {
    parameters.push_back(std::move(info));
  }
  return {
      "som train",
      "Train a map on a table of numbers",
      {data_positional(
          "NPY, NPZ or MAT file, or text with one sample per line and numbers separated by commas, "
          "semicolons, tabs or blanks")},
      std::move(flags),
      std::move(parameters),
      train,
      {"map", "size", "refinement"},
      key_sections_of_maps};
}

}  // namespace somato::program
