#include "views/report/not_given.h"

#include <string>

#include "systems/graph/graph_json.h"
#include "views/report/part_settings.h"

namespace somato::detail {

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
