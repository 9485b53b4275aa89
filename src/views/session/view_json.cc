#include "views/session/view_json.h"

#include <fmt/format.h>

#include <algorithm>

#include "bodies/objects/material_colour.h"
#include "recordings/explorations/growing_channel.h"
#include "systems/graph/graph_json.h"
#include "views/session/json_writer.h"

namespace somato::live {
namespace {

bool is_port(const ModuleType& type, const std::string& name) {
  return std::any_of(type.ports.begin(), type.ports.end(),
                     [&](const InputPort& port) { return port.name == name; });
}

// As the description gives them, or else their defaults.
Json parameters_json(const ModuleType& type, const Table& settings) {
  Json parameters = Json::object();
  for (const ParameterInfo& info : type.parameters) parameters[info.name] = info.default_text;
  for (const Table::Entry& entry : settings.entries) {
    const Value* value = std::get_if<Value>(&entry.content);
    if (value == nullptr || entry.name == "type" || is_port(type, entry.name)) continue;
    parameters[entry.name] = to_toml(*value);
  }
  return parameters;
}

Json geom_json(const SceneGeom& geom) {
  Json json{{"body", geom.body ? static_cast<int>(*geom.body) : -1},
            {"name", geom.name},
            {"type", choice_name(geom.shape)},
            {"size", geom.size},
            {"position", geom.pose.position},
            {"quaternion", geom.pose.turn},
            {"colour", geom.colour},
            {"role", choice_name(geom.role)},
            {"taxel", geom.taxel ? Json(*geom.taxel) : Json()}};
  if (geom.shape != GeomShape::kMesh) return json;
  json["vertices"] = geom.vertices;
  json["faces"] = geom.faces;
  return json;
}

void add_poses(JsonWriter& text, const std::vector<ScenePose>& poses) {
  text.key("poses").open('[');
  for (const ScenePose& pose : poses) {
    for (const double value : pose.position) {
      text.separate();
      text.finite("{:.6g}", value);
    }
    for (const double value : pose.turn) {
      text.separate();
      text.finite("{:.6g}", value);
    }
  }
  text.close(']');
}

void add_modules(JsonWriter& text, const SystemModel* model, const Reading* reading) {
  text.key("modules").open('{');
  if (reading != nullptr) {
    for (const auto& [module, output] : reading->modules) {
      text.key(model->system.modules()[module].name).open('{');
      text.key("shape").add("[{}]", fmt::join(output.shape, ","));
      text.key("values").numbers(output.values);
      text.key("folded").add("{}", output.folded);
      text.close('}');
    }
  }
  text.close('}');
}

void add_maps(JsonWriter& text, const SystemModel* model, const Reading* reading) {
  text.key("maps").open('{');
  if (reading != nullptr) {
    for (const auto& [module, map] : reading->maps) {
      text.key(model->system.modules()[module].name).open('{');
      text.key("winner").add("{}", map.winner);
      text.key("activity").numbers(map.activity);
      text.close('}');
    }
  }
  text.close('}');
}

void add_contributions(JsonWriter& text, const std::vector<std::string>& classes,
                       const std::optional<ReadingContributions>& contributions) {
  text.key("contributions");
  if (!contributions) {
    text.add("null");
    return;
  }
  text.open('{');
  text.key("other").add("{}", json_text(Json(classes[contributions->other])));
  text.key("unit").add("{}", json_text(Json(contributions->unit)));
  text.key("channels").open('{');
  for (const ChannelContributions& one : contributions->channels) {
    text.key(one.channel).numbers(one.values);
  }
  text.close('}').close('}');
}

void add_reading(JsonWriter& text, const SystemModel* model, const Reading* reading) {
  text.key("reading");
  if (reading == nullptr || reading->candidates.empty()) {
    text.add("null");
    return;
  }
  const std::vector<std::string>& classes = model->answer->classes;
  const auto name = [&](const NearestOfClass& one) { return json_text(Json(classes[one.number])); };
  text.open('{');
  text.key("answer").add("{}", json_text(Json(reading->name(classes))));
  text.key("confidence").finite("{:.6g}", reading->confidence());
  text.key("novelty");
  if (reading->novelty) {
    text.finite("{:.6g}", *reading->novelty);
  } else {
    text.add("null");
  }
  text.key("candidates").open('[');
  for (const NearestOfClass& one : reading->candidates) {
    text.separate();
    text.add(R"({{"name":{},"distance":)", name(one)).finite("{:.6g}", one.distance).add("}}");
  }
  text.close(']');
  add_contributions(text, classes, reading->contributions);
  text.close('}');
}

}  // namespace

std::string json_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool comes_in_stretches(const Channel& channel, double rate) {
  constexpr double kFast = 60.0;  // frames a second
  return channel.frames.columns() == 1 && rate > kFast;
}

std::vector<float> shown_values(const Channel& channel, double rate, std::size_t come) {
  constexpr std::size_t kStretch = 512;
  if (come == 0) return {};
  const std::size_t shown = comes_in_stretches(channel, rate) ? std::min(come, kStretch) : 1;
  const Matrix<float> latest = readings_of(channel, come - shown, shown);
  return {latest.values().begin(), latest.values().end()};
}

Json thing_json(const ExploredThing& thing) {
  const bool is_known = !thing.material.name.empty();
  const auto colour = material_colour(thing.material.name);
  Json json{{"name", thing.name},
            {"shape", nullptr},
            {"size", nullptr},
            {"top_diameter", 0.0},
            {"material", thing.material.name},
            {"hardness", is_known ? choice_name(thing.material.hardness) : std::string()},
            {"colour", colour ? Json(*colour) : Json()},
            {"mass", nullptr}};
  if (!thing.object) return json;
  json["shape"] = choice_name(thing.object->shape);
  json["size"] = thing.object->size;
  json["top_diameter"] = thing.object->top_diameter;
  if (thing.object->mass > 0.0) json["mass"] = thing.object->mass;
  return json;
}

Json graph_json(const System& system, const std::string& map) {
  const auto parameters = [&](std::size_t i) {
    return parameters_json(*system.modules()[i].type, system.description().modules[i].settings);
  };
  return detail::graph_json(system, map, parameters);
}

Json maps_json(const System& system, const std::optional<SystemAnswer>& answer) {
  Json maps = Json::array();
  for (std::size_t i = 0; i < system.modules().size(); ++i) {
    if (som_of(system, i) == nullptr) continue;
    const Grid grid = grid_of(system, i);
    const std::string& name = system.modules()[i].name;
    const bool answers = answer && answer->map == name;
    Json neurons = Json::array();
    for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
      const auto label = answers ? answer->labels[neuron] : std::nullopt;
      neurons.push_back(label ? Json(*label) : Json());
    }
    maps.push_back({{"module", name},
                    {"grid", detail::grid_json(grid)},
                    {"classes", answers ? Json(answer->classes) : Json::array()},
                    {"neuron_classes", std::move(neurons)}});
  }
  return maps;
}

Json scene_json(const Scene& scene) {
  Json geoms = Json::array();
  for (const SceneGeom& geom : scene.geoms) geoms.push_back(geom_json(geom));
  return {{"bodies", scene.bodies},
          {"geoms", std::move(geoms)},
          {"camera", {{"position", scene.camera}, {"target", scene.target}}}};
}

std::string frame_text(const ShownMoment& moment, const SystemModel* model,
                       const Reading* reading) {
  JsonWriter text;
  text.open('{');
  text.key("exploration").add("{}", moment.exploration);
  text.key("frame").add("{}", moment.frame);
  text.key("frames").add("{}", moment.frames ? std::to_string(*moment.frames) : "null");
  text.key("time").add("{:.6g}", moment.time);
  text.key("last").add("{}", moment.last);
  text.key("channels").open('{');
  for (const auto& [name, values] : moment.channels) text.key(name).exact_numbers(values);
  text.close('}');
  add_poses(text, moment.poses);
  add_modules(text, model, reading);
  add_maps(text, model, reading);
  add_reading(text, model, reading);
  text.close('}');
  return std::move(text).take();
}

}  // namespace somato::live
