#include <cstdint>
#include <optional>
#include <utility>

#include "errors.h"
#include "interrupts.h"
#include "map.h"
#include "maps/som/som_preparation.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "parameters.h"
#include "somato/maps/layers.h"
#include "somato/maps/measured_size.h"
#include "somato/maps/refinement.h"
#include "somato/maps/som_learner.h"
#include "somato/maps/som_training.h"
#include "systems/exchange/map_array.h"
#include "systems/exchange/map_import.h"
#include "systems/model/complete_inputs.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

const std::string kPlace = "SOM";

// From tuples of name, number of columns, distance, weight and scale.
std::vector<Layer> layers_of(const nb::object& list) {
  std::vector<Layer> layers;
  std::size_t first = 0;
  for (const nb::handle item : list) {
    const auto name = nb::cast<std::string>(item[0]);
    const auto count = nb::cast<std::size_t>(item[1]);
    const auto distance =
        choice_named<Similarity>("distance", nb::cast<std::string>(item[2]), "SOM(layers)");
    Layer layer{name, first, count, value_or_throw(distance), nb::cast<double>(item[3]), {}};
    if (!nb::object(item[4]).is_none()) layer.scale = nb::cast<double>(item[4]);
    layers.push_back(std::move(layer));
    first += count;
  }
  return layers;
}

SomParameters checked_parameters(const nb::dict& all_values) {
  const nb::dict values = nb::borrow<nb::dict>(all_values.attr("copy")());
  const nb::object layers = values.attr("pop")("layers", nb::make_tuple());
  auto parameters = parameters_of<SomParameters>(values, kPlace);
  parameters.layers = layers_of(layers);
  const SomParameters defaults;
  for (const auto& parameter : SomParameters::declarations().all()) {
    if (parameter.read(parameters) == parameter.read(defaults)) continue;
    const std::string reason = reason_without_effect(parameters, parameter.info.name);
    if (reason.empty()) continue;
    throw Failure{without_effect(parameter.info.name, reason, kPlace)};
  }
  return parameters;
}

// Parameters that a measured size decides must have their defaults.
void check_decided_by_size(const SomParameters& parameters) {
  const SomParameters defaults;
  for (const auto& parameter : SomParameters::declarations().all()) {
    if (parameter.read(parameters) == parameter.read(defaults)) continue;
    const std::string reason = reason_without_effect(SizeChoice::kMeasured, parameter.info.name);
    if (!reason.empty()) throw Failure{without_effect(parameter.info.name, reason, kPlace)};
  }
}

RefinementParameters checked_refinement(const nb::dict& values) {
  const auto parameters = parameters_of<RefinementParameters>(values, kPlace);
  const RefinementParameters defaults;
  for (const auto& parameter : RefinementParameters::declarations().all()) {
    if (parameter.read(parameters) == parameter.read(defaults)) continue;
    const std::string reason = reason_without_effect(parameters, parameter.info.name);
    if (!reason.empty()) throw Failure{without_effect(parameter.info.name, reason, kPlace)};
  }
  return parameters;
}

nb::dict dict_of_order(const MapOrder& order) {
  nb::dict values;
  values["quantization_error"] = order.quantization_error;
  values["topographic_error"] = order.topographic_error;
  values["trustworthiness"] = order.trustworthiness;
  values["continuity"] = order.continuity;
  return values;
}

nb::dict dict_of_order(const RefinedOrder& order) {
  nb::dict values;
  values["before"] = dict_of_order(order.before);
  values["after"] = dict_of_order(order.after);
  values["named_by_nearest"] = order.named_by_nearest;
  values["classes_without_neuron"] = order.classes_without_neuron;
  return values;
}

// Without the rows that it was trained on, which belong to others.
Som apart_from_samples(const Som& som) {
  return som.products() ? Som(som.parameters(), som.weights(), som.elements()) : som;
}

// Initial weights know no missing values.
Samples complete(const SampleRows& rows) {
  return rows.leaves_out() ? filled_with(rows.means(), rows.all()) : rows.all();
}

}  // namespace

void check_map_refinement(const nb::dict& refinement, const nb::dict& som) {
  value_or_throw(check_refinement(checked_refinement(refinement), checked_parameters(som)));
}

Map Map::train(const nb::dict& values, const SampleRows& rows, std::size_t threads,
               nb::object progress) {
  const SomParameters parameters = checked_parameters(values);
  Som som;
  std::uint64_t steps = 0;
  unlocked(
      [&](Interrupts& interrupts) {
        const Samples samples = rows.all();
        TrainingOptions options{threads, interrupts.progress()};
        options.steps_done = &steps;
        auto trained = rows.leaves_out() ? train_leaving_out(parameters, samples, options)
                                         : train_som(parameters, samples, options);
        if (!trained && trained.error().kind == ErrorKind::kInterrupted) return;
        som = apart_from_samples(value_or_throw(std::move(trained)));
      },
      std::move(progress));
  Map map(SomModel{std::move(som), {}, {}, {}, {}, rows.means()});
  map.steps_ = steps;
  const bool counts = parameters.is_length_automatic() && parameters.training == Training::kOnline;
  if (counts) map.model_.samples_seen = steps;
  return map;
}

