#include "somato/graph/further_learning.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "graph/modules/map_module.h"
#include "somato/core/check.h"
#include "somato/graph/evaluation.h"
#include "somato/maps/som.h"

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

// The class of each exploration; new names are added to `classes`.
Result<Numbers> classes_of(const Recording& recording, std::span<const std::size_t> explorations,
                           const std::string& label, std::vector<std::string>& classes) {
  Numbers numbers;
  numbers.reserve(explorations.size());
  for (const std::size_t exploration : explorations) {
    SOMATO_TRY(const auto name, find_label(recording.explorations[exploration], label));
    const auto known = std::find(classes.begin(), classes.end(), name);
    numbers.push_back(static_cast<std::size_t>(known - classes.begin()));
    if (known == classes.end()) classes.push_back(name);
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

}  // namespace

Result<NeuronOrigins> learn_further(System& system, std::size_t map, const Samples& inputs,
                                    const FurtherLearning& options) {
  auto* learner = dynamic_cast<modules::MapModule*>(system.modules()[map].module.get());
  require(learner != nullptr, "only a map can learn further");
  LearningPlan plan;
  plan.seed = options.seed;
  plan.progress = options.progress;
  for (const Phase& phase : system.phases()) {
    if (std::find(phase.learners.begin(), phase.learners.end(), map) == phase.learners.end()) {
      continue;
    }
    if (phase.of == Rate::kExploration) plan.draws = phase.draws;
    plan.order = phase.order;
  }
  auto learned = learner->learn_further(plan, inputs);
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
  SOMATO_TRY(const auto origins, learn_further(model.system, map, inputs, options));
  answer.votes = votes_of(answer).moved_to(origins);
  const Som& som = *som_of(model.system, map);
  SomWorkspace workspace;
  for (std::size_t i = 0; i < explorations.size(); ++i) {
    answer.votes.add(som.winners(inputs, i, workspace).first, classes[i]);
  }
  answer.labels = answer.votes.labels();
  if (answer.novelty) answer.novelty->add_classes(answer.classes.size());
  model.answer = std::move(answer);
  return {};
}

}  // namespace somato
