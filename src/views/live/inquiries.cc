#include "views/live/inquiries.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "recordings/explorations/recording_json.h"
#include "somato/graph/evaluation.h"

namespace somato::live {
namespace {

constexpr std::size_t kMostExplorationsReplied = 2000;
constexpr std::size_t kNearest = 10;

Json plane_json(const ChannelPlanes& planes, std::size_t neuron) {
  const auto row = planes.values.row(neuron);
  const Json values(std::vector<double>(row.begin(), row.end()));
  return {{"channel",
           {{"name", planes.name},
            {"unit", planes.unit},
            {"elements", planes.elements},
            {"shape", planes.shape}}},
          {"unit", planes.value_unit},
          {"values", Json::array({values})}};
}

// A channel with an element for each touch sensor: its force, or what a piezo element makes of it.
bool is_of_touch(const std::string& channel) {
  return channel == "touch" || channel == "touch_change";
}

}  // namespace

// New explorations of a body follow the earlier ones, of which the findings remain valid.
void Inquiries::turn_to(const InquiredSystem& system) {
  const std::size_t end = system.first + system.recording->explorations.size();
  const bool is_known = model_ == system.model && end_ <= end;
  model_ = system.model;
  end_ = end;
  if (is_known) return;
  maps_.clear();
  for (std::size_t i = 0; i < model_->system.modules().size(); ++i) {
    if (som_of(model_->system, i) == nullptr) continue;
    maps_.push_back({i, channel_planes(model_->system, i), 0, {}});
  }
}

Inquiries::KnownMap* Inquiries::find(const std::string& map) {
  const auto found = std::find_if(maps_.begin(), maps_.end(), [&](const KnownMap& one) {
    return model_->system.modules()[one.module].name == map;
  });
  return found == maps_.end() ? nullptr : &*found;
}

// An exploration that does not fit the system has no input, and is near to no neuron.
Result<void> Inquiries::find_inputs(const InquiredSystem& inquired, KnownMap& map) const {
  const System& system = model_->system;
  if (system.modules()[map.module].output.rate == Rate::kFrame) return {};
  const std::size_t input = system.modules()[map.module].inputs.front();
  const std::size_t first = inquired.first;
  const std::size_t explorations = inquired.recording->explorations.size();
  while (!map.inputs.empty() && map.inputs.front().exploration < first) map.inputs.pop_front();
  map.seen = std::max(map.seen, first);
  for (; map.seen < first + std::min(explorations, kMostExplorationsReplied); ++map.seen) {
    if (is_over_()) return fail(ErrorKind::kUsage, "the view is closing");
    Activations activations(system.modules().size(), explorations);
    const std::array<std::size_t, 1> one{map.seen - first};
    if (!evaluate(system, *inquired.recording, one, {input}, 1, activations)) continue;
    map.inputs.push_back({map.seen, Signal::copy_of(activations.find(input, one[0])->values[0])});
  }
  return {};
}

Json Inquiries::nearest(const InquiredSystem& system, const KnownMap& map, std::size_t neuron) {
  const Som& som = *som_of(system.model->system, map.module);
  SomWorkspace workspace;
  std::vector<std::pair<double, std::size_t>> distances;
  distances.reserve(map.inputs.size());
  for (const ExplorationInput& input : map.inputs) {
    distances.emplace_back(som.distance(input.signal.view(), neuron, workspace), input.exploration);
  }
  std::sort(distances.begin(), distances.end());
  Json nearest = Json::array();
  for (std::size_t i = 0; i < std::min(kNearest, distances.size()); ++i) {
    const auto& [distance, exploration] = distances[i];
    nearest.push_back(
        {{"exploration", exploration},
         {"labels",
          detail::labels_json(system.recording->explorations[exploration - system.first].labels)},
         {"distance", distance}});
  }
  return nearest;
}

Result<std::string> Inquiries::neuron(const InquiredSystem& system, const std::string& map,
                                      std::size_t neuron) {
  const std::scoped_lock lock(mutex_);
  turn_to(system);
  KnownMap* known = find(map);
  if (known == nullptr) return fail(ErrorKind::kUsage, "unknown map");
  const Som& som = *som_of(model_->system, known->module);
  if (neuron >= som.neurons()) {
    return fail(ErrorKind::kUsage, fmt::format("the map has {} neurons", som.neurons()));
  }
  SOMATO_TRY_VOID(find_inputs(system, *known));
  const auto& answer = model_->answer;
  const bool answers = answer && answer->map == map && answer->labels[neuron];
  Json planes = Json::array();
  for (const ChannelPlanes& one : known->planes) planes.push_back(plane_json(one, neuron));
  return json_text({{"map", map},
                    {"neuron", neuron},
                    {"answer", answers ? Json(answer->classes[*answer->labels[neuron]]) : Json()},
                    {"planes", std::move(planes)},
                    {"nearest", nearest(system, *known, neuron)}});
}

Result<std::string> Inquiries::taxel(const InquiredSystem& system, std::size_t element) {
  const std::scoped_lock lock(mutex_);
  turn_to(system);
  Json maps = Json::object();
  std::string name;
  for (const KnownMap& one : maps_) {
    for (const ChannelPlanes& planes : one.planes) {
      if (!is_of_touch(planes.name) || element >= planes.values.columns()) continue;
      if (element < planes.elements.size()) name = planes.elements[element];
      Json weights = Json::array();
      for (std::size_t neuron = 0; neuron < planes.values.rows(); ++neuron) {
        const double weight = planes.values(neuron, element);
        weights.push_back(std::isfinite(weight) ? weight : 0.0);
      }
      maps[model_->system.modules()[one.module].name] = std::move(weights);
    }
  }
  if (maps.empty())
    return fail(ErrorKind::kUsage, "no map of this system has this taxel in its input");
  return json_text({{"element", element}, {"name", name}, {"maps", std::move(maps)}});
}

}  // namespace somato::live
