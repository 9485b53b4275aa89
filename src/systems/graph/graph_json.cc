#include "systems/graph/graph_json.h"

#include <utility>

#include "somato/graph/module.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

Json names_not_given(const ModuleType& type) {
  Json names = Json::array();
  for (const ParameterInfo& info : type.parameters) {
    if (is_not_given(info)) names.push_back(info.name);
  }
  return names;
}

Json inputs_json(const System& system, const SystemModule& module) {
  Json inputs = Json::array();
  for (std::size_t i = 0; i < module.inputs.size(); ++i) {
    inputs.push_back(
        {{"port", module.ports[i]}, {"module", system.modules()[module.inputs[i]].name}});
  }
  return inputs;
}

// A single number has no axes.
Json shape_json(const PortType& type) {
  return type.size() == 1 ? Json::array() : Json(type.shape);
}

Json module_json(const System& system, const SystemModule& module, Json parameters) {
  Json json{{"name", module.name},
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
  json["parameters"] = std::move(parameters);
  json["not_given"] = names_not_given(*module.type);
  return json;
}

Json phase_json(const System& system, const Phase& phase) {
  Json learn = Json::array();
  for (const std::size_t module : phase.learners) learn.push_back(system.modules()[module].name);
  return {{"learn", std::move(learn)},
          {"draws", phase.draws ? Json(*phase.draws) : Json()},
          {"of", choice_name(phase.of)}};
}

}  // namespace

bool is_not_given(const ParameterInfo& parameter) {
  return parameter.text.find("ot given in the paper") != std::string::npos;
}

Json graph_json(const System& system, const std::string& map,
                const std::function<Json(std::size_t)>& parameters) {
  Json modules = Json::array();
  for (std::size_t i = 0; i < system.modules().size(); ++i) {
    modules.push_back(module_json(system, system.modules()[i], parameters(i)));
  }
  Json phases = Json::array();
  for (const Phase& phase : system.phases()) phases.push_back(phase_json(system, phase));
  return {{"modules", std::move(modules)}, {"map", map}, {"phases", std::move(phases)}};
}

Json grid_json(const Grid& grid) {
  Json json = {{"rows", grid.rows()},
               {"columns", grid.columns()},
               {"lattice", choice_name(grid.lattice())},
               {"topology", choice_name(grid.topology())}};
  if (const NeuronGraph* graph = grid.graph()) {
    json["edges"] = graph->edges();
    json["cells"] = Json::array();
    for (const NeuronGraph::Cell& cell : graph->cells()) {
      json["cells"].push_back({cell.row, cell.column});
    }
  }
  return json;
}

}  // namespace somato::detail
