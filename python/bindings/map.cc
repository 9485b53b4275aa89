#include "map.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <span>
#include <utility>

#include "base/core/threads.h"
#include "bindings.h"
#include "errors.h"
#include "interrupts.h"
#include "maps/pictures/cells.h"
#include "maps/reading/sample_reader.h"
#include "maps/reading/weight_plane.h"
#include "maps/som/sample_range.h"
#include "maps/som/som_preparation.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "parameters.h"
#include "somato/maps/contributions.h"
#include "somato/maps/layers.h"
#include "somato/maps/measured_size.h"
#include "somato/maps/refinement.h"
#include "somato/maps/som_learner.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"
#include "systems/exchange/map_array.h"
#include "systems/exchange/map_import.h"
#include "systems/exchange/map_npz_writer.h"
#include "systems/model/complete_inputs.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

const std::string kPlace = "SOM";

// Rows between two looks at signals: so many that the preparation of a search is worth it, and that
// they take less than a second.
constexpr std::size_t kLeastRowsAtOnce = 4096;
constexpr std::size_t kMostRowsAtOnce = 65536;
constexpr std::size_t kProductsAtOnce = std::size_t{1} << 34;

std::size_t rows_at_once(const Som& som) {
  const std::size_t products_of_row = std::max<std::size_t>(1, som.neurons() * som.input_size());
  return std::clamp(kProductsAtOnce / products_of_row, kLeastRowsAtOnce, kMostRowsAtOnce);
}

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

Result<void> check_row(const SignalView& prepared, std::size_t row) {
  if (is_in_range(prepared)) return {};
  return fail(ErrorKind::kData,
              fmt::format("row {} has values too large for the map, which computes distances in "
                          "single precision",
                          row),
              "X", "leave the row out, or scale all rows");
}

// Calls `work` with parts of the rows as inputs of the map, and the number of the part's first row.
void for_each_part(const SomModel& model, const SampleRows& rows, Interrupts& interrupts,
                   const std::function<void(const Samples&, std::size_t first)>& work) {
  const std::size_t at_once = rows_at_once(model.som);
  for (std::size_t first = 0; first < rows.count() && interrupts.proceed(); first += at_once) {
    const std::size_t count = std::min(at_once, rows.count() - first);
    const Samples part = complete_inputs(model, rows.missing(), rows.part(first, count));
    for (std::size_t i = 0; i < count; ++i) value_or_throw(check_row(part[i], first + i));
    work(part, first);
  }
}

// Computes without the lock of the interpreter. Throws the exception of a signal's handler, or of
// `progress`.
void unlocked(const std::function<void(Interrupts&)>& work, nb::object progress = nb::none()) {
  Interrupts interrupts(std::move(progress));
  {
    const nb::gil_scoped_release released;
    work(interrupts);
  }
  interrupts.throw_raised();
}

// The parameters; those without effect, which no training takes, have their defaults.
nb::dict parameters_with_effect(const Map& map) {
  const SomParameters& parameters = map.model().som.parameters();
  nb::dict values = dict_of(parameters);
  const nb::dict defaults = dict_of(SomParameters());
  for (const auto& [name, value] : defaults) {
    const auto text = nb::cast<std::string>(name);
    if (!reason_without_effect(parameters, text).empty()) values[name] = value;
  }
  return values;
}

// The name of each neuron's class, or None.
nb::list neuron_labels(const Map& map) {
  nb::list names;
  const SomModel& model = map.model();
  for (std::size_t i = 0; i < model.labels.neurons(); ++i) {
    const std::optional<std::size_t> label = model.labels[i];
    names.append(label ? nb::cast(model.classes[*label]) : nb::none());
  }
  return names;
}

}  // namespace

Map::Map(SomModel model) : model_(std::move(model)) {
  if (!model_.standardization) return;
  const std::vector<double> offsets = model_.standardization->offsets();
  if (std::all_of(offsets.begin(), offsets.end(), [](double one) { return one == 0.0; })) return;
  moved_ = model_;
  moved_->subtract_offsets();
}

