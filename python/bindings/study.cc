#include "somato/studies/study.h"

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "arrays.h"
#include "base/files/toml_file.h"
#include "base/files/whole_file.h"
#include "bindings.h"
#include "errors.h"
#include "interrupts.h"
#include "map.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "parameters.h"
#include "somato/graph/system_model.h"
#include "somato/studies/own_systems.h"
#include "somato/studies/reproduction.h"
#include "studies/results/saved_model.h"
#include "studies/run/winners_picture.h"
#include "system.h"

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

// The study with other values of parameters of its table [study]. What only protocols of its file
// read has no effect on others.
StudyDescription with_settings(StudyDescription description, const nb::dict& settings) {
  std::vector<std::string> given;
  for (const Table::Entry& entry : table_of(settings, "study").entries) {
    const auto parameter = StudyParameters::declarations().find(entry.name);
    if (!parameter) {
      throw Failure{
          unknown_name("parameter", entry.name, "study", StudyParameters::declarations().names())};
    }
    read_or_throw(parameter->assign(description.study, std::get<Value>(entry.content)));
    given.push_back(entry.name);
  }
  reset_unread(description.study, given);
  // Read again, because its parts are checked together.
  auto read = parse_toml(to_toml(description), description.where).and_then([](const Table& table) {
    return read_study(table);
  });
  if (!read) read.error().where = "study";  // not a line of the file
  return value_or_throw(std::move(read));
}

/// The outcome of a study, for Python.
struct Outcome {
  Results results;
  TrainedSystem trained;
  Map map;
  std::vector<std::size_t> winners;
  Classes classes;
  std::string picture;  // of the winners
};

// The files of 'somato run'; the results, which name the others, come last.
void save(const Outcome& outcome, const std::string& folder) {
  const std::filesystem::path path(folder);
  Results results = outcome.results;
  value_or_throw(save_whole((path / "map.svg").string(), outcome.picture));
  value_or_throw(save_model(path, "system.somato", *outcome.trained.model, results.parts.front()));
  value_or_throw(save_whole((path / "results.json").string(), to_json(results)));
}

Outcome run(const Recording& recording, const StudyDescription& given, const nb::dict& settings,
            std::size_t threads, nb::object progress) {
  const StudyDescription description = with_settings(given, settings);
  Result<StudyOutcome> outcome;
  unlocked(
      [&](Interrupts& interrupts) {
        outcome = run_study(description, recording, {threads, interrupts.progress()});
      },
      std::move(progress));
  StudyOutcome done = value_or_throw(std::move(outcome));
  std::string picture = winners_picture(description, done);
  Map map(SomModel{done.map(), {}, {}, {}, {}});
  Results results;
  results.parts.push_back(std::move(done.results));
  return {std::move(results),      {std::make_shared<const SystemModel>(std::move(done.model))},
          std::move(map),          std::move(done.winners),
          std::move(done.classes), std::move(picture)};
}

}  // namespace

void bind_study(nb::module_& module) {
  nb::class_<StudyDescription>(module, "StudyDescription",
                               "A study, as its TOML file describes it.")
      .def_static("read", &read_description, nb::arg("name"))
      .def_prop_ro("name",
                   [](const StudyDescription& description) { return description.study.name; })
      .def("toml", [](const StudyDescription& description) { return to_toml(description); })
      .def("modules",
           [](const StudyDescription& description) { return modules_of(description.system); });
  nb::class_<Outcome>(module, "Outcome", "The outcome of a study.")
      .def_prop_ro("results", [](const Outcome& outcome) { return to_json(outcome.results); })
      .def_ro("trained", &Outcome::trained)
      .def_ro("map", &Outcome::map)
      .def_prop_ro("winners", [](const Outcome& outcome) { return integers(outcome.winners); })
      .def_prop_ro("classes",
                   [](const Outcome& outcome) { return integers(outcome.classes.of_sample); })
      .def_prop_ro("class_names", [](const Outcome& outcome) { return outcome.classes.names; })
      .def_ro("picture", &Outcome::picture)
      .def("save", &save, nb::arg("folder"));
  module.def("study", &run, nb::arg("recording"), nb::arg("description"), nb::arg("settings"),
             nb::arg("threads"), nb::arg("progress").none());
  module.def("own_files", &own_file_names);
}

}  // namespace somato::python
