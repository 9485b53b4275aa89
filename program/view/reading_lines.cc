#include "view/reading_lines.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/maps/novelty.h"

namespace somato::program {
namespace {

using Json = nlohmann::ordered_json;

// Recordings have whole nanoseconds: the last digits of a body's time are not those of its file.
double to_microsecond(double seconds) {
  return std::round(seconds * 1e6) / 1e6;
}

const live::MapReading* answering(const live::SaidReading& said) {
  if (said.reading == nullptr) return nullptr;
  const auto& modules = said.model.system.modules();
  const auto& maps = said.reading->maps;
  const auto found = std::find_if(maps.begin(), maps.end(), [&](const auto& map) {
    return modules[map.first].name == said.model.answer->map;
  });
  return found == maps.end() ? nullptr : &found->second;
}

std::optional<std::string> value_of(const live::SaidReading& said) {
  if (said.reading == nullptr || said.reading->candidates.empty()) return {};
  return said.reading->name(said.model.answer->classes);
}

Json reading_json(const live::SaidReading& said, bool is_final) {
  const auto value = value_of(said);
  const live::MapReading* map = answering(said);
  Json line{{"exploration", said.exploration + 1},
            {"frame", said.moments},
            {"time", to_microsecond(said.time)},
            {"label", said.model.answer->label}};
  line["value"] = value ? Json(*value) : Json();
  line["confidence"] = value ? Json(said.reading->confidence()) : Json();
  line["distance"] = map != nullptr ? Json(map->distance) : Json();
  if (value && said.reading->novelty) {
    line["novelty"] = *said.reading->novelty;
    line["nearest"] = said.model.answer->classes[said.reading->candidates.front().number];
  }
  line["winner"] = map != nullptr ? Json(map->winner) : Json();
  line["final"] = is_final;
  return line;
}

// An exploration without a name has the label "unknown", which is a name like any other if it was
// learned. What was not learned is right to be unknown.
std::optional<bool> is_right(const live::SaidReading& said, const std::string& given) {
  const std::vector<std::string>& learned = said.model.answer->classes;
  const bool is_learned = std::find(learned.begin(), learned.end(), given) != learned.end();
  if (given == kUnknownAnswer && !is_learned) return std::nullopt;
  const auto value = value_of(said);
  const bool is_unknown = value && said.reading->novelty && value == kUnknownAnswer;
  return is_unknown ? !is_learned : value == given;
}

// Labels may hold anything.
std::string json_line(const Json& line) {
  return line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string moment_line(const live::SaidReading& said) {
  return json_line(reading_json(said, false));
}

std::string final_line(const live::SaidReading& said, const Exploration& exploration) {
  Json line = reading_json(said, true);
  const auto given = find_label(exploration, said.model.answer->label);
  const auto right = given ? is_right(said, *given) : std::nullopt;
  if (right) {
    line["given"] = *given;
    line["right"] = *right;
  }
  return json_line(line);
}

std::string taught_line(const live::TaughtName& name) {
  Json line{{"exploration", name.exploration + 1}, {"taught", name.name}};
  if (name.problem.empty()) {
    line["before"] = name.taught.before;
    line["neuron"] = name.taught.neuron ? Json(*name.taught.neuron) : Json();
  } else {
    line["problem"] = name.problem;
  }
  return json_line(line);
}

std::string forgotten_line(const GivenName& name) {
  return json_line({{"exploration", name.exploration + 1}, {"forgotten", name.label.value}});
}

}  // namespace somato::program
