#include "somato/graph/system_training.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "graph/exploration_run.h"
#include "graph/frame_walk.h"
#include "graph/modules/som_module.h"
#include "graph/phase_plan.h"
#include "graph/wiring.h"
#include "somato/core/check.h"
#include "somato/core/random.h"
#include "somato/maps/som_training.h"

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

Lesson lesson_for(const System& system, std::size_t module, const Phase& phase,
                  std::uint64_t seed) {
  std::uint64_t index = 0;
  for (std::size_t i = 0; i < module; ++i) {
    index += system.modules()[i].module->learner() != nullptr ? 1 : 0;
  }
  return {seed_of(seed, index), phase.draws, phase.order, {}, false, false};
}

bool learns_alone(const System& system, const Phase& phase) {
  const std::size_t module = phase.learners.front();
  return phase.learners.size() == 1 &&
         system.modules()[module].module->learner()->learns_at_once() &&
         !system.wiring().reaches(module, module);
}

modules::SomModule* map_of(const System& system, std::size_t module) {
  return dynamic_cast<modules::SomModule*>(system.modules()[module].module.get());
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
      return fail(ErrorKind::kData, "there are no explorations to learn from", {},
                  "give at least one");
    }
    for (const Phase& phase : system_.phases()) {
      if (training_.without == phase.learners.front()) continue;
      const std::vector<std::size_t> computed = computed_in(system_, phase);
      if (auto ready = compute_inputs_of(computed); !ready) return ready;
      Result<void> learned =
          learns_alone(system_, phase) ? learn_alone(phase) : learn_together(phase, computed);
      if (!learned) return learned;
    }
    return {};
  }

 private:
  Learner& learner(std::size_t module) const {
    return *system_.modules()[module].module->learner();
  }

  // What comes into a phase's modules from frozen ones.
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

  Lesson lesson_for(std::size_t module, const Phase& phase) const {
    Lesson lesson = somato::lesson_for(system_, module, phase, training_.seed);
    lesson.progress = training_.progress;
    return lesson;
  }

  Result<void> learn_alone(const Phase& phase) {
    const std::size_t module = phase.learners.front();
    TrainingInputs inputs;
    for (const std::size_t exploration : explorations_) {
      inputs.push_back(run_on(exploration).inputs_of(module));
    }
    auto learned = learner(module).learn(lesson_for(module, phase), inputs);
    if (!learned) return fail(place(std::move(learned.error()), module));
    return {};
  }

  Error place(Error error, std::size_t module) const {
    return error.kind == ErrorKind::kInterrupted ? error
                                                 : system_.at_module(std::move(error), module);
  }

  ExplorationRun run_on(std::size_t exploration) const {
    return {
        system_, &recording_.explorations[exploration],
        [this, exploration](std::size_t module) { return activations_.find(module, exploration); }};
  }

  Result<void> learn_together(const Phase& phase, const std::vector<std::size_t>& computed) {
    std::uint64_t draws = 0;
    turned_.clear();
    for (const std::size_t module : phase.learners) {
      const auto begun = begin(module, phase, computed);
      if (!begun) return fail(place(begun.error(), module));
      draws = *begun;
    }
    const Lesson lesson = lesson_for(phase.learners.front(), phase);
    DrawSequence order(lesson.order.value_or(Draws::kWithReplacement), explorations_.size(),
                       lesson.seed);
    auto learned = phase.of == Rate::kFrame ? learn_frames(phase, computed, draws, order)
                                            : learn_explorations(phase, computed, draws, order);
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

  // A module meets its inputs as they are before anything is learned; one that hears itself cannot
  // have any yet.
  Result<std::uint64_t> begin(std::size_t module, const Phase& phase,
                              const std::vector<std::size_t>& computed) {
    Lesson lesson = lesson_for(module, phase);
    lesson.inputs_unknown = system_.wiring().reaches(module, module);
    lesson.inputs_fixed = has_fixed_inputs(module, phase, computed);
    if (lesson.inputs_unknown || learner(module).begins_without_inputs()) {
      return learner(module).begin(lesson, {});
    }
    std::vector<bool> wanted(system_.modules().size(), false);
    for (const std::size_t input : system_.modules()[module].inputs) wanted[input] = true;
    std::vector<ExplorationRun> runs;
    runs.reserve(explorations_.size());
    TrainingInputs inputs;
    for (std::size_t number = 0; number < explorations_.size(); ++number) {
      turn_to(number);
      runs.push_back(run_on(explorations_[number]));
      if (auto ran = runs.back().compute(wanted); !ran) return fail(ran.error());
      inputs.push_back(runs.back().inputs_of(module));
    }
    const auto begun = learner(module).begin(lesson, inputs);
    if (begun && lesson.inputs_fixed) turned_.push_back(module);
    return begun;
  }

  Result<void> learn_frames(const Phase& phase, const std::vector<std::size_t>& computed,
                            std::uint64_t draws, DrawSequence& order) {
    const std::vector<bool> heard = heard_among(computed);
    std::vector<std::size_t> walked;
    std::copy_if(computed.begin(), computed.end(), std::back_inserter(walked),
                 [&](std::size_t module) { return heard[module]; });
    FrameWalk walk(system_, walked, phase.learners);
    for (std::uint64_t draw = 0; draw < draws;) {
      const std::size_t exploration = explorations_[order.next()];
      auto started =
          walk.start([&](std::size_t module) { return activations_.find(module, exploration); });
      if (!started) return started;
      for (std::size_t frame = 0; frame < walk.frames() && draw < draws; ++frame, ++draw) {
        if (auto stepped = walk.step(); !stepped) return stepped;
        for (const std::size_t module : phase.learners) {
          auto learned = learner(module).step(walk.inputs_of(module), draw);
          if (!learned) return fail(place(std::move(learned.error()), module));
        }
        if (auto going = go_on(draw + 1, draws); !going) return going;
      }
    }
    return {};
  }

  Result<void> learn_explorations(const Phase& phase, const std::vector<std::size_t>& computed,
                                  std::uint64_t draws, DrawSequence& order) {
    const std::vector<bool> wanted = heard_among(computed);
    for (std::uint64_t draw = 0; draw < draws; ++draw) {
      const std::size_t number = order.next();
      turn_to(number);
      ExplorationRun run = run_on(explorations_[number]);
      if (auto ran = run.compute(wanted); !ran) return ran;
      for (const std::size_t module : phase.learners) {
        std::vector<SignalView> inputs;
        for (const Sequence* input : run.inputs_of(module)) inputs.push_back(input->values[0]);
        auto learned = learner(module).step(inputs, draw);
        if (!learned) return fail(place(std::move(learned.error()), module));
      }
      if (auto going = go_on(draw + 1, draws); !going) return going;
    }
    return {};
  }

  // The computed modules that others of them listen to.
  std::vector<bool> heard_among(const std::vector<std::size_t>& computed) const {
    std::vector<bool> heard(system_.modules().size(), false);
    std::vector<bool> inside(system_.modules().size(), false);
    for (const std::size_t module : computed) inside[module] = true;
    for (const std::size_t module : computed) {
      for (const std::size_t input : system_.modules()[module].inputs) heard[input] = inside[input];
    }
    return heard;
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

std::optional<SomParameters> parameters_alone(const System& system, std::size_t module,
                                              std::uint64_t seed) {
  const modules::SomModule* map = map_of(system, module);
  if (!map) return {};
  for (const Phase& phase : system.phases()) {
    for (const std::size_t learner : phase.learners) {
      if (learner != module && system.wiring().reaches(module, learner)) return {};
    }
  }
  for (const Phase& phase : system.phases()) {
    if (phase.learners.front() != module || !learns_alone(system, phase)) continue;
    return map->parameters_for(lesson_for(system, module, phase, seed));
  }
  return {};
}

void set_map(System& system, std::size_t module, Som som) {
  modules::SomModule* map = map_of(system, module);
  require(map != nullptr, "only a module of type som is given a map");
  map->set_som(std::move(som));
}

}  // namespace somato
