#include "somato/graph/further_learning.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/text/text.h"
#include "maps/reading/sample_reader.h"
#include "somato/core/check.h"
#include "somato/graph/answers.h"
#include "somato/graph/evaluation.h"
#include "somato/maps/som.h"
#include "systems/modules/map_module.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

// The inputs of the map for these explorations, in their order.
Result<Samples> inputs_of(const System& system, std::size_t map, const Recording& recording,
                          std::span<const std::size_t> explorations, std::size_t threads) {
  const std::size_t input = system.modules()[map].inputs.front();
  Activations activations(system.modules().size(), recording.explorations.size());
  SOMATO_TRY_VOID(evaluate(system, recording, explorations, {input}, threads, activations));
  const ExplorationValues& values = activations.values_of(input);
  return values.samples.subset(values.places_of(explorations));
}

// A new name is added.
std::size_t class_of(const std::string& name, std::vector<std::string>& classes) {
  const auto known = std::find(classes.begin(), classes.end(), name);
  const auto number = static_cast<std::size_t>(known - classes.begin());
  if (known == classes.end()) classes.push_back(name);
  return number;
}

Result<Numbers> classes_of(const Recording& recording, std::span<const std::size_t> explorations,
                           const std::string& label, std::vector<std::string>& classes) {
  Numbers numbers;
  numbers.reserve(explorations.size());
  for (const std::size_t exploration : explorations) {
    SOMATO_TRY(const auto name, find_label(recording.explorations[exploration], label));
    numbers.push_back(class_of(name, classes));
  }
  return numbers;
}

bool are_different(std::span<const std::size_t> explorations) {
  Numbers ascending(explorations.begin(), explorations.end());
  std::sort(ascending.begin(), ascending.end());
  return std::adjacent_find(ascending.begin(), ascending.end()) == ascending.end();
}

// In a model of an earlier version, each label counts as one vote.
NeuronVotes votes_of(const SystemAnswer& answer) {
  if (answer.votes.neurons() > 0) return answer.votes;
  NeuronVotes votes(answer.labels.neurons());
  for (const std::size_t neuron : answer.labels.labelled()) {
    votes.add(neuron, *answer.labels[neuron]);
  }
  return votes;
}

Numbers without_name(const NeuronLabels& labels) {
  Numbers neurons;
  for (std::size_t neuron = 0; neuron < labels.neurons(); ++neuron) {
    if (!labels[neuron]) neurons.push_back(neuron);
  }
  return neurons;
}

// Returns the neuron, which may be new, and adds no vote.
Result<std::size_t> give_neuron(modules::MapModule& map, const SignalView& input, std::size_t label,
                                NeuronVotes& votes) {
  if (map.add_neuron(input, label)) {
    NeuronOrigins origins(votes.neurons() + 1);
    for (std::size_t neuron = 0; neuron < votes.neurons(); ++neuron) origins[neuron] = neuron;
    votes = votes.moved_to(origins);
    return votes.neurons() - 1;
  }
  const Numbers free = without_name(votes.labels());
  if (free.empty()) {
    return fail(ErrorKind::kUsage, "all neurons of the map have names", {},
                "use a system with a larger map, or train it with this exploration");
  }
  SomWorkspace workspace;
  const std::size_t neuron = map.som().winner_among(free, input, workspace);
  map.place_neuron(neuron, input, label);
  return neuron;
}

// More votes than for all other names.
void outvote(NeuronVotes& votes, std::size_t neuron, std::size_t label) {
  std::size_t all = 0;
  for (std::size_t one = 0; one < votes.classes(); ++one) all += votes.of(neuron, one);
  votes.add(neuron, label, all + 1);
}

Result<void> check_name(const std::string& name) {
  const auto refuse = [](const std::string& what) {
    return fail(ErrorKind::kUsage, what, {}, "give another name");
  };
  if (trimmed(name).empty()) return refuse("a name is empty");
  if (!is_name(name)) {
    return refuse(fmt::format("{} is not 1 to {} bytes of text without control characters",
                              shown(name), kLongestName));
  }
  if (name == kUnknownAnswer) {
    return refuse("'unknown' is the answer for what a system has not learned");
  }
  return {};
}

