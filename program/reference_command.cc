#include <fmt/format.h>

#include <cstdio>
#include <iterator>

#include "commands.h"
#include "somato/codes/one_hot.h"
#include "somato/codes/standardization.h"
#include "somato/maps/t_mpsom_parameters.h"
#include "somato/studies/study_parameters.h"

namespace somato::program {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

// A bound that only keeps a number within its type tells a reader nothing.
Range range_worth_showing(Range range) {
  constexpr double kAsGoodAsNone = 1e12;
  return range.high < kAsGoodAsNone ? range
                                    : Range{range.low, Range::any().high, range.low_excluded};
}

std::string values_of(const ParameterInfo& info) {
  std::string values = info.choices.empty()
                           ? info.type
                           : fmt::format("{}{}", info.type.starts_with("list") ? "list of " : "",
                                         fmt::join(info.choices, ", "));
  const std::string range = to_string(range_worth_showing(info.range));
  if (!range.empty()) values += ", " + range;
  if (!info.unit.empty()) values += fmt::format(" [{}]", info.unit);
  return values;
}

template <typename Parameters>
void add_table(std::string& page, const std::string& title) {
  page += fmt::format("### {}\n\n| key | values | default | meaning |\n|---|---|---|---|\n", title);
  for (const ParameterInfo& info : parameter_flags<Parameters>()) {
    fmt::format_to(std::back_inserter(page), "| `{}` | {} | `{}` | {} |\n", info.name,
                   escaped(values_of(info)), info.default_text, escaped(info.text));
  }
  page += "\n";
}

// "-o,--output" as `-o`, `--output`.
std::string flag_cell(const Flag& flag) {
  std::string cell = "`";
  for (const char c : flag.name) cell += c == ',' ? std::string("`, `") : std::string(1, c);
  return cell + "`";
}

std::string usage_of(const Command& command) {
  std::string usage = "somato " + command.name;
  for (const Positional& positional : command.positionals) {
    usage += positional.required ? " " + positional.name : " [" + positional.name + "]";
  }
  for (const Flag& flag : command.flags) {
    if (flag.required) usage += fmt::format(" {} ...", flag.name.substr(0, flag.name.find(',')));
  }
  return usage + (command.flags.size() + command.parameters.size() > 0 ? " [FLAGS]" : "");
}

void add_arguments(std::string& page, const Command& command) {
  if (command.positionals.size() + command.flags.size() == 0) return;
  page += "| argument | meaning |\n|---|---|\n";
  for (const Positional& positional : command.positionals) {
    page += fmt::format("| `{}` | {}. |\n", positional.name, escaped(positional.text));
  }
  for (const Flag& flag : command.flags) {
    page += fmt::format("| {} | {}{}. |\n", flag_cell(flag), escaped(flag.text),
                        flag.required ? "; required" : "");
  }
  page += "\n";
}

void add_command(std::string& page, const Command& command) {
  page += fmt::format("### `{}`\n\n{}.\n\n", usage_of(command), command.text);
  add_arguments(page, command);
  if (command.parameters.empty()) return;
  const std::string& key = command.parameters.back().name;
  page += fmt::format(
      "Every key of [`[map]`](#map) is a flag too, with dashes for underscores: `{}` is `{}`, "
      "`radius_start` is `{}`.\n\n",
      key, flag_of(key), flag_of("radius_start"));
}

std::string reference_page(const std::vector<Command>& commands) {
  std::string page =
      "# Reference: flags and keys\n\n"
      "Made by `somato reference > docs/reference/flags-and-keys.md` from the declarations that "
      "the "
      "program itself reads; a test compares the two. [The tutorial](../tutorial.md) shows them at "
      "work, [results.md](results.md) defines what is measured.\n\n"
      "Exit codes: 0 done, 1 the data or the machine was at fault, 2 wrong usage, 3 done "
      "with losses, 130 interrupted.\n\n## Commands\n\n";
  for (const Command& command : commands) add_command(page, command);
  page +=
      "## Study files\n\nA study is a TOML file of the tables `[study]`, `[recording]`, `[vector]` "
      "and `[map]`. A key that is left out has its default; an unknown one is refused. Values "
      "stand here as TOML writes them; \"automatic\" is decided from the data, as the key says, "
      "and "
      "`results.json` tells how.\n\n";
  add_table<StudyParameters>(page, "`[study]`");
  add_table<RecordingParameters>(page, "`[recording]`");
  add_table<VectorParameters>(page, "`[vector]`");
  add_table<SomParameters>(page, "`[map]`");
  page +=
      "## In the library alone\n\nParameters of what C++ programs can use, but no command or study "
      "file yet.\n\n";
  add_table<TMpsomParameters>(page, "`TMpsomParameters` ([T-MPSOM](../mathematics/t-mpsom.md))");
  add_table<OneHotParameters>(page, "`OneHotParameters` ([codes](../mathematics/codes.md))");
  add_table<StandardizationParameters>(
      page, "`StandardizationParameters` ([codes](../mathematics/codes.md))");
  return page;
}

}  // namespace

Command reference_command(const std::vector<Command>& others) {
  Command command{"reference", "Print the reference of all flags and keys, in Markdown", {}, {}, {},
                  {}};
  std::vector<Command> all = others;
  all.push_back(command);
  command.run = [all](const Arguments& /*arguments*/) -> Result<void> {
    const std::string page = reference_page(all);
    std::fwrite(page.data(), 1, page.size() - 1, stdout);
    return {};
  };
  return command;
}

}  // namespace somato::program
