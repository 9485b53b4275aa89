#include "views/curves/part_settings.h"

#include <algorithm>

#include "systems/graph/graph_json.h"

namespace somato::detail {

const Settings* find_part(const std::vector<Settings>& settings, const std::string& part) {
  const auto found = std::find_if(settings.begin(), settings.end(),
                                  [&](const Settings& one) { return one.part == part; });
  return found == settings.end() ? nullptr : &*found;
}

const ModuleType* type_of(const Settings& module) {
  for (const Setting& setting : module.settings) {
    if (setting.name != "type") continue;
    for (const ModuleType& type : module_types()) {
      if (to_toml(Value{type.name}) == setting.value) return &type;
    }
  }
  return nullptr;
}

nlohmann::ordered_json not_given_json(const std::vector<Settings>& parameters) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Settings& part : parameters) {
    const ModuleType* type = part.part.starts_with("module.") ? type_of(part) : nullptr;
    if (type == nullptr) continue;
    for (const Setting& setting : part.settings) {
      for (const ParameterInfo& info : type->parameters) {
        if (info.name != setting.name || !is_not_given(info)) continue;
        json.push_back({{"part", part.part},
                        {"name", info.name},
                        {"value", setting.value},
                        {"text", info.text}});
      }
    }
  }
  return json;
}

}  // namespace somato::detail
