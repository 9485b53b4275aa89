#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

#include "base/files/toml_file.h"
#include "base/text/text.h"
#include "bodies/objects/selected_things.h"
#include "bodies/sensors/sensor_parameters.h"
#include "flags/commands.h"
#include "flags/output.h"
#include "recordings/study_data.h"
#include "som/data.h"
#include "somato/recording/recording_file.h"
#include "somato/simulation/sense.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

Result<ExploringParameters> read_sensors(const Arguments& arguments, const Exploration& first) {
  ExploringParameters parameters;
  if (arguments.has("settings")) {
    SOMATO_TRY(const Table file, read_toml(arguments.text("settings")));
    SOMATO_TRY(parameters, read_exploring_parameters(file));
  }
  const Table given = given_parameters(arguments, sensor_parameters());
  SOMATO_TRY_VOID(check_sensor_effect(given, first));
  return read_sensor_parameters(given, std::move(parameters));
}

// Without the settings of the exploration, parameters that are not given are reset to defaults.
Result<std::string> note_of_defaults(const Arguments& arguments, const Exploration& first) {
  if (arguments.has("settings")) return std::string();
  return note_of_other_sensors(first);
}

void print_sensor_note(const std::string& path, const std::string& note) {
  if (is_quiet() || note.empty()) return;
  fmt::print(stderr, "somato: {}: {}\n", printable(path), note);
}

Result<Recording> read_selected(const Arguments& arguments, const std::string& path) {
  ThingSelection selection;
  if (arguments.has("objects")) selection.things = split(arguments.text("objects"), ',');
  SOMATO_TRY(selection.each, arguments.number("explorations", 1));
  return read_study_data({}, path).and_then(
      [&](Recording recording) { return select_things(std::move(recording), selection); });
}

Result<void> run_sense(const Arguments& arguments) {
  const std::string from = arguments.text("RECORDING");
  const std::string to = arguments.text("output");
  SOMATO_TRY_VOID(check_output(to));
  SOMATO_TRY(const auto seed, arguments.number("seed", 0));
  SOMATO_TRY(const auto threads, read_threads(arguments));
  SOMATO_TRY(const Recording explored, read_selected(arguments, from));
  SOMATO_TRY(const auto parameters, read_sensors(arguments, explored.explorations.front()));
  auto sensed = sense(explored, parameters, seed, threads);
  if (!sensed) return fail(with_place(std::move(sensed.error()), from));
  SOMATO_TRY(const std::string note, note_of_defaults(arguments, explored.explorations.front()));
  SOMATO_TRY_VOID(write_recording(to, *sensed));
  print_summary(fmt::format("{}: {}\n", to, counted(sensed->explorations.size(), "exploration")));
  print_sensor_note(from, note);
  return {};
}

// As flags of this command only: they are keys of several tables.
void add_sensor_flags(Command& command) {
  for (const ParameterInfo& info : sensor_parameters()) {
    const std::string unit = info.unit.empty() ? std::string() : fmt::format(" ({})", info.unit);
    std::string text = info.text.substr(0, info.text.rfind('.')) + unit;
    command.flags.push_back({flag_of(info.name), std::move(text)});
  }
}

}  // namespace

Command sense_command() {
  Command command{
      "sense",
      "Play the sensors of a simulated body: give the explorations of a recording with true values "
      "the readings of other sensors",
      {{"RECORDING", "Recording of 'explore' with --true-values true", true}},
      {input_flag("--settings",
                  "TOML file with tables of parameters, as of 'explore'; those of the sensors "
                  "count, without true_values. Default: the default sensors"),
       {"--seed",
        "Seed of the noise and of the differences between sensors. Default: that of the recording"},
       {"--objects",
        "Objects or materials of the recording, such as a,b,c, in this order. Default: all"},
       {"--explorations", "Number of explorations of each of them, the first ones. Default: all"},
       threads_flag(),
       output_flag("-o,--output", "File for the recording", true)},
      {},
      run_sense};
  add_sensor_flags(command);
  return command;
}

}  // namespace somato::program
