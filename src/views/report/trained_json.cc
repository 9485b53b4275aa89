#include "views/report/trained_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "maps/reading/sample_reader.h"
#include "recordings/explorations/recording_json.h"
#include "somato/maps/som_quality.h"
#include "studies/results/short_number.h"
#include "systems/model/channel_planes.h"
#include "systems/model/learned_parts.h"
#include "views/report/packed_json.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostWeights = 20000;

Json planes_json(const ChannelPlanes& planes) {
  return {
      {"channel", channel_json(planes.name, planes.unit, planes.elements, planes.shape)},
      {"unit", planes.value_unit},
      {"values", packed_rows(planes.values.values(), planes.values.columns(), PackedBits::k16)}};
}

Json hits_json(const std::vector<std::size_t>& winners, std::size_t neurons) {
  std::vector<std::size_t> hits(neurons);
  for (const std::size_t winner : winners) ++hits[winner];
  return hits;
}

void add_winners(const Evidence& evidence, const Som& som, std::size_t threads, Json& json) {
  if (!evidence.inputs) return;
  const auto winners = first_winners(SampleReader(som, threads).read(*evidence.inputs));
  json["winners"] = winners;
  json["hits"] = hits_json(winners, som.neurons());
}

void add_answer(const SystemModel& model, std::size_t neurons, Json& json) {
  json["classes"] = model.answer ? Json(model.answer->classes) : Json::array();
  json["neuron_classes"] = Json::array();
  for (std::size_t neuron = 0; neuron < neurons; ++neuron) {
    const auto its_class = model.answer ? model.answer->labels[neuron] : std::nullopt;
    json["neuron_classes"].push_back(its_class ? Json(*its_class) : Json(nullptr));
  }
}

// A stride over the neurons that includes all columns.
std::size_t step_for(std::size_t neurons, std::size_t elements, std::size_t columns) {
  std::size_t step =
      std::max<std::size_t>(1, (neurons * elements + kMostWeights - 1) / kMostWeights);
  while (step > 1 && std::gcd(step, columns) != 1) ++step;
  return step;
}

Json field_json(const System& system, std::size_t module, const TMpsom& map, std::size_t input) {
  const TMpsomParameters& p = map.parameters();
  const SystemModule& own = system.modules()[module];
  const Matrix<float> weights = map.weights(input);
  const Matrix<float> arbor = map.arbor(input);
  Json numbers = Json::array();
  std::vector<double> receptive;
  const std::size_t step = step_for(weights.rows(), weights.columns(), p.shape[1]);
  for (std::size_t neuron = 0; neuron < weights.rows(); neuron += step) {
    for (std::size_t k = 0; k < weights.columns(); ++k) {
      receptive.push_back(double{arbor(neuron, k)} * double{weights(neuron, k)});
    }
    numbers.push_back(neuron);
  }
  return {{"module", own.name},
          {"shape", {p.shape[0], p.shape[1]}},
          {"input", system.modules()[own.inputs[input]].name},
          {"axis", p.axes()[input]},
          {"elements", weights.columns()},
          {"neurons", std::move(numbers)},
          {"weights", packed_rows(receptive, weights.columns(), PackedBits::k16)}};
}

}  // namespace

Json receptive_fields_json(const System& system, std::vector<std::string>& missing) {
  Json json = Json::array();
  for (std::size_t module = 0; module < system.modules().size(); ++module) {
    const auto map = t_mpsom_of(system, module);
    if (!map) continue;
    const std::string& name = system.modules()[module].name;
    if (map->parameters().shape.size() != 2) {
      missing.push_back("Receptive fields of '" + name +
                        "' are left out, because only those of maps with two axes can be drawn.");
      continue;
    }
    for (std::size_t i = 0; i < map->parameters().input_sizes.size(); ++i) {
      if (map->parameters().input_sizes[i] <= kMostWeights) {
        json.push_back(field_json(system, module, *map, i));
        continue;
      }
      missing.push_back(
          fmt::format("Receptive fields of '{}' are left out, because an input has {} elements; "
                      "the maximum is {}.",
                      name, map->parameters().input_sizes[i], kMostWeights));
    }
  }
  return json;
}

Json trained_json(Evidence& evidence, std::size_t threads) {
  if (!evidence.model || !evidence.map) return nullptr;
  const SystemModel& model = evidence.model->model;
  const Som& som = *som_of(model.system, *evidence.map);
  Json json = {{"file", evidence.model->path}, {"seed", evidence.part->model->seed}};
  add_answer(model, som.neurons(), json);
  json["u_matrix"] = short_numbers(std::span<const double>(u_matrix(som)));
  json["winners"] = Json::array();
  json["hits"] = Json::array();
  add_winners(evidence, som, threads, json);
  json["planes"] = Json::array();
  for (const ChannelPlanes& planes : channel_planes(model.system, *evidence.map)) {
    json["planes"].push_back(planes_json(planes));
  }
  json["receptive_fields"] = receptive_fields_json(model.system, evidence.missing);
  return json;
}

}  // namespace somato::detail
