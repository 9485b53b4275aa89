#include "report/trained_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "report/samples_json.h"
#include "report/short_number.h"
#include "somato/graph/channel_planes.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/learned_parts.h"
#include "somato/maps/som_quality.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostNumbers = 20000;

Json planes_json(const ChannelPlanes& planes) {
  Json values = Json::array();
  for (std::size_t neuron = 0; neuron < planes.values.rows(); ++neuron) {
    values.push_back(short_numbers(planes.values.row(neuron)));
  }
  return {{"channel", channel_json(planes.name, planes.unit, planes.elements, planes.shape)},
          {"unit", planes.value_unit},
          {"values", std::move(values)}};
}

// What the samples bring to the saved map, and the neurons that win there.
struct Answers {
  std::vector<Signal> inputs;
  std::vector<std::size_t> winners;
};

Signal copy_of(const SignalView& view) {
  std::vector<float> values(view.size);
  if (!view.sparse) {
    write_dense(view, values);
    return Signal::dense(std::move(values));
  }
  return Signal::sparse({view.size}, {view.indices.begin(), view.indices.end()},
                        {view.values.begin(), view.values.end()});
}

Result<Answers> answers_of(const Evidence& evidence, std::size_t threads) {
  const System& system = *evidence.system();
  const Recording& recording = *evidence.recording;
  const std::size_t input = system.modules()[*evidence.map].inputs.front();
  Activations activations(system.modules().size(), recording.explorations.size());
  auto evaluated =
      evaluate(system, recording, evidence.explorations, {input}, threads, activations);
  if (!evaluated) return fail(std::move(evaluated.error()));
  SomWorkspace workspace;
  const Som& som = *som_of(system, *evidence.map);
  Answers answers;
  for (const std::size_t exploration : evidence.explorations) {
    const Samples& values = activations.find(input, exploration)->values;
    answers.inputs.push_back(copy_of(values[values.count() - 1]));
    answers.winners.push_back(som.winner(answers.inputs.back().view(), workspace));
  }
  return answers;
}

// How far from a sample two neurons that a study takes for equally near may lie: it may have known
// the map by its inner products, and the saved one has weights in single precision.
double rounding(const Som& som, const SignalView& input) {
  constexpr double kRelative = 1e-5;
  const bool unit = som.parameters().normalize_input.value_or(false);
  return kRelative * (unit ? 1.0 : std::sqrt(inner_product(input, input)));
}

bool are_winners(const Som& som, const Answers& answers, const std::vector<std::size_t>& winners) {
  SomWorkspace workspace;
  if (winners.size() != answers.winners.size()) return false;
  for (std::size_t i = 0; i < winners.size(); ++i) {
    if (winners[i] == answers.winners[i]) continue;
    if (winners[i] >= som.neurons()) return false;
    const SignalView input = answers.inputs[i].view();
    const double nearest = som.distance(input, answers.winners[i], workspace);
    if (som.distance(input, winners[i], workspace) > nearest + rounding(som, input)) return false;
  }
  return true;
}

// The saved system is one of the runs if all of its winners are.
std::optional<std::uint64_t> seed_of(const Evidence& evidence, const Answers& answers) {
  const PartResults& part = *evidence.part;
  const Som& som = *som_of(*evidence.system(), *evidence.map);
  for (const SystemResults& protocol : part.protocols) {
    if (protocol.protocol != "train_is_test") continue;
    for (std::size_t i = 0; i < protocol.runs.size(); ++i) {
      const bool of_recording = part.pairs[i].recording == evidence.recording_number;
      if (of_recording && are_winners(som, answers, protocol.runs[i].winners)) {
        return protocol.runs[i].seed;
      }
    }
  }
  return {};
}

bool has_runs_of_all(const PartResults& part) {
  return std::any_of(part.protocols.begin(), part.protocols.end(),
                     [](const auto& protocol) { return protocol.protocol == "train_is_test"; });
}

Json hits_json(const std::vector<std::size_t>& winners, std::size_t neurons) {
  std::vector<std::size_t> hits(neurons);
  for (const std::size_t winner : winners) ++hits[winner];
  return hits;
}

