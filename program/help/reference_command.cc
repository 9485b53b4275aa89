#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "explore/explore_table.h"
#include "flags/commands.h"
#include "flags/man_page.h"
#include "flags/parameter_table.h"
#include "flags/usage.h"
#include "hardware/device_files/device_file.h"
#include "recordings/bags/bag_description.h"
#include "somato/bodies/object_table.h"
#include "somato/maps/clusters.h"
#include "somato/maps/refinement.h"
#include "somato/maps/som_measures.h"
#include "somato/maps/som_parameters.h"
#include "somato/recording/csv_import.h"
#include "somato/simulation/simulation_parameters.h"
#include "somato/studies/claim.h"
#include "somato/studies/information.h"
#include "somato/studies/reproduction.h"
#include "somato/studies/study_parameters.h"
#include "studies/inference/targets.h"
#include "studies/lifelong/touch_order.h"
#include "studies/suggestion/suggestion.h"
#include "studies/sweep/sweep.h"

namespace somato::program {
namespace {

void add_table(std::string& page, const std::string& title,
               const std::vector<ParameterInfo>& parameters) {
  page += fmt::format("### {}\n\n", title);
  page += parameter_table(parameters) + "\n";
}

template <typename Parameters>
void add_table(std::string& page, const std::string& title) {
  add_table(page, title, Parameters::declarations().infos());
}

// "-o,--output" as `-o`, `--output`.
std::string flag_cell(const Flag& flag) {
  std::string cell = "`";
  for (const char c : flag.name) cell += c == ',' ? std::string("`, `") : std::string(1, c);
  return cell + "`";
}

void add_arguments(std::string& page, const Command& command) {
  page += "| argument | meaning |\n|---|---|\n";
  for (const Positional& positional : command.positionals) {
    page += fmt::format("| `{}` | {}. |\n", positional.name, markdown_cell(positional.text));
  }
  for (const Flag& flag : command.flags) {
    page += fmt::format("| {} | {}{}. |\n", flag_cell(flag), markdown_cell(flag.text),
                        flag.required ? "; required" : "");
  }
  page += fmt::format("| `--quiet` | {}. |\n", kQuietText);
  page += "\n";
}

void add_command(std::string& page, const Command& command) {
  page += fmt::format("### `{}`\n\n{}.\n\n", usage_of(command), command.text);
  add_arguments(page, command);
  if (command.parameters.empty()) return;
  std::string tables;
  for (const std::string& table : command.tables) {
    tables += fmt::format("{0}[{1}](#{1})", tables.empty() ? "" : " and ", table);
  }
  page += fmt::format("Every key of {} is a flag too, with dashes for underscores: ", tables);
  const auto underscored = [](const ParameterInfo& info) {
    return info.name.find('_') != std::string::npos;
  };
  const auto& infos = command.parameters;
  const auto key = std::find_if(infos.begin(), infos.end(), underscored);
  const std::string& example = key == infos.end() ? infos.front().name : key->name;
  page += fmt::format("`{}` is `{}`.\n\n", example, flag_of(example));
}

void add_exploring(std::string& page) {
  page +=
      "## Settings of exploring\n\nTables of the file that `somato explore --settings` reads "
      "([exploring](../exploring.md)). None of these numbers is in the papers, unless a line "
      "states "
      "so.\n\n";
  add_table<SimulationParameters>(page, "`[simulation]`");
  add_table<ExplorationPlan>(page, "`[plan]`");
  add_table<GuardedGrasp>(page, "`[grasp]`");
  add_table<Closing>(page, "`[closing]`");
  add_table<TextureProbeParameters>(page, "`[texture_probe]`");
  add_table<StrokeParameters>(page, "`[stroke]`");
  add_table<HardnessProbeParameters>(page, "`[hardness_probe]`");
  add_table<PressParameters>(page, "`[press]`");
  page +=
      "## Objects to explore\n\nThe tables of the file that `somato explore --objects` reads "
      "([objects](../objects.md)).\n\n";
  add_table<ObjectLine>(page, "`[object]`");
  add_table<Material>(page, "`[material.NAME]`");
}

void add_reproduction(std::string& page) {
  page +=
      "## Files of `somato reproduce`\n\nTables in addition to those of a study, and the question "
      "of a file about several systems ([reproduction](reproduction.md)). `[variation.NAME]` has "
      "the tables and keys that it changes, and `systems`, the list of systems to which it "
      "applies. \"automatic\" means none here.\n\n";
  add_table<ExploreParameters>(page, "`[explore]`");
  add_table<Claim>(page, "`[[claim]]`");
  add_table<QuestionParameters>(page, "`[question]`");
}

void add_sweep(std::string& page) {
  page +=
      "## Files of `somato sweep`\n\nThe file of `--over` ([sweeps](sweeps.md)); its other "
      "tables "
      "change the system, as a variation does.\n\n";
  add_table<SweepParameters>(page, "`[sweep]`");
  add_table<UnknownParameters>(page, "`[unknown.NAME]`");
  page += "The file of `--targets` ([inference](inference.md)).\n\n";
  add_table<InferenceParameters>(page, "`[inference]`");
  add_table<Target>(page, "`[[target]]`");
}

void add_devices(std::string& page) {
  page +=
      "## Device files\n\nA hand or probe at serial lines ([your hand](../your-hand.md)). These "
      "keys stand before the tables:\n\n";
  add_table<devices::DeviceSettings>(page, "device");
  page += "The lines, the servos, the sensors and the safety:\n\n";
  add_table<devices::ServoLine>(page, "`[servos]`");
  add_table<devices::ServoSettings>(page, "`[servo.NAME]`");
  add_table<devices::FrameLine>(page, "`[frames]`");
  add_table<devices::SensorSettings>(page, "`[sensor.NAME]`");
  add_table<devices::MicrophoneSettings>(page, "`[microphone]`");
  add_table<devices::SafetySettings>(page, "`[safety]`");
}

std::string reference_page(const std::vector<Command>& commands) {
  std::string page =
      "# Reference: flags and keys\n\n"
      "Generated by `somato reference > docs/reference/flags-and-keys.md` from the declarations "
      "that the program itself reads; a test checks that it is up to date. "
      "[The tutorial](../tutorial.md) shows examples, [results.md](results.md) defines the "
      "metrics.\n\n"
      "Exit codes: 0 success, 1 data or system error, 2 usage error, 3 completed with losses, "
      "129, 130 or 143 interrupted.\n\n## Commands\n\n";
  for (const Command& command : commands) add_command(page, command);
  page +=
      "## Study files\n\nA study is a TOML file: the tables `[study]`, `[recording]` and, if "
      "needed, "
      "`[altered.NAME]`, and a system of the tables `[module.NAME]` and, if needed, `[[phase]]`. A "
      "key that is left "
      "out has its default; an unknown key is refused. Values are written in TOML notation; "
      "\"automatic\" is derived from the data as described for the key. A separate page lists "
      "the [types of modules](modules.md).\n\n";
  add_table<StudyParameters>(page, "`[study]`");
  add_table<RecordingParameters>(page, "`[recording]`");
  add_table<Alteration>(page, "`[altered.NAME]`");
  add_table<PhaseDescription>(page, "`[[phase]]`");
  add_reproduction(page);
  add_sweep(page);
  add_exploring(page);
  add_devices(page);
  page +=
      "## Information in the input vectors\n\nFlags of `somato information`; they are not keys of "
      "a file. [information.md](information.md) defines the measures.\n\n";
  add_table<InformationParameters>(page, "information");
  page +=
      "## Suggestions\n\nFlags of `somato suggest`; they are not keys of a file. "
      "[suggest.md](../mathematics/suggest.md) describes the search; none of these numbers is in "
      "the papers.\n\n";
  add_table<SuggestionParameters>(page, "suggestion");
  page +=
      "## Orders of grasps\n\nFlags of `somato touch-order`; they are not keys of a file. "
      "[continual.md](../continual.md#the-next-grasp) describes the comparison; none of these "
      "numbers is in the papers.\n\n";
  add_table<TouchOrderParameters>(page, "touch_order");
  page +=
      "## Maps\n\nKeys of a module of type `som`; those of other types are listed with "
      "[them](modules.md).\n\n";
  add_table<SomParameters>(page, "map");
  page +=
      "## Refinement of maps by labels\n\nFurther keys of a module of type `som`, and flags of "
      "`somato som train`. [refinement.md](../mathematics/refinement.md) gives the equations.\n\n";
  add_table<RefinementParameters>(page, "refinement");
  page +=
      "## Measures and clusters of maps\n\nFlags of `somato som quality` and `somato som cluster`; "
      "they are not keys of a file. [measures.md](../mathematics/measures.md) gives the "
      "definitions; none of these numbers is in the papers.\n\n";
  add_table<MeasureParameters>(page, "measures");
  add_table<ClusterParameters>(page, "clusters");
  page +=
      "## Descriptions of CSV files\n\nThe import of CSV files as a recording ([your "
      "data](../your-data.md)): a table `[import]`, and a table `[[channel]]` for each "
      "channel.\n\n";
  add_table<CsvTrials>(page, "`[import]`");
  add_table<CsvChannel>(page, "`[[channel]]`");
  page +=
      "## Descriptions of bags\n\nThe import of bags of ROS 2 as a recording ([your "
      "robot](../your-robot.md)): a table `[import]`, a table `[[channel]]` for each channel and a "
      "table `[[label]]` for each label.\n\n";
  add_table<BagTrials>(page, "`[import]` of bags");
  add_table<BagChannel>(page, "`[[channel]]` of bags");
  add_table<BagLabel>(page, "`[[label]]` of bags");
  page.pop_back();
  return page;
}

}  // namespace

Command reference_command(const std::vector<Command>& others) {
  Command command{"reference", "Print the reference of all flags and keys, in Markdown",
                  {},          {{"--man", "Print the manual page for man instead", false, false}},
                  {},          {}};
  std::vector<Command> all = others;
  all.push_back(command);
  command.run = [all](const Arguments& arguments) -> Result<void> {
    const std::string page = arguments.has("man") ? man_page(all) : reference_page(all);
    std::fwrite(page.data(), 1, page.size(), stdout);
    return {};
  };
  return command;
}

}  // namespace somato::program
