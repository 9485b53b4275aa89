#pragma once

#include <string>

#include "somato/core/parameter.h"
#include "somato/core/value.h"

namespace somato {

/// The table [NAME] in TOML with the parameters that differ from their defaults, and a blank line.
template <typename Parameters>
std::string changed_keys_to_toml(const std::string& name, const Parameters& parameters) {
  std::string text = "[" + name + "]\n";
  for (const auto& parameter : Parameters::declarations().all()) {
    const std::string value = to_toml(parameter.read(parameters));
    if (value != parameter.info.default_text) text += parameter.info.name + " = " + value + "\n";
  }
  return text + "\n";
}

}  // namespace somato
