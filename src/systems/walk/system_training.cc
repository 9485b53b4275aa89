#include "somato/graph/system_training.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/core/contains.h"
#include "somato/core/random.h"
#include "somato/graph/system_model.h"
#include "systems/graph/phase_plan.h"
#include "systems/graph/wiring.h"
#include "systems/walk/walk.h"

namespace somato {
namespace {

// A seed for the learning module that is number `index` of the system, below 1e15.
std::uint64_t seed_of(std::uint64_t seed, std::uint64_t index) {
  if (index == 0) return seed;
  constexpr std::uint64_t kBits49 = (std::uint64_t{1} << 49) - 1;
  const auto words =
      philox4x32({static_cast<std::uint32_t>(index), 0x6D6F6475U, 0, 0},
                 {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)});
  return ((std::uint64_t{words[0]} << 32U) | words[1]) & kBits49;
}

LearningPlan learning_plan_for(const System& system, std::size_t module, const Phase& phase,
                               std::uint64_t seed) {
  std::uint64_t index = 0;
  for (std::size_t i = 0; i < module; ++i) {
    index += system.modules()[i].module->learner() != nullptr ? 1 : 0;
  }
  LearningPlan plan;
  plan.seed = seed_of(seed, index);
  plan.draws = phase.draws;
  plan.order = phase.order;
  return plan;
}

class Trainer {
 public:
  Trainer(System& system, const Recording& recording, std::span<const std::size_t> explorations,
          const SystemTraining& training, Activations& activations)
      : system_(system),
        recording_(recording),
        explorations_(explorations),
        training_(training),
        activations_(activations) {}

  Result<void> train() {
    if (explorations_.empty()) {
      return fail(ErrorKind::kData, "no explorations to learn from", {}, "provide at least one");
    }
    for (const Phase& phase : system_.phases()) {
      const std::vector<std::size_t> computed = computed_in(system_, phase);
      SOMATO_TRY_VOID(compute_inputs_of(computed));
      Result<void> learned = learns_separately(system_, phase) ? learn_separately(phase)
                                                               : learn_together(phase, computed);
      if (!learned) return learned;
    }
    return {};
  }

 private:
  Learner& learner(std::size_t module) const {
    return *system_.modules()[module].module->learner();
  }

  // The outputs of frozen modules that are inputs of a phase's modules.
  Result<void> compute_inputs_of(const std::vector<std::size_t>& computed) {
    std::vector<std::size_t> wanted;
    for (const std::size_t module : computed) {
      for (const std::size_t input : system_.modules()[module].inputs) {
        const bool inside = std::find(computed.begin(), computed.end(), input) != computed.end();
        if (!inside) wanted.push_back(input);
      }
    }
    return evaluate(system_, recording_, explorations_, wanted, training_.threads, activations_);
  }

  LearningPlan learning_plan_for(std::size_t module, const Phase& phase) const {
    LearningPlan plan = somato::learning_plan_for(system_, module, phase, training_.seed);
    plan.progress = training_.progress;
    if (training_.classes.empty()) return plan;
    for (const std::size_t one : explorations_) plan.classes.push_back(training_.classes[one]);
    return plan;
  }

  Result<void> learn_separately(const Phase& phase) {
    const std::size_t module = phase.learners.front();
    TrainingInputs inputs;
    for (const std::size_t exploration : explorations_) {
      inputs.push_back(inputs_of(module, activations_, exploration));
    }
    LearningPlan plan = learning_plan_for(module, phase);
    if (som_of(system_, module)) {
      SOMATO_TRY_VOID(give_known(module, plan));
    }
    auto learned = learner(module).learn(plan, inputs);
    if (!learned) return fail(place(std::move(learned.error()), module));
    return {};
  }

