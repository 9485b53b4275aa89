#include "flags/usage.h"

#include <fmt/format.h>

namespace somato::program {

std::string usage_of(const Command& command) {
  std::string usage = "somato " + command.name;
  for (const Positional& positional : command.positionals) {
    const std::string name = positional.name + (positional.many ? "..." : "");
    usage += positional.required ? " " + name : " [" + name + "]";
  }
  for (const Flag& flag : command.flags) {
    if (flag.required) usage += fmt::format(" {} ...", flag.name.substr(0, flag.name.find(',')));
  }
  return usage + (command.flags.size() + command.parameters.size() > 0 ? " [FLAGS]" : "");
}

std::string parameter_description(const ParameterInfo& info) {
  std::string text = info.text;
  if (!info.unit.empty()) text += fmt::format(" [{}]", info.unit);
  const std::string range = to_string(info.range);
  if (!range.empty()) text += fmt::format(" ({})", range);
  if (!info.choices.empty()) text += fmt::format(" ({})", fmt::join(info.choices, ", "));
  return text + fmt::format(" Default: {}.", info.default_text);
}

}  // namespace somato::program
