#include "system.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "errors.h"
#include "maps/pictures/map_panels.h"
#include "nanobind/stl/optional.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "parameters.h"
#include "somato/drawing/map_picture.h"
#include "somato/graph/answers.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/further_learning.h"
#include "somato/graph/live_system.h"
#include "somato/graph/system_contributions.h"
#include "somato/recording/recording.h"
#include "systems/graph/layout_fit.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

/// A trained system that processes frames; keeps the system alive.
class Live {
 public:
  explicit Live(const TrainedSystem& trained)
      : trained_(trained),
        live_(value_or_throw(LiveSystem::build(trained_.system(), trained.map()))) {}

  const std::vector<std::string>& channels() const { return live_.channels(); }
  void start(double frame_rate) { live_.start(frame_rate); }

  void step(const std::vector<Numbers<float>>& frame) {
    std::vector<std::span<const float>> channels;
    channels.reserve(frame.size());
    for (const auto& values : frame) channels.emplace_back(values.data(), values.size());
    value_or_throw(live_.step(channels));
  }

  std::size_t winner() { return value_or_throw(live_.winner()); }

  // The label of the most similar neuron that has one.
  std::optional<std::string> label() {
    const std::optional<SystemAnswer>& answer = trained_.model->answer;
    if (!answer || answer->labels.labelled().empty()) return {};
    auto named = answer->labels[winner()];
    if (!named) {
      named = answer->labels[value_or_throw(live_.winner_among(answer->labels.labelled()))];
    }
    return answer->classes[*named];
  }

 private:
  TrainedSystem trained_;
  LiveSystem live_;
};

// An array of (values, shape), or for one value per exploration of the shape.
nb::object array_of_outputs(const Sequence& outputs, const PortType& type) {
  const std::size_t size = outputs.values.size();
  std::vector<float> dense(outputs.values.count() * size);
  for (std::size_t i = 0; i < outputs.values.count(); ++i) {
    write_dense(outputs.values[i], std::span(dense).subspan(i * size, size));
  }
  std::vector<std::size_t> shape = type.shape;
  if (type.rate == Rate::kFrame) shape.insert(shape.begin(), outputs.values.count());
  return array_of(std::move(dense), shape);
}

