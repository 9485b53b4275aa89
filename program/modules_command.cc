#include <fmt/format.h>

#include <cstdio>
#include <iterator>

#include "commands.h"
#include "parameter_table.h"
#include "somato/graph/module.h"

namespace somato::program {
namespace {

std::string port_text(const InputPort& port) {
  return std::string(port.many ? "a list of modules; " : "") + port.text +
         (port.required ? "" : " Optional.");
}

void print_type(const ModuleType& type) {
  fmt::print("{}{}\n  {}\n", type.name, type.learns ? " (learns)" : "", type.text);
  for (const InputPort& port : type.ports) fmt::print("  <- {}: {}\n", port.name, port_text(port));
  fmt::print("  -> {}\n", type.output);
  for (const ParameterInfo& info : type.parameters) {
    fmt::print("  {} = {}  {}. {}\n", info.name, info.default_text, values_of(info), info.text);
  }
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

Result<void> list_modules(const Arguments& arguments) {
  if (arguments.has("markdown") && arguments.has("TYPE")) {
    return fail(ErrorKind::kUsage, "the page holds all types", "--markdown", "leave TYPE out");
  }
  if (arguments.has("markdown")) {
    fmt::print("{}", markdown_page());
    return {};
  }
  if (arguments.has("TYPE")) {
    const auto type = find_module_type(arguments.text("TYPE"), "modules");
    if (!type) return fail(type.error());
    print_type(**type);
    return {};
  }
  for (const ModuleType& type : module_types()) {
    print_type(type);
    fmt::print("\n");
  }
  return {};
}

}  // namespace

Command modules_command() {
  return {"modules",
          "List the types of modules that systems are made of, with ports and parameters",
          {{"TYPE", "One type only", false, false, Role::kValue}},
          {{"--markdown", "As a page of the documentation", false, false}},
          {},
          list_modules};
}

}  // namespace somato::program