  // Additional inputs of a map that learns separately.
  Result<void> give_known(std::size_t module, LearningPlan& plan) {
    const std::size_t input = system_.modules()[module].inputs.front();
    std::vector<std::size_t> unknown;
    std::copy_if(training_.tested.begin(), training_.tested.end(), std::back_inserter(unknown),
                 [&](std::size_t tested) { return !activations_.find(input, tested); });
    if (!unknown.empty()) {
      auto evaluated =
          evaluate(system_, recording_, unknown, {input}, training_.threads, activations_);
      if (!evaluated) return evaluated;
    }
    const ExplorationValues& values = activations_.values_of(input);
    plan.known = values.samples;
    plan.training = values.places_of(explorations_);
    if (training_.observer) {
      plan.observer = [this, module](const TrainingMoment& moment) {
        return training_.observer(module, moment);
      };
    }
    return {};
  }

  Error place(Error error, std::size_t module) const {
    return error.kind == ErrorKind::kInterrupted ? error
                                                 : system_.at_module(std::move(error), module);
  }

  std::vector<const Sequence*> inputs_of(std::size_t module, const Activations& known,
                                         std::size_t exploration) const {
    std::vector<const Sequence*> inputs;
    for (const std::size_t input : system_.modules()[module].inputs) {
      inputs.push_back(known.find(input, exploration));
    }
    return inputs;
  }

  // Over what these modules listen to, as far as it is not frozen.
  Walk walk_before(const std::vector<std::size_t>& listeners,
                   const std::vector<std::size_t>& computed, Outputs outputs) const {
    const auto is_known = [&](std::size_t module) {
      return !contains(computed, module) &&
             activations_.find(module, explorations_.front()) != nullptr;
    };
    std::vector<std::size_t> wanted;
    for (const std::size_t listener : listeners) {
      for (const std::size_t input : system_.modules()[listener].inputs) {
        if (!is_known(input)) wanted.push_back(input);
      }
    }
    return {system_, wanted, outputs, is_known};
  }

  Result<void> start(Walk& walk, std::size_t exploration) const {
    return walk.start(
        &recording_.explorations[exploration],
        [this, exploration](std::size_t module) { return activations_.find(module, exploration); });
  }

  Result<void> learn_together(const Phase& phase, const std::vector<std::size_t>& computed) {
    std::uint64_t draws = 0;
    turned_.clear();
    for (const std::size_t module : phase.learners) {
      const auto begun = begin(module, phase, computed);
      if (!begun) return fail(place(begun.error(), module));
      draws = *begun;
    }
    const LearningPlan plan = learning_plan_for(phase.learners.front(), phase);
    DrawSequence order(plan.order.value_or(Draws::kWithReplacement), explorations_.size(),
                       plan.seed);
    Walk walk = walk_before(phase.learners, computed, Outputs::kLatest);
    auto learned = phase.of == Rate::kFrame ? learn_frames(phase, walk, draws, order)
                                            : learn_explorations(phase, walk, draws, order);
    if (!learned) return learned;
    for (const std::size_t module : phase.learners) learner(module).finish();
    return {};
  }

  // Whether an exploration brings the module the same one value at each port throughout the phase.
  bool has_fixed_inputs(std::size_t module, const Phase& phase,
                        const std::vector<std::size_t>& computed) const {
    const std::vector<std::size_t>& inputs = system_.modules()[module].inputs;
    return phase.of == Rate::kExploration &&
           std::none_of(inputs.begin(), inputs.end(), [&](std::size_t input) {
             return std::find(computed.begin(), computed.end(), input) != computed.end();
           });
  }

  // `number` is that of an exploration among those to learn from.
  void turn_to(std::size_t number) {
    for (const std::size_t module : turned_) learner(module).turn_to(number);
  }