// The outputs of a module, a list of one array for each exploration.
nb::list outputs_of(const TrainedSystem& trained, const Recording& recording,
                    const std::string& module, std::size_t threads) {
  const System& system = trained.system();
  const std::size_t wanted = value_or_throw(system.find(module, "evaluate(module)"));
  value_or_throw(check_layout(system, layout_of(recording)));
  std::vector<std::size_t> all(recording.explorations.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Activations activations(system.modules().size(), all.size());
  Result<void> evaluated;
  {
    const nb::gil_scoped_release released;
    evaluated = evaluate(system, recording, all, {wanted}, threads, activations);
  }
  value_or_throw(std::move(evaluated));
  nb::list outputs;
  for (const std::size_t i : all) {
    outputs.append(array_of_outputs(*activations.find(wanted, i), system.modules()[wanted].output));
  }
  return outputs;
}

// Those of the description, with the type of the output.
nb::list trained_modules(const TrainedSystem& trained) {
  nb::list modules = modules_of(trained.system().description());
  for (std::size_t i = 0; i < modules.size(); ++i) {
    modules[i]["output"] = to_string(trained.system().modules()[i].output);
  }
  return modules;
}

bool is_port(const ModuleType& type, const std::string& name) {
  return std::any_of(type.ports.begin(), type.ports.end(),
                     [&](const InputPort& port) { return port.name == name; });
}

// The description may be of a system that cannot be built.
const ModuleType& type_of(const ModuleDescription& module) {
  const Table::Entry* entry = module.settings.find("type");
  const Value* value = entry ? std::get_if<Value>(&entry->content) : nullptr;
  const auto* type = value ? std::get_if<std::string>(&value->content) : nullptr;
  return *value_or_throw(find_module_type(type ? *type : "", module.settings.where));
}

nb::dict description_of_module(const ModuleDescription& module) {
  const ModuleType& type = type_of(module);
  nb::dict inputs;
  nb::dict parameters;
  for (const Table::Entry& entry : module.settings.entries) {
    const Value* value = std::get_if<Value>(&entry.content);
    if (!value || entry.name == "type") continue;
    (is_port(type, entry.name) ? inputs : parameters)[entry.name.c_str()] = object_of(*value);
  }
  nb::dict described;
  described["name"] = module.name;
  described["type"] = type.name;
  described["inputs"] = std::move(inputs);
  described["parameters"] = std::move(parameters);
  return described;
}

// For each exploration: winner, its distance, the name that is answered, the most similar class,
// and the novelty or None.
nb::list answers_of(const TrainedSystem& trained, const Recording& recording, std::size_t threads) {
  value_or_throw(check_layout(trained.system(), layout_of(recording)));
  Result<std::vector<InputAnswer>> given;
  {
    const nb::gil_scoped_release released;
    given = answers(*trained.model, recording, threads);
  }
  nb::list rows;
  for (const InputAnswer& one : value_or_throw(std::move(given))) {
    const std::vector<std::string>& classes = trained.model->answer->classes;
    rows.append(nb::make_tuple(one.winner, one.winner_distance, one.name(classes),
                               classes[one.nearest], one.novelty));
  }
  return rows;
}

// For each exploration: the classes that are compared, the distances, and an array for each source.
// First the sources: name, whether it is a channel, its elements; and the unit.
nb::tuple contributions_of(const TrainedSystem& trained, const Recording& recording,
                           std::size_t threads) {
  value_or_throw(check_layout(trained.system(), layout_of(recording)));
  const ContributionReader reader = value_or_throw(ContributionReader::build(trained.model));
  std::vector<InputContributions> read;
  Result<Samples> inputs;
  {
    const nb::gil_scoped_release released;
    inputs = inputs_to_answer(*trained.model, recording, threads);
    if (inputs) read = reader.read(*inputs, threads);
  }
  value_or_throw(std::move(inputs));
  nb::list sources;
  for (const ContributionSource& source : reader.sources()) {
    sources.append(nb::make_tuple(source.name, source.is_channel, source.elements));
  }
  const std::vector<std::string>& classes = trained.model->answer->classes;
  nb::list rows;
  for (const InputContributions& one : read) {
    nb::list values;
    for (const std::vector<double>& of_source : one.values) {
      const std::size_t shape[] = {of_source.size()};
      values.append(array_of(std::vector<double>(of_source), shape));
    }
    rows.append(nb::make_tuple(classes[one.nearest], classes[one.other], one.of_nearest,
                               one.of_other, std::move(values)));
  }
  return nb::make_tuple(std::move(sources), reader.unit(), std::move(rows));
}

// A copy that knows the name.
TrainedSystem taught(const TrainedSystem& trained, const Recording& recording,
                     std::size_t exploration, const std::string& name) {
  value_or_throw(check_layout(trained.system(), layout_of(recording)));
  value_or_throw(answering_map(*trained.model));
  SystemModel model = copy_of(*trained.model);
  value_or_throw(teach(model, recording, exploration, name));
  return {std::make_shared<const SystemModel>(std::move(model))};
}

std::string picture_of(const TrainedSystem& trained) {
  const std::size_t map = trained.map();
  const Som& som = *som_of(trained.system(), map);
  return draw_picture(trained.system().modules()[map].name, "", {u_matrix_panel(som)});
}

}  // namespace

std::size_t TrainedSystem::map() const {
  if (model->answer) return value_or_throw(system().find(model->answer->map));
  for (std::size_t i = system().modules().size(); i-- > 0;) {
    if (som_of(system(), i)) return i;
  }
  throw Failure{Error{ErrorKind::kUsage, "the system has no map", "load", "train one with a map"}};
}

nb::list modules_of(const SystemDescription& description) {
  nb::list modules;
  for (const ModuleDescription& module : description.modules) {
    modules.append(description_of_module(module));
  }
  return modules;
}

void bind_system(nb::module_& module) {
  nb::class_<Live>(module, "Live", "A trained system that processes frames.")
      .def("channels", &Live::channels)
      .def("start", &Live::start, nb::arg("frame_rate"))
      .def("step", &Live::step, nb::arg("frame"))
      .def("winner", &Live::winner)
      .def("label", &Live::label);
  nb::class_<TrainedSystem>(module, "TrainedSystem", "A trained system.")
      .def("live", [](const TrainedSystem& trained) { return Live(trained); })
      .def("toml",
           [](const TrainedSystem& trained) { return to_toml(trained.system().description()); })
      .def("modules", &trained_modules)
      .def("outputs", &outputs_of, nb::arg("recording"), nb::arg("module"), nb::arg("threads"))
      .def("answers", &answers_of, nb::arg("recording"), nb::arg("threads"))
      .def("contributions", &contributions_of, nb::arg("recording"), nb::arg("threads"))
      .def("taught", &taught, nb::arg("recording"), nb::arg("exploration"), nb::arg("name"))
      .def("picture", &picture_of)
      .def(
          "save",
          [](const TrainedSystem& trained, const std::string& path) {
            value_or_throw(save_system(path, trained.system(), trained.model->answer));
          },
          nb::arg("path"));
  module.def(
      "load_system",
      [](const std::string& path) {
        return TrainedSystem{
            std::make_shared<const SystemModel>(value_or_throw(load_system(path)))};
      },
      nb::arg("path"));
}

}  // namespace somato::python
