#include "systems/exchange/system_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/text/flag_hint.h"
#include "systems/model/element_names.h"

namespace somato {
namespace {

std::vector<std::string> maps_of(const System& system) {
  std::vector<std::string> names;
  for (std::size_t module = 0; module < system.modules().size(); ++module) {
    if (som_of(system, module) != nullptr) names.push_back(system.modules()[module].name);
  }
  return names;
}

Result<std::string> chosen_of(const std::vector<std::string>& maps, const std::string& module,
                              const std::string& where) {
  if (maps.empty()) {
    return fail(ErrorKind::kUsage, "no module of the system is a map", where,
                "use the model of a system with a map");
  }
  if (module.empty() && maps.size() == 1) return maps.front();
  if (module.empty()) {
    return fail(ErrorKind::kUsage,
                fmt::format("the system has several maps: {}", fmt::join(maps, ", ")), where,
                "select one of these modules" + flag_hint("module"));
  }
  if (std::find(maps.begin(), maps.end(), module) != maps.end()) return module;
  return fail(unknown_name("map", module, where, maps));
}

std::vector<std::string> input_names(const System& system, std::size_t module) {
  std::vector<std::string> names;
  for (const std::size_t input : system.modules()[module].inputs) {
    const std::vector<std::string> of_input = element_names(system, input);
    names.insert(names.end(), of_input.begin(), of_input.end());
  }
  return names;
}

}  // namespace

Result<SomModel> map_of_system(const SystemModel& model, const std::string& module,
                               const std::string& where) {
  SOMATO_TRY(const auto name, chosen_of(maps_of(model.system), module, where));
  SOMATO_TRY(const auto number, model.system.find(name, where));
  SomModel map{*som_of(model.system, number), input_names(model.system, number), {}, {}, {}, {}};
  if (map.features.size() != map.som.input_size()) map.features.clear();
  if (model.answer && model.answer->map == name) {
    map.classes = model.answer->classes;
    map.labels = model.answer->labels;
  }
  return map;
}

}  // namespace somato
