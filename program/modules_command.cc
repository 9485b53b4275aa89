#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "commands.h"
#include "parameter_table.h"
#include "result_output.h"
#include "somato/graph/module.h"

namespace somato::program {
namespace {

std::vector<std::string> type_names() {
  std::vector<std::string> names;
  names.reserve(module_types().size());
  for (const ModuleType& type : module_types()) names.push_back(type.name);
  return names;
}

std::string port_text(const InputPort& port) {
  return std::string(port.many ? "a list of modules; " : "") + port.text +
         (port.required ? "" : " Optional.");
}

std::string text_of(const ModuleType& type) {
  std::string text =
      fmt::format("{}{}\n  {}\n", type.name, type.learns ? " (learns)" : "", type.text);
  for (const InputPort& port : type.ports) {
    text += fmt::format("  <- {}: {}\n", port.name, port_text(port));
  }
  text += fmt::format("  -> {}\n", type.output);
  for (const ParameterInfo& info : type.parameters) {
    text += fmt::format("  {} = {}  {}. {}\n", info.name, info.default_text, values_of(info),
                        info.text);
  }
  return text;
}

Table table_of(const ModuleType& type) {
  const auto of_port = [](const InputPort& port) {
    return Table{{},
                 {entry("port", port.name), entry("many", port.many),
                  entry("required", port.required), entry("text", port.text)}};
  };
  const auto of_parameter = [](const ParameterInfo& info) {
    return Table{{},
                 {entry("parameter", info.name), entry("values", values_of(info)),
                  entry("default", info.default_text), entry("text", info.text)}};
  };
  return {{},
          {entry("type", type.name), entry("text", type.text), entry("learns", type.learns),
           entry("ports", type.ports, of_port), entry("output", type.output),
           entry("parameters", type.parameters, of_parameter)}};
}

std::string markdown(const ModuleType& type) {
  std::string page =
      fmt::format("## `{}`\n\n{}{}\n\n", type.name, type.text, type.learns ? " It learns." : "");
  page += "| port | what goes through |\n|---|---|\n";
  for (const InputPort& port : type.ports) {
    fmt::format_to(std::back_inserter(page), "| in: `{}` | {} |\n", port.name,
                   markdown_cell(port_text(port)));
  }
  page += fmt::format("| out | {} |\n\n", markdown_cell(type.output));
  if (!type.parameters.empty()) page += parameter_table(type.parameters) + "\n";
  return page;
}

std::string markdown_page() {
  std::string page =
      "# Reference: types of modules\n\nMade by `somato modules --markdown` from what the program "
      "itself knows; a test compares the two. A module is a table `[module.NAME]` of a study file "
      "with its `type`, the names of the modules it listens to as keys named after its ports, and "
      "its parameters. [Your own system](../your-system.md) shows how they are put together.\n\n";
  for (const ModuleType& type : module_types()) page += markdown(type);
  page.pop_back();
  return page;
}

// Errors: kUsage for flags that ask for different things.
Result<void> check_flags(const Arguments& arguments) {
  if (!arguments.has("markdown")) return {};
  for (const auto& [name, advice] :
       {std::pair("TYPE", "leave TYPE out"), std::pair("json", "leave --json out")}) {
    if (!arguments.has(name)) continue;
    return fail(ErrorKind::kUsage, "the page holds all types, as Markdown", "--markdown", advice);
  }
  return {};
}

Result<void> list_modules(const Arguments& arguments) {
  if (auto usable = check_flags(arguments); !usable) return usable;
  if (arguments.has("markdown")) {
    fmt::print("{}", markdown_page());
    return {};
  }
  if (arguments.has("TYPE")) {
    const auto type = find_module_type(arguments.text("TYPE"), "modules");
    if (!type) return fail(type.error());
    print_result(arguments, text_of(**type), table_of(**type));
    return {};
  }
  std::string text;
  for (const ModuleType& type : module_types()) text += text_of(type) + "\n";
  const auto of_type = [](const ModuleType& type) { return table_of(type); };
  print_result(arguments, text, Table{{}, {entry("modules", module_types(), of_type)}});
  return {};
}

}  // namespace

Command modules_command() {
  return {"modules",
          "List the types of modules that systems are made of, with ports and parameters",
          {{"TYPE", "One type only", false, false, Role::kValue, type_names}},
          {{"--markdown", "As a page of the documentation", false, false}, json_flag()},
          {},
          list_modules};
}

}  // namespace somato::program
