#include "views/live/view_state.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "recordings/explorations/recording_json.h"
#include "views/skins/channel_places.h"

namespace somato::live {
namespace {

Json or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

Json explorations_json(const ViewSource& source, const KeptExplorations& kept) {
  Json explorations = Json::array();
  for (const Exploration& one : source.recording.explorations) {
    const std::size_t index = source.first + explorations.size();
    Json json{{"index", index},
              {"id", kept.id(index)},
              {"labels", detail::labels_json(kept.names().labels(index, one.labels))}};
    if (index < source.origins.size()) json["recording"] = source.origins[index];
    explorations.push_back(std::move(json));
  }
  return explorations;
}

// With places, as far as they fit: the channels of a body are not known before it explores.
Result<void> add_channels(const ViewState& state, Json& json) {
  json["channels"] = Json::array();
  if (state.played == nullptr) return {};
  std::vector<std::string> names;
  for (const Channel& one : state.played->exploration->channels) {
    names.push_back(one.name);
    json["channels"].push_back(detail::channel_json(one));
  }
  SOMATO_TRY_VOID(check_channels(state.source.places, names));
  for (Json& channel : json["channels"]) {
    SOMATO_TRY_VOID(add_places(state.source.places, channel));
  }
  return {};
}

// By the name of the channel.
Json rates_json(const PlayedExploration* played) {
  Json rates = Json::object();
  if (played == nullptr) return rates;
  const auto& channels = played->exploration->channels;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    rates[channels[i].name] = played->timeline->rate(i);
  }
  return rates;
}

// The file of the session, as it is on the disk.
Json saved_json(const GrowingRecording* file) {
  if (file == nullptr) return {};
  const std::string name = std::filesystem::path(file->path()).filename().string();
  return {{"file", name}, {"explorations", file->count()}};
}

// The length of what a body still explores is not known.
void add_length(const PlayedExploration* played, Json& json) {
  const std::size_t moments =
      played != nullptr && played->has_ended ? played->timeline->moments() : 0;
  json["frames"] = moments > 0 ? Json(moments) : Json();
  json["duration"] = moments > 0 ? Json(played->timeline->time(moments - 1)) : Json();
}

// A recording offers no choice.
void add_things(const ViewState& state, Json& json) {
  json["things"] = Json::array();
  json["thing"] = nullptr;
  json["placement"] = nullptr;
  if (!state.source.explorer) return;
  const auto& things = state.source.explorer->things();
  for (const ExploredThing& thing : things) json["things"].push_back(thing_json(thing));
  json["thing"] = things[state.thing].name;
  if (!things[state.thing].object) return;
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

void add_taught(const ViewState& state, Json& json) {
  json["teaches"] = state.teaches;
  json["taught"] = Json::array();
  for (const TaughtName& one : state.taught) {
    const auto& neuron = one.taught.neuron;
    json["taught"].push_back({{"exploration", one.exploration},
                              {"name", one.name},
                              {"before", one.taught.before},
                              {"neuron", neuron ? Json(*neuron) : Json()},
                              {"problem", or_null(one.problem)}});
  }
}

}  // namespace

Json state_json(const ViewState& state) {
  Json json{{"version", 1},
            {"source", state.source.explorer ? "body" : "recording"},
            {"name", state.source.name},
            {"explorations", explorations_json(state.source, state.kept)},
            {"dropped", state.source.first},
            {"exploration", state.played != nullptr ? Json(state.played->index) : Json()},
            {"labels", detail::labels_json(state.labels)},
            {"first_frame", state.first_frame},
            {"frame", state.frame}};
  add_length(state.played, json);
  json["playing"] = state.playing;
  json["speed"] = state.speed;
  json["live"] = state.played != nullptr && !state.played->has_ended;
  const auto placed = add_channels(state, json);
  json["rates"] = rates_json(state.played);
  add_things(state, json);
  add_systems(state, json);
  add_taught(state, json);
  json["training"] = state.training;
  json["demonstrated"] = state.demonstrated ? Json(*state.demonstrated) : Json();
  json["naming"] = state.naming;
  json["saved"] = saved_json(state.source.file);
  json["losses"] = {{"failed", state.losses.failed},
                    {"unsaved", state.losses.unsaved},
                    {"viewers", state.losses.viewers}};
  json["clients"] = state.clients;
  json["awaits_start"] = state.awaits_start;
  const bool is_first = !placed && state.problem.empty();
  json["problem"] = is_first ? Json(sentence_of(placed.error())) : or_null(state.problem);
  return json;
}

}  // namespace somato::live
