#include "views/report/part_settings.h"

#include <algorithm>

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

}  // namespace somato::detail