  // A module receives its inputs from before any learning; one that depends on its own output has
  // none yet.
  Result<std::uint64_t> begin(std::size_t module, const Phase& phase,
                              const std::vector<std::size_t>& computed) {
    LearningPlan plan = learning_plan_for(module, phase);
    plan.inputs_unknown = system_.wiring().reaches(module, module);
    plan.inputs_fixed = has_fixed_inputs(module, phase, computed);
    if (plan.inputs_unknown || learner(module).begins_without_inputs()) {
      return learner(module).begin(plan, {});
    }
    Walk walk = walk_before({module}, computed, Outputs::kAll);
    Activations computed_now = activations_;
    TrainingInputs inputs;
    for (std::size_t number = 0; number < explorations_.size(); ++number) {
      turn_to(number);
      const std::size_t exploration = explorations_[number];
      auto walked = start(walk, exploration).and_then([&] { return walk.run(); });
      if (!walked) return fail(walked.error());
      for (const std::size_t input : system_.modules()[module].inputs) {
        if (computed_now.find(input, exploration)) continue;
        computed_now.set(input, exploration, std::make_shared<const Sequence>(walk.take(input)));
      }
      inputs.push_back(inputs_of(module, computed_now, exploration));
    }
    const auto begun = learner(module).begin(plan, inputs);
    if (begun && plan.inputs_fixed) turned_.push_back(module);
    return begun;
  }

  Result<void> learn_frames(const Phase& phase, Walk& walk, std::uint64_t draws,
                            DrawSequence& order) {
    for (std::uint64_t draw = 0; draw < draws;) {
      SOMATO_TRY_VOID(start(walk, explorations_[order.next()]));
      SOMATO_TRY(const auto frames,
                 phase.settles ? walk.frames() : frames_into(walk, phase.learners));
      for (std::size_t frame = 0; frame < frames && draw < draws; ++frame, ++draw) {
        SOMATO_TRY_VOID(walk.step(frame));
        if (phase.settles) SOMATO_TRY_VOID(walk.settle());
        SOMATO_TRY_VOID(learn(phase, walk, draw, draws));
      }
    }
    return {};
  }

  // All modules that learn together meet as many frames.
  Result<std::size_t> frames_into(Walk& walk, const std::vector<std::size_t>& learners) const {
    std::optional<std::size_t> common;
    for (const std::size_t module : learners) {
      auto frames = walk.frames_into(module);
      if (!frames) return frames;
      if (common.value_or(*frames) != *frames) {
        Error error{
            ErrorKind::kData,
            fmt::format("{} frames arrive at one input, but {} at another", *frames, *common),
            {},
            "record the channels together, frame by frame"};
        return fail(system_.at_module(std::move(error), module));
      }
      common = *frames;
    }
    return common.value_or(0);
  }

  Result<void> learn_explorations(const Phase& phase, Walk& walk, std::uint64_t draws,
                                  DrawSequence& order) {
    for (std::uint64_t draw = 0; draw < draws; ++draw) {
      const std::size_t number = order.next();
      turn_to(number);
      auto walked = start(walk, explorations_[number]).and_then([&] { return walk.run(); });
      if (!walked) return walked;
      SOMATO_TRY_VOID(learn(phase, walk, draw, draws));
    }
    return {};
  }

  // All modules learn from outputs with the weights before this draw.
  Result<void> learn(const Phase& phase, const Walk& walk, std::uint64_t draw,
                     std::uint64_t draws) {
    for (const std::size_t module : phase.learners) {
      auto learned = learner(module).step(walk.inputs_of(module), draw);
      if (!learned) return fail(place(std::move(learned.error()), module));
    }
    return go_on(draw + 1, draws);
  }

  Result<void> go_on(std::uint64_t done, std::uint64_t draws) const {
    constexpr std::uint64_t kDrawsBetweenReports = 64;
    if (!training_.progress || (done % kDrawsBetweenReports != 0 && done != draws)) return {};
    if (training_.progress(done, draws)) return {};
    return fail(ErrorKind::kInterrupted, "the training was stopped before its end");
  }

  System& system_;
  const Recording& recording_;
  std::span<const std::size_t> explorations_;
  const SystemTraining& training_;
  Activations& activations_;
  std::vector<std::size_t> turned_;  // the phase's learners, as far as begun, with fixed inputs
};

}  // namespace

Result<void> train_system(System& system, const Recording& recording,
                          std::span<const std::size_t> explorations, const SystemTraining& training,
                          Activations& activations) {
  return Trainer(system, recording, explorations, training, activations).train();
}

}  // namespace somato