modules::MapModule& map_to_change(System& system, std::size_t map) {
  auto* module = dynamic_cast<modules::MapModule*>(system.modules()[map].module.get());
  require(module != nullptr, "only a map can learn further");
  return *module;
}

}  // namespace

Result<NeuronOrigins> learn_further(System& system, std::size_t map, const Samples& inputs,
                                    const FurtherLearning& options) {
  modules::MapModule& learner = map_to_change(system, map);
  LearningPlan plan;
  plan.seed = options.seed;
  plan.progress = options.progress;
  plan.classes = options.classes;
  for (const Phase& phase : system.phases()) {
    if (std::find(phase.learners.begin(), phase.learners.end(), map) == phase.learners.end()) {
      continue;
    }
    if (phase.of == Rate::kExploration) plan.draws = phase.draws;
    plan.order = phase.order;
  }
  auto learned = learner.learn_further(plan, inputs);
  if (learned || learned.error().kind == ErrorKind::kInterrupted) return learned;
  return fail(system.at_module(std::move(learned.error()), map));
}

Result<void> learn_further(SystemModel& model, const Recording& recording,
                           std::span<const std::size_t> explorations,
                           const FurtherLearning& options) {
  require(model.answer.has_value(), "a model needs an answer to learn names");
  require(are_different(explorations), "an exploration is learned once");
  SOMATO_TRY(const auto map, model.system.find(model.answer->map));
  SystemAnswer answer = *model.answer;
  SOMATO_TRY(const auto classes, classes_of(recording, explorations, answer.label, answer.classes));
  SOMATO_TRY(const auto inputs,
             inputs_of(model.system, map, recording, explorations, options.threads));
  FurtherLearning named = options;
  named.classes = classes;
  SOMATO_TRY(const auto origins, learn_further(model.system, map, inputs, named));
  answer.votes = votes_of(answer).moved_to(origins);
  const Som& som = *som_of(model.system, map);
  Numbers all(explorations.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  answer.votes.add_all(first_winners(SampleReader(som, options.threads).read(inputs, all)),
                       classes);
  answer.labels = answer.votes.labels();
  if (answer.novelty) answer.novelty->add_classes(answer.classes.size());
  model.answer = std::move(answer);
  return {};
}

Result<Taught> teach(SystemModel& model, const Recording& recording, std::size_t exploration,
                     const std::string& name) {
  require(model.answer.has_value(), "a model needs an answer to learn names");
  SOMATO_TRY_VOID(check_name(name));
  SOMATO_TRY(const auto map, model.system.find(model.answer->map));
  SOMATO_TRY(const auto inputs, inputs_of(model.system, map, recording, {&exploration, 1}, 1));
  return teach(model, inputs[0], name);
}

Result<Taught> teach(SystemModel& model, const SignalView& input, const std::string& name) {
  require(model.answer.has_value(), "a model needs an answer to learn names");
  SOMATO_TRY_VOID(check_name(name));
  SOMATO_TRY(const auto map, model.system.find(model.answer->map));
  modules::MapModule& module = map_to_change(model.system, map);
  const InputAnswer before = answer_to(model, input);
  Taught taught{before.name(model.answer->classes), {}};
  SystemAnswer answer = *model.answer;
  answer.votes = votes_of(answer);
  SomWorkspace workspace;
  const auto named = [&] {
    return module.som().winner_among(answer.votes.labels().labelled(), input, workspace);
  };
  std::size_t neuron = named();
  const std::size_t label = class_of(name, answer.classes);
  if (taught.before == name) {
    answer.votes.add(neuron, label);
  } else {
    if (before.distance > 0.0) {
      SOMATO_TRY(neuron, give_neuron(module, input, label, answer.votes));
    }
    outvote(answer.votes, neuron, label);
    // Another neuron with nearly the same weights may answer.
    if (named() != neuron) outvote(answer.votes, named(), label);
    taught.neuron = neuron;
  }
  answer.labels = answer.votes.labels();
  if (answer.novelty) answer.novelty->add_classes(answer.classes.size());
  model.answer = std::move(answer);
  return taught;
}

}  // namespace somato
