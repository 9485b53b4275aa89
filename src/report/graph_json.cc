#include "report/graph_json.h"

#include <algorithm>
#include <string>
#include <utility>

#include "report/rebuilt_study.h"
#include "somato/graph/module.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

const std::string kModule = "module.";

bool has_parameter(const ModuleType& type, const std::string& name) {
  return std::any_of(type.parameters.begin(), type.parameters.end(),
                     [&](const ParameterInfo& info) { return info.name == name; });
}

Json parameters_json(const ModuleType& type, const Settings* part) {
  Json json = Json::object();
  for (const Setting& setting : part ? part->settings : std::vector<Setting>{}) {
    if (has_parameter(type, setting.name)) json[setting.name] = setting.value;
  }
  return json;
}

Json names_not_given(const ModuleType& type) {
  Json json = Json::array();
  for (const ParameterInfo& info : type.parameters) {
    if (is_not_given(info)) json.push_back(info.name);
  }
  return json;
}

Json inputs_json(const System& system, const SystemModule& module) {
  Json json = Json::array();
  for (std::size_t i = 0; i < module.inputs.size(); ++i) {
    json.push_back(
        {{"port", module.ports[i]}, {"module", system.modules()[module.inputs[i]].name}});
  }
  return json;
}

// A single number has no axes.
Json shape_json(const PortType& type) {
  return type.size() == 1 ? Json::array() : Json(type.shape);
}

Json module_json(const System& system, const SystemModule& module, const Settings* settings) {
  Json json = {{"name", module.name},
               {"type", module.type->name},
               {"text", module.type->text},
               {"inputs", inputs_json(system, module)},
               {"shape", shape_json(module.output)},
               {"sparse", module.output.sparse},
               {"rate", module.output.rate == Rate::kFrame ? "frame" : "exploration"},
               {"learns", module.module->learner() != nullptr}};
  if (const auto* source = dynamic_cast<const Source*>(module.module.get())) {
    json["channel"] = source->channel();
  }
  json["parameters"] = parameters_json(*module.type, settings);
  json["not_given"] = names_not_given(*module.type);
  return json;
}

Json phase_json(const System& system, const Phase& phase) {
  Json learn = Json::array();
  for (const std::size_t module : phase.learners) learn.push_back(system.modules()[module].name);
  return {{"learn", std::move(learn)},
          {"draws", phase.draws ? Json(*phase.draws) : Json(nullptr)},
          {"of", choice_name(phase.of)}};
}

}  // namespace

bool is_not_given(const ParameterInfo& parameter) {
  return parameter.text.find("ot given in the paper") != std::string::npos;
}

Json graph_json(const System& system, std::size_t map, const std::vector<Settings>& settings) {
  Json modules = Json::array();
  for (const SystemModule& module : system.modules()) {
    modules.push_back(module_json(system, module, find_part(settings, kModule + module.name)));
  }
  Json phases = Json::array();
  for (const Phase& phase : system.phases()) phases.push_back(phase_json(system, phase));
  return {{"modules", std::move(modules)},
          {"map", system.modules()[map].name},
          {"phases", std::move(phases)}};
}

Json grid_json(const Grid& grid) {
  return {{"rows", grid.rows()},
          {"columns", grid.columns()},
          {"lattice", choice_name(grid.lattice())},
          {"topology", choice_name(grid.topology())}};
}

Json not_given_json(const std::vector<Settings>& settings) {
  Json json = Json::array();
  for (const Settings& part : settings) {
    const ModuleType* type = part.part.starts_with(kModule) ? type_of(part) : nullptr;
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
