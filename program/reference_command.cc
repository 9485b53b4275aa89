#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "commands.h"
#include "explore_table.h"
#include "man_page.h"
#include "parameter_table.h"
#include "somato/bodies/object_table.h"
#include "somato/maps/som_parameters.h"
#include "somato/recording/csv_import.h"
#include "somato/simulation/exploring_parameters.h"
#include "somato/studies/claim.h"
#include "somato/studies/information.h"
#include "somato/studies/reproduction_plan.h"
#include "somato/studies/study_parameters.h"
#include "somato/studies/sweep.h"
#include "usage.h"

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
  page += fmt::format("Every key of [{0}](#{0}) is a flag too, with dashes for underscores: ",
                      command.table);
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
      "([exploring](../exploring.md)). None of these numbers is in the papers, unless a line says "
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
      "## Things to explore\n\nThe tables of the file that `somato explore --objects` reads "
      "([objects](../objects.md)).\n\n";
  add_table<ObjectLine>(page, "`[object]`");
  add_table<Material>(page, "`[material.NAME]`");
}

void add_reproduction(std::string& page) {
  page +=
      "## What `somato reproduce` reads\n\nTables beside those of a study, and the question of a "
      "file about several systems ([reproduction](reproduction.md)). `[variation.NAME]` has the "
      "tables and keys that it changes, and `systems`, a list of those it is for. \"automatic\" is "
      "none "
      "here.\n\n";
  add_table<ExploreParameters>(page, "`[explore]`");
  add_table<Claim>(page, "`[[claim]]`");
  add_table<QuestionParameters>(page, "`[question]`");
}

void add_sweep(std::string& page) {
  page +=
      "## What `somato sweep` reads\n\nThe file of `--over` ([sweeps](sweeps.md)); its other "
      "tables "
      "change the system, as a variation does.\n\n";
  add_table<SweepParameters>(page, "`[sweep]`");
  add_table<UnknownParameters>(page, "`[unknown.NAME]`");
}

std::string reference_page(const std::vector<Command>& commands) {
  std::string page =
      "# Reference: flags and keys\n\n"
      "Made by `somato reference > docs/reference/flags-and-keys.md` from the declarations that "
      "the "
      "program itself reads; a test compares the two. [The tutorial](../tutorial.md) shows them at "
      "work, [results.md](results.md) defines what is measured.\n\n"
      "Exit codes: 0 done, 1 the data or the machine was at fault, 2 wrong usage, 3 done "
      "with losses, 130 or 143 interrupted.\n\n## Commands\n\n";
  for (const Command& command : commands) add_command(page, command);
  page +=
      "## Study files\n\nA study is a TOML file: the tables `[study]` and `[recording]`, and a "
      "system of the tables `[module.NAME]` and, where need be, `[[phase]]`. A key that is left "
      "out has its default; an unknown one is refused. Values stand here as TOML writes them; "
      "\"automatic\" is decided from the data, as the key says. [Types of modules](modules.md) "
      "have a page of their own.\n\n";
  add_table<StudyParameters>(page, "`[study]`");
  add_table<RecordingParameters>(page, "`[recording]`");
  add_table<PhaseDescription>(page, "`[[phase]]`");
  add_reproduction(page);
  add_sweep(page);
  add_exploring(page);
  page +=
      "## What vectors tell\n\nFlags of `somato information`; they stand in no file. "
      "[information.md](information.md) defines what is measured.\n\n";
  add_table<InformationParameters>(page, "information");
  page +=
      "## Maps\n\nKeys of a module of type `som`; those of other types stand with "
      "[them](modules.md).\n\n";
  add_table<SomParameters>(page, "map");
  page +=
      "## Descriptions of CSV files\n\nHow CSV files become a recording ([your "
      "data](../your-data.md)): a table `[import]`, and a table `[[channel]]` for each "
      "channel.\n\n";
  add_table<CsvTrials>(page, "`[import]`");
  add_table<CsvChannel>(page, "`[[channel]]`");
  page.pop_back();
  return page;
}

}  // namespace

Command reference_command(const std::vector<Command>& others) {
  Command command{"reference", "Print the reference of all flags and keys, in Markdown",
                  {},          {{"--man", "Print the manual page instead, for man", false, false}},
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
