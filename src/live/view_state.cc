#include "live/view_state.h"

#include <utility>

namespace somato::live {
namespace {

template <typename T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

Json explorations_json(const Recording& recording) {
  Json explorations = Json::array();
  for (const Exploration& one : recording.explorations) {
    const std::size_t index = explorations.size();
    explorations.push_back({{"index", index}, {"labels", labels_json(one.labels)}});
  }
  return explorations;
}

Json channels_json(const Exploration* exploration) {
  Json channels = Json::array();
  if (exploration == nullptr) return channels;
  for (const Channel& channel : exploration->channels) channels.push_back(channel_json(channel));
  return channels;
}

// Of a recording there is nothing to choose.
void add_things(const ViewState& state, Json& json) {
  json["things"] = Json::array();
  json["thing"] = nullptr;
  json["placement"] = nullptr;
  if (!state.source.body) return;
  const auto& things = state.source.body->things();
  for (const ShownThing& thing : things) json["things"].push_back(thing_json(thing));
  json["thing"] = things[state.thing].name;
  if (!state.source.body->takes_placement()) return;
  const Placement& placement = state.placement;
  json["placement"] = {{"x", placement.x}, {"y", placement.y}, {"turn", placement.turn}};
}

void add_systems(const ViewState& state, Json& json) {
  const auto& systems = state.source.systems;
  json["systems"] = Json::array();
  for (const ViewSystem& one : systems) {
    const bool learns = !one.description.modules.empty();
    json["systems"].push_back({{"name", one.name}, {"text", one.text}, {"learns", learns}});
  }
  json["system"] = state.system ? Json(systems[*state.system].name) : Json();
  json["system_problem"] = or_null(state.system_problem);
  json["graph"] = state.picture.graph;
  json["maps"] = state.picture.maps;
  json["label"] = or_null(state.picture.label);
}

}  // namespace

Json state_json(const ViewState& state) {
  Json json{{"version", 1},
            {"source", state.source.body ? "body" : "recording"},
            {"name", state.source.name},
            {"explorations", explorations_json(state.source.recording)},
            {"exploration", or_null(state.exploration)},
            {"frame", state.frame},
            {"frames", or_null(state.frames)},
            {"duration", or_null(state.duration)},
            {"playing", state.playing},
            {"speed", state.speed},
            {"live", state.live},
            {"channels", channels_json(state.shown)}};
  add_things(state, json);
  add_systems(state, json);
  json["training"] = state.training;
  json["clients"] = state.clients;
  json["problem"] = or_null(state.problem);
  return json;
}

}  // namespace somato::live