const SomModel& Map::taking(const SampleRows& rows) const {
  return rows.is_moved() && moved_ ? *moved_ : model_;
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
    for_each_part(taking(rows), rows, interrupts, [&](Samples part, std::size_t first) {
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

Map Map::labelled(const std::vector<std::string>& names, const Numbers<std::int64_t>& winners,
                  const Numbers<std::int64_t>& classes) const {
  SomModel changed = model_;
  changed.classes = names;
  changed.labels = NeuronLabels::by_majority(sizes(winners), sizes(classes), model_.som.neurons());
  return Map(std::move(changed));
}

Map Map::named(std::vector<std::string> features) const {
  SomModel changed = model_;
  changed.features = std::move(features);
  return Map(std::move(changed));
}

void Map::check_rows(const SampleRows& rows) const {
  if (rows.columns() == model_.som.input_size()) {
    Result<void> fills = check_fills(model_, rows.missing());
    if (!fills) fills.error().where = "SOM(missing)";
    value_or_throw(std::move(fills));
    return;
  }
  throw Failure{Error{ErrorKind::kData,
                      fmt::format("the data have {} columns, but the map requires {}",
                                  rows.columns(), model_.som.input_size()),
                      "X", "use the columns that the map was trained on"}};
}

nb::tuple Map::layer_columns(const std::string& layer) const {
  const Layer found = value_or_throw(layer_named(model_.som.parameters(), layer));
  return nb::make_tuple(found.first, found.count);
}

namespace {

// Whether a value of another layer than this one is known.
Result<void> check_known_beside(std::span<const float> row, const Layer& layer,
                                std::size_t number) {
  for (std::size_t d = 0; d < row.size(); ++d) {
    const bool is_of_layer = d >= layer.first && d < layer.first + layer.count;
    if (!is_of_layer && !std::isnan(row[d])) return {};
  }
  return fail(ErrorKind::kData, fmt::format("row {} has no known value of another layer", number),
              "X", "leave the row out");
}

}  // namespace

// Missing values of other layers are left out of the distance.
nb::object Map::predict_layer(const SampleRows& rows, const std::string& name,
                              std::size_t threads) const {
  check_rows(rows);
  const Layer layer = value_or_throw(layer_named(model_.som.parameters(), name));
  std::vector<double> predicted(rows.count() * layer.count);
  unlocked([&](Interrupts& interrupts) {
    for_each_part(taking(rows), rows, interrupts, [&](Samples part, std::size_t first) {
      const bool fills = rows.missing() == MissingFill::kMean;
      if (!fills) part = taking(rows).prepare(rows.part(first, part.count()));
      for (std::size_t i = 0; i < part.count(); ++i) {
        value_or_throw(check_known_beside(part[i].values, layer, first + i));
      }
      const Matrix<float> found = somato::predict_layer(model_.som, layer, part, threads);
      for (std::size_t i = 0; i < found.rows(); ++i) {
        for (std::size_t d = 0; d < layer.count; ++d) {
          predicted[(first + i) * layer.count + d] =
              in_units(model_.standardization, layer.first + d, found(i, d));
        }
      }
    });
  });
  const std::size_t shape[] = {rows.count(), layer.count};
  return array_of(std::move(predicted), shape);
}

nb::list Map::layers() const {
  nb::list layers;
  for (const Layer& layer : model_.som.parameters().layers) {
    layers.append(nb::make_tuple(layer.name, layer.count, choice_name(layer.similarity),
                                 layer.weight, layer.scale.value_or(1.0)));
  }
  return layers;
}

Samples Map::inputs(const SampleRows& rows) const {
  check_rows(rows);
  Samples inputs = complete_inputs(taking(rows), rows.missing(), rows.all());
  for (std::size_t i = 0; i < inputs.count(); ++i) value_or_throw(check_row(inputs[i], i));
  return inputs;
}

nb::object Map::activity(const SampleRows& rows, std::size_t threads) const {
  check_rows(rows);
  const std::size_t neurons = model_.som.neurons();
  const std::size_t shape[] = {rows.count(), neurons};
  auto [array, activity] = new_array<float>(shape);
  unlocked([&](Interrupts& interrupts) {
    for_each_part(taking(rows), rows, interrupts, [&](const Samples& part, std::size_t first) {
      read_activity(model_.som, part, threads,
                    activity.subspan(first * neurons, part.count() * neurons));
    });
  });
  return array;
}

template <typename NumbersOf>
nb::object Map::numbers_of(const SampleRows& rows, NumbersOf numbers_of_part) const {
  check_rows(rows);
  std::vector<std::int64_t> numbers(rows.count());
  unlocked([&](Interrupts& interrupts) {
    for_each_part(taking(rows), rows, interrupts, [&](const Samples& part, std::size_t first) {
      const std::vector<std::size_t> of_part = numbers_of_part(part);
      std::copy(of_part.begin(), of_part.end(),
                numbers.begin() + static_cast<std::ptrdiff_t>(first));
    });
  });
  return array_of(std::move(numbers));
}

nb::object Map::winners(const SampleRows& rows, std::size_t threads) const {
  SampleReader reader(model_.som, threads);
  return numbers_of(rows, [&](const Samples& part) { return first_winners(reader.read(part)); });
}

nb::object Map::classes(const SampleRows& rows, std::size_t threads) const {
  return numbers_of(
      rows, [&](const Samples& part) { return model_.labels.classify(model_.som, part, threads); });
}

nb::object Map::labelled_winners(const SampleRows& rows, std::size_t threads) const {
  SampleReader reader(model_.som, threads, model_.labels.labelled());
  return numbers_of(rows, [&](const Samples& part) { return reader.read(part).nearest; });
}

// Missing values are filled for the choice of the neurons only.
nb::tuple Map::contributions(const SampleRows& rows, std::size_t threads) const {
  check_rows(rows);
  const Som& som = model_.som;
  const std::size_t columns = som.input_size();
  std::vector<std::int64_t> neurons(2 * rows.count());
  std::vector<double> distances(2 * rows.count());
  std::vector<double> values(rows.count() * columns);
  unlocked([&](Interrupts& interrupts) {
    for_each_part(taking(rows), rows, interrupts, [&](const Samples& part, std::size_t first) {
      const auto deciding = deciding_neurons(som, model_.labels, part, threads);
      const Samples known = taking(rows).prepare(rows.part(first, part.count()));
      for_each_range(part.count(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Contributions found = somato::contributions(som, known[i], deciding[i]);
          const std::size_t row = first + i;
          neurons[2 * row] = static_cast<std::int64_t>(deciding[i].nearest);
          neurons[2 * row + 1] = static_cast<std::int64_t>(deciding[i].other);
          distances[2 * row] = found.of_nearest;
          distances[2 * row + 1] = found.of_other;
          const auto listed = som.elements().listed();
          for (std::size_t place = 0; place < found.values.size(); ++place) {
            const std::size_t column = listed.empty() ? place : listed[place];
            values[row * columns + column] = found.values[place];
          }
        }
      });
    });
  });
  const std::size_t pairs[] = {rows.count(), 2};
  const std::size_t shape[] = {rows.count(), columns};
  return nb::make_tuple(array_of(std::move(neurons), pairs), array_of(std::move(distances), pairs),
                        array_of(std::move(values), shape));
}

nb::object Map::plane_positions(const SampleRows& rows) const {
  check_rows(rows);
  std::vector<double> coordinates;
  coordinates.reserve(2 * rows.count());
  unlocked([&](Interrupts& interrupts) {
    const WeightPlane plane(model_.som);
    for_each_part(taking(rows), rows, interrupts, [&](const Samples& part, std::size_t /*first*/) {
      for (const Position& at : plane.positions_of(model_.som, part)) {
        coordinates.insert(coordinates.end(), {at.x, at.y});
      }
    });
  });
  const std::size_t shape[] = {rows.count(), 2};
  return array_of(std::move(coordinates), shape);
}

nb::tuple Map::quality(const SampleRows& rows, std::size_t threads) const {
  check_rows(rows);
  SomQuality quality;
  std::vector<std::int64_t> winners;
  winners.reserve(rows.count());
  unlocked([&](Interrupts& interrupts) {
    SomQualityMeasurement measurement(model_.som, threads);
    for_each_part(taking(rows), rows, interrupts, [&](const Samples& part, std::size_t /*first*/) {
      const auto found = measurement.add(part);
      winners.insert(winners.end(), found.begin(), found.end());
    });
    quality = measurement.quality();
  });
  return nb::make_tuple(quality.quantization_error, quality.topographic_error,
                        integers(quality.hits), array_of(std::move(winners)));
}

nb::object Map::relevances() const {
  const std::vector<double>& relevances = model_.som.parameters().relevances;
  if (relevances.empty()) return nb::none();
  const std::size_t shape[] = {relevances.size()};
  return array_of(std::vector<double>(relevances), shape);
}

nb::object Map::weights() const {
  const Som& som = model_.som;
  std::vector<float> weights(som.neurons() * som.input_size());
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    for (std::size_t element = 0; element < som.input_size(); ++element) {
      weights[neuron * som.input_size() + element] = som.weight(neuron, element);
    }
  }
  const std::size_t shape[] = {som.neurons(), som.input_size()};
  return array_of(std::move(weights), shape);
}

nb::object Map::distances(const SampleRows& rows, std::size_t threads) const {
  check_rows(rows);
  const std::size_t neurons = model_.som.neurons();
  std::vector<double> distances(rows.count() * neurons);
  unlocked([&](Interrupts& interrupts) {
    for_each_part(taking(rows), rows, interrupts, [&](const Samples& part, std::size_t first) {
      for_each_range(part.count(), threads, [&](std::size_t begin, std::size_t end) {
        SomWorkspace workspace;
        for (std::size_t i = begin; i < end; ++i) {
          double* const of_row = distances.data() + (first + i) * neurons;
          for (std::size_t neuron = 0; neuron < neurons; ++neuron) {
            of_row[neuron] = model_.som.distance(part[i], neuron, workspace);
          }
        }
      });
    });
  });
  const std::size_t shape[] = {rows.count(), neurons};
  return array_of(std::move(distances), shape);
}

nb::object Map::positions() const {
  const Grid& grid = model_.som.grid();
  std::vector<double> positions;
  positions.reserve(2 * grid.size());
  for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
    const Position position = grid.position(neuron);
    positions.insert(positions.end(), {position.x, position.y});
  }
  const std::size_t shape[] = {grid.size(), 2};
  return array_of(std::move(positions), shape);
}

