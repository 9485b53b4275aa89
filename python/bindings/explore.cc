#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/files/toml_file.h"
#include "bindings.h"
#include "bodies/objects/selected_things.h"
#include "bodies/sensors/sensor_parameters.h"
#include "errors.h"
#include "interrupts.h"
#include "nanobind/stl/optional.h"
#include "nanobind/stl/pair.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/unique_ptr.h"
#include "nanobind/stl/vector.h"
#include "parameters.h"
#include "recordings/explorations/nanoseconds.h"
#include "somato/bodies/exploring.h"
#include "somato/bodies/object_table.h"
#include "somato/simulation/sense.h"
#include "somato/simulation/simulated_explorer.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

ExploringParameters parameters_of(ExploringBody body, const std::optional<std::string>& settings,
                                  const nb::dict& simulation) {
  ExploringParameters parameters;
  if (settings) {
    parameters = value_or_throw(read_toml(*settings).and_then(
        [](const Table& file) { return read_exploring_parameters(file); }));
  }
  const Table given = table_of(simulation, "explore");
  value_or_throw(check_effect(body, given));
  parameters.simulation = read_or_throw(read_parameters(given, std::move(parameters.simulation)));
  return parameters;
}

ObjectTable things_of(ExploringBody body, const std::optional<std::string>& objects) {
  return value_or_throw(objects ? find_object_table(*objects, declared_materials())
                                : default_things(body));
}

std::unique_ptr<SimulatedExplorer> explorer_of(const std::string& name,
                                               const std::optional<std::string>& objects,
                                               const std::optional<std::string>& settings,
                                               const nb::dict& simulation, std::uint64_t seed) {
  const auto body = value_or_throw(choice_named<ExploringBody>("body", name, "explore(body)"));
  return value_or_throw(simulated_explorer(body, things_of(body, objects),
                                           parameters_of(body, settings, simulation), seed));
}

std::vector<std::string> failures_of(const SimulatedExplorer& explorer,
                                     const ExploringOutcome& outcome) {
  std::vector<std::string> failures;
  failures.reserve(outcome.failures.size());
  for (const FailedExploration& failed : outcome.failures) {
    failures.push_back(explorer.things()[failed.thing].name + ", trial " +
                       std::to_string(failed.trial + 1) + ": " + to_string(failed.error));
  }
  return failures;
}

// With the times that a file would contain, so that a study of the recording and of its file give
// the same results.
Exploration as_in_file(Exploration exploration) {
  for (Channel& channel : exploration.channels) {
    for (double& time : channel.times) time = seconds_of(nanoseconds_of(time).value());
  }
  return exploration;
}

// The explorations, and descriptions of those that failed.
std::pair<Recording, std::vector<std::string>> explore(const SimulatedExplorer& explorer,
                                                       std::size_t explorations, double longest,
                                                       std::size_t threads, nb::object progress) {
  Recording recording;
  Result<ExploringOutcome> outcome;
  unlocked(
      [&](Interrupts& interrupts) {
        const ExploreOptions options{.limits = {longest, [&] { return interrupts.proceed(); }}};
        outcome = explore_all(
            explorer, {explorations}, threads, options,
            [&](Exploration&& exploration) -> Result<void> {
              recording.explorations.push_back(as_in_file(std::move(exploration)));
              return {};
            },
            interrupts.progress());
      },
      std::move(progress));
  const ExploringOutcome explored = value_or_throw(std::move(outcome));
  if (recording.explorations.empty()) {
    throw Failure{
        Error{ErrorKind::kData,
              "every exploration failed; the first: " + to_string(explored.failures.front().error),
              "explore", "use other objects or settings"}};
  }
  return {std::move(recording), failures_of(explorer, explored)};
}

// The table that the selected explorations of a recording make.
Recording selected(const Recording& recording, const std::vector<std::string>& things,
                   std::optional<std::size_t> explorations) {
  return value_or_throw(select_things(recording, {things, explorations}));
}

// The explorations with the readings of other sensors, and a note if settings are not given but
// those of the explorations are not the defaults; otherwise an empty one.
std::pair<Recording, std::string> sensed(const Recording& recording,
                                         const std::optional<std::string>& settings,
                                         const nb::dict& sensors, std::optional<std::uint64_t> seed,
                                         std::size_t threads) {
  ExploringParameters parameters;
  if (settings) {
    parameters = value_or_throw(read_toml(*settings).and_then(
        [](const Table& file) { return read_exploring_parameters(file); }));
  }
  const Table given = table_of(sensors, "sense");
  value_or_throw(check_sensor_effect(given, recording.explorations.front()));
  parameters = read_or_throw(read_sensor_parameters(given, std::move(parameters)));
  Result<Recording> result;
  Result<std::string> note;
  {
    const nb::gil_scoped_release released;
    result = sense(recording, parameters, seed, threads);
    if (result && !settings) note = note_of_other_sensors(recording.explorations.front());
  }
  Recording played = value_or_throw(std::move(result));
  return {std::move(played), value_or_throw(std::move(note))};
}

}  // namespace

void bind_explore(nb::module_& module) {
  nb::class_<SimulatedExplorer>(module, "Explorer",
                                "A simulated body with the things that it explores.")
      .def_static("build", &explorer_of, nb::arg("body"), nb::arg("objects").none(),
                  nb::arg("settings").none(), nb::arg("simulation"), nb::arg("seed"))
      .def("explore", &explore, nb::arg("explorations"), nb::arg("longest"), nb::arg("threads"),
           nb::arg("progress").none());
  module.def("simulation_parameters",
             [] { return descriptions_of(SimulationParameters::declarations().infos()); });
  module.def("own_object_tables", &own_object_tables);
  module.def("selected", &selected, nb::arg("recording"), nb::arg("things"),
             nb::arg("explorations").none());
  module.def("sensed", &sensed, nb::arg("recording"), nb::arg("settings").none(),
             nb::arg("sensors"), nb::arg("seed").none(), nb::arg("threads"));
}

}  // namespace somato::python
