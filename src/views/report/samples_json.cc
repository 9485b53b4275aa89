#include "views/report/samples_json.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "bodies/objects/exploration_source.h"
#include "recordings/explorations/recording_json.h"
#include "studies/results/short_number.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

std::string label_or_nothing(const Exploration& exploration, const std::string& name) {
  return find_label(exploration, name).value_or(std::string());
}

// The name of the explored thing: an object, or else a material.
std::string name_of(const Exploration& exploration, const std::string& studied) {
  for (const std::string& label : {std::string("object"), std::string("material"), studied}) {
    if (std::string name = label_or_nothing(exploration, label); !name.empty()) return name;
  }
  return {};
}

std::string studied_label(const Evidence& evidence) {
  const auto& protocols = evidence.part->protocols;
  return protocols.empty() ? std::string() : protocols.front().label;
}

bool agree(const std::string& labelled, const std::string& known) {
  return labelled.empty() || known.empty() || labelled == known;
}

// An object of another source may have the same name: false if none of the known ones is this one.
bool complete(ReportThing& thing, const std::vector<ReportThing>& known) {
  for (const ReportThing& one : known) {
    if (one.name != thing.name || !agree(thing.shape, one.shape) ||
        !agree(thing.material, one.material) || !agree(thing.hardness, one.hardness)) {
      continue;
    }
    thing = one;
    return true;
  }
  return false;
}

// The things of the user, and the built-in ones if a simulated body explored them.
void complete(ReportThing& thing, std::string_view source, const ReportSources& known) {
  if (complete(thing, known.things) || !is_of_built_in_things(source)) return;
  complete(thing, known.built_in_things);
}

std::vector<ReportThing> labelled_things(const Evidence& evidence, const ReportSources& known) {
  std::vector<ReportThing> things;
  const std::string label = studied_label(evidence);
  for (const std::size_t i : first_of_each(evidence)) {
    const Exploration& exploration = evidence.recording->explorations[i];
    ReportThing thing;
    thing.name = name_of(exploration, label);
    thing.shape = label_or_nothing(exploration, "shape");
    thing.material = label_or_nothing(exploration, "material");
    thing.hardness = label_or_nothing(exploration, "hardness");
    complete(thing, exploration.source, known);
    things.push_back(std::move(thing));
  }
  return things;
}

// Without a recording the classes are all there is, where they are things.
std::vector<ReportThing> studied_things(const Evidence& evidence, const ReportSources& known) {
  std::vector<ReportThing> things;
  const auto& recordings = evidence.part->recordings;
  const std::string source = recordings.empty() ? std::string() : recordings.front().source;
  std::set<std::string> seen;
  for (const ProtocolResults& protocol : evidence.part->protocols) {
    if (protocol.label != "object" && protocol.label != "material") continue;
    for (const Run& run : protocol.runs) {
      for (const std::string& name : run.labels) {
        if (!seen.insert(name).second) continue;
        things.push_back({name, {}, {}, 0.0, {}, {}, {}, {}});
        complete(things.back(), source, known);
      }
    }
  }
  return things;
}

template <typename Array>
Json triple_json(const std::optional<Array>& values) {
  return values ? Json(*values) : Json(nullptr);
}

Json thing_json(const ReportThing& thing) {
  return {{"name", thing.name},
          {"shape", thing.shape.empty() ? Json(nullptr) : Json(thing.shape)},
          {"size", triple_json(thing.size)},
          {"top_diameter", thing.top_diameter},
          {"material", thing.material},
          {"hardness", thing.hardness},
          {"colour", triple_json(thing.colour)},
          {"mass", thing.mass ? Json(*thing.mass) : Json(nullptr)}};
}

}  // namespace

std::vector<std::size_t> first_of_each(const Evidence& evidence) {
  std::set<std::string> seen;
  std::vector<std::size_t> first;
  const std::string label = studied_label(evidence);
  for (const std::size_t i : evidence.explorations) {
    if (seen.insert(name_of(evidence.recording->explorations[i], label)).second) {
      first.push_back(i);
    }
  }
  return first;
}

Json samples_json(const Evidence& evidence) {
  if (!evidence.recording) return nullptr;
  Json json = Json::array();
  for (const std::size_t i : evidence.explorations) {
    json.push_back(labels_json(evidence.recording->explorations[i].labels));
  }
  return json;
}

Json things_json(const Evidence& evidence, const ReportSources& known) {
  Json json = Json::array();
  for (const ReportThing& thing :
       evidence.recording ? labelled_things(evidence, known) : studied_things(evidence, known)) {
    json.push_back(thing_json(thing));
  }
  return json;
}

}  // namespace somato::detail
