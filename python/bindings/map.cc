#include "map.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/core/threads.h"
#include "bindings.h"
#include "errors.h"
#include "maps/pictures/cells.h"
#include "maps/som/sample_range.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "parameters.h"
#include "somato/maps/layers.h"
#include "somato/maps/measured_size.h"
#include "somato/maps/refinement.h"
#include "somato/maps/som_quality.h"
#include "systems/exchange/map_npz_writer.h"
#include "systems/model/complete_inputs.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

// Rows between two looks at signals: so many that the preparation of a search is worth it, and that
// they take less than a second.
constexpr std::size_t kLeastRowsAtOnce = 4096;
constexpr std::size_t kMostRowsAtOnce = 65536;
constexpr std::size_t kProductsAtOnce = std::size_t{1} << 34;

std::size_t rows_at_once(const Som& som) {
  const std::size_t products_of_row = std::max<std::size_t>(1, som.neurons() * som.input_size());
  return std::clamp(kProductsAtOnce / products_of_row, kLeastRowsAtOnce, kMostRowsAtOnce);
}

Result<void> check_row(const SignalView& prepared, std::size_t row) {
  if (is_in_range(prepared)) return {};
  return fail(ErrorKind::kData,
              fmt::format("row {} has values too large for the map, which computes distances in "
                          "single precision",
                          row),
              "X", "leave the row out, or scale all rows");
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

nb::list Map::layers() const {
  nb::list layers;
  for (const Layer& layer : model_.som.parameters().layers) {
    layers.append(nb::make_tuple(layer.name, layer.count, choice_name(layer.similarity),
                                 layer.weight, layer.scale.value_or(1.0)));
  }
  return layers;
}

void Map::for_each_part(const SampleRows& rows, Interrupts& interrupts,
                        const std::function<void(const Samples&, std::size_t first)>& work) const {
  const SomModel& model = taking(rows);
  const std::size_t at_once = rows_at_once(model.som);
  for (std::size_t first = 0; first < rows.count() && interrupts.proceed(); first += at_once) {
    const std::size_t count = std::min(at_once, rows.count() - first);
    const Samples part = complete_inputs(model, rows.missing(), rows.part(first, count));
    for (std::size_t i = 0; i < count; ++i) value_or_throw(check_row(part[i], first + i));
    work(part, first);
  }
}

Samples Map::inputs(const SampleRows& rows) const {
  check_rows(rows);
  Samples inputs = complete_inputs(taking(rows), rows.missing(), rows.all());
  for (std::size_t i = 0; i < inputs.count(); ++i) value_or_throw(check_row(inputs[i], i));
  return inputs;
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
  module.def("check_refinement", &check_map_refinement, nb::arg("refinement"), nb::arg("som"),
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
