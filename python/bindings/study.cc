#include "somato/studies/study.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "errors.h"
#include "files/toml_file.h"
#include "files/whole_file.h"
#include "interrupts.h"
#include "map.h"
#include "nanobind/stl/optional.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "parameters.h"
#include "somato/graph/live_system.h"
#include "somato/graph/system_model.h"
#include "somato/studies/own_systems.h"
#include "somato/studies/reproduction.h"
#include "studies/winners_picture.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

Result<NamedFile> read_file_or_own(const std::string& name) {
  std::error_code unknown;
  const auto own = find_own_file(name);
  const bool is_file = std::filesystem::is_regular_file(name, unknown);
  SOMATO_TRY(const std::string text, own && !is_file ? Result<std::string>(std::string(own->text))
                                                     : read_whole(name, kLargestToml));
  return parse_toml(text, own && !is_file ? own->path : name).map([&](Table content) {
    return NamedFile{name, std::move(content), text};
  });
}

StudyDescription read_description(const std::string& name) {
  const NamedFile file = value_or_throw(read_file_or_own(name));
  if (file.content.find("question")) {
    throw Failure{Error{ErrorKind::kUsage, "the file contains a question about several systems",
                        name, "use a file with one system"}};
  }
  ReproductionPlan plan;
  value_or_throw(add_to_plan(file, {}, plan));
  return plan.parts.front().description;
}

// The study with other values of parameters of its table [study].
StudyDescription with_settings(StudyDescription description, const nb::dict& settings) {
  for (const Table::Entry& entry : table_of(settings, "study").entries) {
    const auto parameter = StudyParameters::declarations().find(entry.name);
    if (!parameter) {
      throw Failure{
          unknown_name("parameter", entry.name, "study", StudyParameters::declarations().names())};
    }
    value_or_throw(parameter->assign(description.study, std::get<Value>(entry.content)));
  }
  // Read again, because its parts are checked together.
  return value_or_throw(
      parse_toml(to_toml(description), description.where).and_then([](const Table& table) {
        return read_study(table);
      }));
}

using Model = std::shared_ptr<const SystemModel>;

/// A trained system.
struct TrainedSystem {
  Model model;

  std::size_t map() const {
    if (model->answer) return value_or_throw(model->system.find(model->answer->map));
    for (std::size_t i = model->system.modules().size(); i-- > 0;) {
      if (som_of(model->system, i)) return i;
    }
    throw Failure{
        Error{ErrorKind::kUsage, "the system has no map", "load", "train one with a map"}};
  }
};

/// A trained system that processes frames; keeps the system alive.
class Live {
 public:
  explicit Live(const TrainedSystem& trained)
      : model_(trained.model),
        live_(value_or_throw(LiveSystem::build(model_->system, trained.map()))) {}

  const std::vector<std::string>& channels() const { return live_.channels(); }
  void start(double frame_rate) { live_.start(frame_rate); }

  void step(const std::vector<Numbers<float>>& frame) {
    std::vector<std::span<const float>> channels;
    channels.reserve(frame.size());
    for (const auto& values : frame) channels.emplace_back(values.data(), values.size());
    value_or_throw(live_.step(channels));
  }

  std::size_t winner() { return value_or_throw(live_.winner()); }

  // The label of the winner, if it has one.
  std::optional<std::string> label() {
    if (!model_->answer) return {};
    const auto named = model_->answer->labels[winner()];
    return named ? std::optional(model_->answer->classes[*named]) : std::nullopt;
  }

 private:
  Model model_;
  LiveSystem live_;
};

/// The outcome of a study, for Python.
struct Outcome {
  std::string results;  // JSON
  TrainedSystem trained;
  Map map;
  std::vector<std::size_t> winners;
  Classes classes;
  std::string picture;  // of the winners
};

Outcome run(const Recording& recording, const std::string& name, const nb::dict& settings,
            std::size_t threads) {
  const StudyDescription description = with_settings(read_description(name), settings);
  Interrupts interrupts;
  Result<StudyOutcome> outcome;
  {
    const nb::gil_scoped_release released;
    outcome = run_study(description, recording, {threads, interrupts.progress()});
  }
  interrupts.throw_raised();
  StudyOutcome done = value_or_throw(std::move(outcome));
  std::string picture = winners_picture(description, done);
  Map map(SomModel{done.map(), {}, {}, {}, {}});
  Results results;
  results.parts.push_back(std::move(done.results));
  return {to_json(results),        {std::make_shared<const SystemModel>(std::move(done.model))},
          std::move(map),          std::move(done.winners),
          std::move(done.classes), std::move(picture)};
}

}  // namespace

void bind_study(nb::module_& module) {
  nb::class_<Live>(module, "Live", "A trained system that processes frames.")
      .def("channels", &Live::channels)
      .def("start", &Live::start, nb::arg("frame_rate"))
      .def("step", &Live::step, nb::arg("frame"))
      .def("winner", &Live::winner)
      .def("label", &Live::label);
  nb::class_<TrainedSystem>(module, "TrainedSystem", "A trained system.")
      .def("live", [](const TrainedSystem& trained) { return Live(trained); })
      .def(
          "toml",
          [](const TrainedSystem& trained) { return to_toml(trained.model->system.description()); })
      .def(
          "save",
          [](const TrainedSystem& trained, const std::string& path) {
            value_or_throw(save_system(path, trained.model->system, trained.model->answer));
          },
          nb::arg("path"));
  nb::class_<Outcome>(module, "Outcome", "The outcome of a study.")
      .def_ro("results", &Outcome::results)
      .def_ro("trained", &Outcome::trained)
      .def_ro("map", &Outcome::map)
      .def_prop_ro("winners", [](const Outcome& outcome) { return integers(outcome.winners); })
      .def_prop_ro("classes",
                   [](const Outcome& outcome) { return integers(outcome.classes.of_sample); })
      .def_prop_ro("class_names", [](const Outcome& outcome) { return outcome.classes.names; })
      .def_ro("picture", &Outcome::picture);
  module.def(
      "load_system",
      [](const std::string& path) {
        return TrainedSystem{
            std::make_shared<const SystemModel>(value_or_throw(load_system(path)))};
      },
      nb::arg("path"));
  module.def(
      "study_toml", [](const std::string& name) { return to_toml(read_description(name)); },
      nb::arg("name"));
  module.def("study", &run, nb::arg("recording"), nb::arg("name"), nb::arg("settings"),
             nb::arg("threads"));
  module.def("own_files", &own_file_names);
}

}  // namespace somato::python
