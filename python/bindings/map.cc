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
#include "maps/som/sample_range.h"
#include "maps/training/batch_training.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "parameters.h"
#include "somato/maps/layers.h"
#include "somato/maps/som_learner.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"
#include "systems/model/complete_inputs.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

const std::string kPlace = "SOM";

// Rows between two looks at signals.
constexpr std::size_t kRowsAtOnce = 4096;

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
  for (std::size_t first = 0; first < rows.count() && interrupts.proceed(); first += kRowsAtOnce) {
    const std::size_t count = std::min(kRowsAtOnce, rows.count() - first);
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
  unlocked(
      [&](Interrupts& interrupts) {
        const Samples samples = rows.all();
        const TrainingOptions options{threads, interrupts.progress()};
        auto trained = rows.leaves_out() ? train_leaving_out(parameters, samples, options)
                                         : train_som(parameters, samples, options);
        if (!trained && trained.error().kind == ErrorKind::kInterrupted) return;
        som = apart_from_samples(value_or_throw(std::move(trained)));
      },
      std::move(progress));
  return Map(SomModel{std::move(som), {}, {}, {}, {}, rows.means()});
}

Map Map::initial(const nb::dict& values, const SampleRows& rows) {
  Som som =
      apart_from_samples(value_or_throw(untrained_som(checked_parameters(values), complete(rows))));
  return Map(SomModel{std::move(som), {}, {}, {}, {}, rows.means(), 0});
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
  return Map(std::move(changed));
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

// Missing values of other layers are left out of the distance.
nb::object Map::predict_layer(const SampleRows& rows, const std::string& name,
                              std::size_t threads) const {
  check_rows(rows);
  const Layer layer = value_or_throw(layer_named(model_.som.parameters(), name));
  std::vector<float> predicted(rows.count() * layer.count);
  unlocked([&](Interrupts& interrupts) {
    for_each_part(taking(rows), rows, interrupts, [&](Samples part, std::size_t first) {
      const bool fills = rows.missing() == MissingFill::kMean;
      if (!fills) part = taking(rows).prepare(rows.part(first, part.count()));
      const Matrix<float> found = somato::predict_layer(model_.som, layer, part, threads);
      std::copy(found.values().begin(), found.values().end(),
                predicted.begin() + static_cast<std::ptrdiff_t>(first * layer.count));
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

nb::object Map::winners(const SampleRows& rows, std::size_t threads) const {
  check_rows(rows);
  std::vector<std::int64_t> winners(rows.count());
  unlocked([&](Interrupts& interrupts) {
    for_each_part(taking(rows), rows, interrupts, [&](const Samples& part, std::size_t first) {
      const auto found = winners_of(model_.som, part, threads);
      std::copy(found.begin(), found.end(), winners.begin() + static_cast<std::ptrdiff_t>(first));
    });
  });
  return array_of(std::move(winners));
}

nb::object Map::activity(const SampleRows& rows, std::size_t threads) const {
  check_rows(rows);
  const std::size_t neurons = model_.som.neurons();
  std::vector<float> activity(rows.count() * neurons);
  unlocked([&](Interrupts& interrupts) {
    for_each_part(taking(rows), rows, interrupts, [&](const Samples& part, std::size_t first) {
      for_each_range(part.count(), threads, [&](std::size_t begin, std::size_t end) {
        SomWorkspace workspace;
        for (std::size_t i = begin; i < end; ++i) {
          model_.som.activity(part[i], workspace,
                              {activity.data() + (first + i) * neurons, neurons});
        }
      });
    });
  });
  const std::size_t shape[] = {rows.count(), neurons};
  return array_of(std::move(activity), shape);
}

template <typename NumberOf>
nb::object Map::numbers_of(const SampleRows& rows, std::size_t threads, NumberOf number_of) const {
  check_rows(rows);
  std::vector<std::int64_t> numbers(rows.count());
  unlocked([&](Interrupts& interrupts) {
    for_each_part(taking(rows), rows, interrupts, [&](const Samples& part, std::size_t first) {
      for_each_range(part.count(), threads, [&](std::size_t begin, std::size_t end) {
        SomWorkspace workspace;
        for (std::size_t i = begin; i < end; ++i) {
          numbers[first + i] = static_cast<std::int64_t>(number_of(part[i], workspace));
        }
      });
    });
  });
  return array_of(std::move(numbers));
}

nb::object Map::classes(const SampleRows& rows, std::size_t threads) const {
  return numbers_of(rows, threads, [&](const SignalView& row, SomWorkspace& workspace) {
    return model_.labels.classify(model_.som, row, workspace);
  });
}

nb::object Map::labelled_winners(const SampleRows& rows, std::size_t threads) const {
  return numbers_of(rows, threads, [&](const SignalView& row, SomWorkspace& workspace) {
    return model_.som.winner_among(model_.labels.labelled(), row, workspace);
  });
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
  module.def("available_threads", &available_threads, "Threads that the machine runs at once.");
  nb::class_<Map>(module, "Map", "A trained map, as model files contain it.")
      .def_static("train", &Map::train, nb::arg("parameters"), nb::arg("rows"), nb::arg("threads"),
                  nb::arg("progress").none() = nb::none())
      .def_static("initial", &Map::initial, nb::arg("parameters"), nb::arg("rows"))
      .def("learned", &Map::learned, nb::arg("rows"), nb::arg("threads"))
      .def("labelled", &Map::labelled, nb::arg("names"), nb::arg("winners").noconvert(),
           nb::arg("classes").noconvert())
      .def("named", &Map::named, nb::arg("features"))
      .def("winners", &Map::winners, nb::arg("rows"), nb::arg("threads"))
      .def("activity", &Map::activity, nb::arg("rows"), nb::arg("threads"))
      .def("classes", &Map::classes, nb::arg("rows"), nb::arg("threads"))
      .def("labelled_winners", &Map::labelled_winners, nb::arg("rows"), nb::arg("threads"))
      .def("quality", &Map::quality, nb::arg("rows"), nb::arg("threads"))
      .def("layer_columns", &Map::layer_columns, nb::arg("layer"))
      .def("predict_layer", &Map::predict_layer, nb::arg("rows"), nb::arg("layer"),
           nb::arg("threads"))
      .def_prop_ro("layers", &Map::layers)
      .def("weights", &Map::weights)
      .def("u_matrix", &Map::u_matrix)
      .def("cells", &Map::cells)
      .def_prop_ro("parameters",
                   [](const Map& map) { return dict_of(map.model().som.parameters()); })
      .def_prop_ro("samples_seen", [](const Map& map) { return map.model().seen(); })
      .def("offsets", &Map::offsets)
      .def("deviations", &Map::deviations)
      .def_prop_ro("features", [](const Map& map) { return map.model().features; })
      .def_prop_ro("class_names", [](const Map& map) { return map.model().classes; })
      .def_prop_ro("input_size", [](const Map& map) { return map.model().som.input_size(); })
      .def(
          "save",
          [](const Map& map, const std::string& path) {
            value_or_throw(save_som_model(path, map.model()));
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