void add_hits(Evidence& evidence, std::size_t neurons, std::size_t threads, Json& json) {
  if (!evidence.recording) return;
  const auto answers = answers_of(evidence, threads);
  if (!answers) {
    evidence.missing.push_back(
        "Hits are left out: the trained system cannot be asked about the "
        "recording (" +
        to_string(answers.error()) + ").");
    return;
  }
  json["hits"] = hits_json(answers->winners, neurons);
  if (const auto seed = seed_of(evidence, *answers)) {
    json["seed"] = *seed;
  } else if (has_runs_of_all(*evidence.part)) {
    evidence.missing.push_back("The winners of '" + evidence.model->path +
                               "' are those of no run here: it was trained on other data or with "
                               "another seed.");
  }
}

void add_answer(const SystemModel& model, std::size_t neurons, Json& json) {
  json["classes"] = model.answer ? Json(model.answer->classes) : Json::array();
  json["neuron_classes"] = Json::array();
  for (std::size_t neuron = 0; neuron < neurons; ++neuron) {
    const auto its_class = model.answer ? model.answer->labels[neuron] : std::nullopt;
    json["neuron_classes"].push_back(its_class ? Json(*its_class) : Json(nullptr));
  }
}

// Every so-and-so-manieth, yet of all columns.
std::size_t step_for(std::size_t neurons, std::size_t elements, std::size_t columns) {
  std::size_t step =
      std::max<std::size_t>(1, (neurons * elements + kMostNumbers - 1) / kMostNumbers);
  while (step > 1 && std::gcd(step, columns) != 1) ++step;
  return step;
}

Json field_json(const System& system, std::size_t module, const TMpsom& map, std::size_t input) {
  const TMpsomParameters& p = map.parameters();
  const SystemModule& own = system.modules()[module];
  const Matrix<float> weights = map.weights(input);
  const Matrix<float> arbor = map.arbor(input);
  Json numbers = Json::array();
  Json rows = Json::array();
  const std::size_t step = step_for(weights.rows(), weights.columns(), p.shape[1]);
  for (std::size_t neuron = 0; neuron < weights.rows(); neuron += step) {
    std::vector<double> heard(weights.columns());
    for (std::size_t k = 0; k < heard.size(); ++k) {
      heard[k] = double{arbor(neuron, k)} * double{weights(neuron, k)};
    }
    numbers.push_back(neuron);
    rows.push_back(short_numbers(std::span<const double>(heard)));
  }
  return {{"module", own.name},
          {"shape", {p.shape[0], p.shape[1]}},
          {"input", system.modules()[own.inputs[input]].name},
          {"axis", p.axes()[input]},
          {"elements", weights.columns()},
          {"neurons", std::move(numbers)},
          {"weights", std::move(rows)}};
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
                        "' are left out: only those of maps with two axes can be drawn.");
      continue;
    }
    for (std::size_t i = 0; i < map->parameters().input_sizes.size(); ++i) {
      if (map->parameters().input_sizes[i] <= kMostNumbers) {
        json.push_back(field_json(system, module, *map, i));
        continue;
      }
      missing.push_back(
          fmt::format("Receptive fields of '{}' are left out for an input of {} "
                      "elements: {} are the most.",
                      name, map->parameters().input_sizes[i], kMostNumbers));
    }
  }
  return json;
}

Json trained_json(Evidence& evidence, std::size_t threads) {
  if (!evidence.model || !evidence.map) return nullptr;
  const SystemModel& model = evidence.model->model;
  const Som& som = *som_of(model.system, *evidence.map);
  Json json = {{"file", evidence.model->path}, {"seed", nullptr}};
  add_answer(model, som.neurons(), json);
  json["u_matrix"] = short_numbers(std::span<const double>(u_matrix(som)));
  json["hits"] = Json::array();
  add_hits(evidence, som.neurons(), threads, json);
  json["planes"] = Json::array();
  for (const ChannelPlanes& planes : channel_planes(model.system, *evidence.map)) {
    json["planes"].push_back(planes_json(planes));
  }
  json["receptive_fields"] = receptive_fields_json(model.system, evidence.missing);
  return json;
}

}  // namespace somato::detail