nb::object Map::u_matrix() const {
  const std::size_t shape[] = {model_.som.grid().rows(), model_.som.grid().columns()};
  return array_of(somato::u_matrix(model_.som), shape);
}

nb::object Map::cells() const {
  const Cells cells(model_.som.grid(), 1.0);
  std::vector<double> corners;
  std::size_t of_each = 0;
  for (std::size_t neuron = 0; neuron < model_.som.neurons(); ++neuron) {
    const std::vector<Point> around = cells.corners(neuron);
    of_each = around.size();
    for (const Point& corner : around) {
      corners.push_back(corner.x * cells.unit().x);
      corners.push_back(corner.y * cells.unit().y);
    }
  }
  const std::size_t shape[] = {model_.som.neurons(), of_each, 2};
  return array_of(std::move(corners), shape);
}

std::vector<double> Map::offsets() const {
  return moved_ ? model_.standardization->offsets() : std::vector<double>();
}

const std::vector<double>& Map::deviations() const {
  if (!deviations_.empty()) return deviations_;
  for (const ColumnScale& scale : model_.scales()) deviations_.push_back(scale.deviation);
  return deviations_;
}

void bind_map(nb::module_& module) {
  bind_sample_rows(module);
  module.def(
      "som_parameters", [] { return descriptions_of(SomParameters::declarations().infos()); },
      "The parameters of a SOM: name, type, unit, text, range, choices and default.");
  module.def(
      "size_parameters", [] { return descriptions_of(SizeParameters::declarations().infos()); },
      "The choice of a map's size, as the parameters of a SOM.");
  module.def(
      "refinement_parameters",
      [] { return descriptions_of(RefinementParameters::declarations().infos()); },
      "The parameters of a refinement by labels, as of a SOM.");
  module.def(
      "check_refinement",
      [](const nb::dict& refinement, const nb::dict& som) {
        value_or_throw(check_refinement(checked_refinement(refinement), checked_parameters(som)));
      },
      nb::arg("refinement"), nb::arg("som"),
      "Refuses parameters with which a map cannot be refined.");
  module.def("available_threads", &available_threads, "Threads that the machine runs at once.");
  nb::class_<Map>(module, "Map", "A trained map, as model files contain it.")
      .def_static("train", &Map::train, nb::arg("parameters"), nb::arg("rows"), nb::arg("threads"),
                  nb::arg("progress").none() = nb::none())
      .def_static("sized", &Map::sized, nb::arg("parameters"), nb::arg("rows"), nb::arg("threads"))
      .def_static("initial", &Map::initial, nb::arg("parameters"), nb::arg("rows"))
      .def_static("of_weights", &Map::of_weights, nb::arg("parameters"),
                  nb::arg("weights").noconvert(), nb::arg("shape"), nb::arg("features"))
      .def_static("imported", &Map::imported, nb::arg("path"), nb::arg("parameters"),
                  nb::arg("features"), nb::arg("variable"))
      .def("learned", &Map::learned, nb::arg("rows"), nb::arg("threads"))
      .def("refined", &Map::refined, nb::arg("rows"), nb::arg("classes").noconvert(),
           nb::arg("parameters"), nb::arg("threads"), nb::arg("progress").none() = nb::none())
      .def("labelled", &Map::labelled, nb::arg("names"), nb::arg("winners").noconvert(),
           nb::arg("classes").noconvert())
      .def("named", &Map::named, nb::arg("features"))
      .def("winners", &Map::winners, nb::arg("rows"), nb::arg("threads"))
      .def("activity", &Map::activity, nb::arg("rows"), nb::arg("threads"))
      .def("classes", &Map::classes, nb::arg("rows"), nb::arg("threads"))
      .def("labelled_winners", &Map::labelled_winners, nb::arg("rows"), nb::arg("threads"))
      .def("contributions", &Map::contributions, nb::arg("rows"), nb::arg("threads"))
      .def("plane_positions", &Map::plane_positions, nb::arg("rows"))
      .def("quality", &Map::quality, nb::arg("rows"), nb::arg("threads"))
      .def("distances", &Map::distances, nb::arg("rows"), nb::arg("threads"))
      .def("layer_columns", &Map::layer_columns, nb::arg("layer"))
      .def("predict_layer", &Map::predict_layer, nb::arg("rows"), nb::arg("layer"),
           nb::arg("threads"))
      .def_prop_ro("layers", &Map::layers)
      .def("weights", &Map::weights)
      .def_prop_ro("relevances", &Map::relevances)
      .def("positions", &Map::positions)
      .def("u_matrix", &Map::u_matrix)
      .def("cells", &Map::cells)
      .def_prop_ro("parameters", &parameters_with_effect)
      .def_prop_ro("steps", &Map::steps)
      .def_prop_ro("samples_seen", [](const Map& map) { return map.model().seen(); })
      .def("offsets", &Map::offsets)
      .def("deviations", &Map::deviations)
      .def_prop_ro("features", [](const Map& map) { return map.model().features; })
      .def_prop_ro("neuron_labels", &neuron_labels)
      .def_prop_ro("class_names", [](const Map& map) { return map.model().classes; })
      .def_prop_ro("input_size", [](const Map& map) { return map.model().som.input_size(); })
      .def(
          "save",
          [](const Map& map, const std::string& path) {
            value_or_throw(save_som_model(path, map.model()));
          },
          nb::arg("path"))
      .def(
          "export_npz",
          [](const Map& map, const std::string& path) {
            auto saved = save_map_npz(path, map.model());
            if (!saved && saved.error().where.empty()) saved.error().where = path;
            value_or_throw(std::move(saved));
          },
          nb::arg("path"))
      .def_static(
          "load", [](const std::string& path) { return Map(value_or_throw(load_som_model(path))); },
          nb::arg("path"))
      .def("__getstate__",
           [](const Map& map) {
             const std::string bytes = encode_som_model(map.model());
             return nb::bytes(bytes.data(), bytes.size());
           })
      .def("__setstate__", [](Map& map, const nb::bytes& bytes) {
        new (&map) Map(value_or_throw(decode_som_model({bytes.c_str(), bytes.size()}, "pickle")));
      });
}

}  // namespace somato::python