nb::tuple Map::sized(const nb::dict& values, const SampleRows& rows, std::size_t threads) {
  const SomParameters parameters = checked_parameters(values);
  check_decided_by_size(parameters);
  std::optional<SizedParameters> sized;
  unlocked([&](Interrupts& interrupts) {
    const auto proceed = [&]() -> Result<void> {
      if (interrupts.proceed()) return {};
      return fail(ErrorKind::kInterrupted, "the measurement of the size was stopped");
    };
    auto found =
        sized_by_measurement(parameters, rows.all(), {.threads = threads, .proceed = proceed});
    if (!found && found.error().kind == ErrorKind::kInterrupted) return;
    sized = value_or_throw(std::move(found));
  });
  nb::list checks;
  for (const SizeCheck& check : sized->size.checks) {
    checks.append(nb::make_tuple(check.neurons, check.error));
  }
  return nb::make_tuple(dict_of(sized->parameters), checks);
}

Map Map::initial(const nb::dict& values, const SampleRows& rows) {
  Som som =
      apart_from_samples(value_or_throw(untrained_som(checked_parameters(values), complete(rows))));
  return Map(SomModel{std::move(som), {}, {}, {}, {}, rows.means(), 0});
}

Map Map::of_weights(const nb::dict& parameters, const Rows& weights,
                    const std::vector<std::uint64_t>& shape, std::vector<std::string> features) {
  Matrix<float> copy(weights.shape(0), weights.shape(1),
                     {weights.data(), weights.data() + weights.size()});
  return Map(value_or_throw(map_of_weights(checked_parameters(parameters), {shape, std::move(copy)},
                                           std::move(features), "SOM.from_weights")));
}

nb::tuple Map::imported(const std::string& path, const nb::dict& parameters,
                        std::vector<std::string> features, const std::string& variable) {
  ImportedMap map = value_or_throw(
      import_map(path, {table_of(parameters, kPlace), std::move(features), variable}));
  return nb::make_tuple(Map(std::move(map.model)), std::move(map.notes));
}

Map Map::learned(const SampleRows& rows, std::size_t threads) const {
  check_rows(rows);
  SomModel changed = model_;
  const std::uint64_t done = changed.seen();
  changed.samples_seen = done + rows.count();
  const Schedule rate = changed.som.parameters().learning_rate();
  const Schedule radius = changed.som.parameters().radius();
  unlocked([&](Interrupts& interrupts) {
    SomLearner learner(changed.som, threads, rows.leaves_out());
    for_each_part(rows, interrupts, [&](Samples part, std::size_t first) {
      // Known elements only; those of `part` have been filled.
      if (rows.leaves_out()) part = taking(rows).prepare(rows.part(first, part.count()));
      std::vector<SignalView> inputs(part.count());
      std::vector<LearningStep> steps(part.count());
      for (std::size_t i = 0; i < part.count(); ++i) {
        inputs[i] = part[i];
        steps[i] = {rate.at(done + first + i), radius.at(done + first + i)};
      }
      learner.learn(inputs, steps);
    });
  });
  if (may_diverge(changed.som.parameters())) value_or_throw(check_bounded(changed.som));
  return Map(std::move(changed));
}

nb::tuple Map::refined(const SampleRows& rows, const Numbers<std::int64_t>& classes,
                       const nb::dict& parameters, std::size_t threads, nb::object progress) const {
  check_rows(rows);
  const RefinementParameters refinement = checked_refinement(parameters);
  std::vector<std::optional<std::size_t>> of_rows(rows.count());
  for (std::size_t i = 0; i < of_rows.size(); ++i) {
    const std::int64_t one = classes.data()[i];
    if (one >= 0) of_rows[i] = static_cast<std::size_t>(one);
  }
  RefinedSom refined;
  unlocked(
      [&](Interrupts& interrupts) {
        const RefinementOptions options{model_.som.parameters().seed, threads,
                                        interrupts.progress()};
        auto found = refine_som(model_.som, rows.all(), of_rows, refinement, options);
        if (!found && found.error().kind == ErrorKind::kInterrupted) return;
        refined = value_or_throw(std::move(found));
      },
      std::move(progress));
  Map map = *this;
  map.model_.som = std::move(refined.som);
  return nb::make_tuple(std::move(map), dict_of_order(refined.order));
}

}  // namespace somato::python
