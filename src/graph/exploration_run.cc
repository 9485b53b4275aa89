#include "graph/exploration_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

#include "graph/finite.h"
#include "graph/frame_walk.h"
#include "graph/wiring.h"

namespace somato {

ExplorationRun::ExplorationRun(const System& system, const Exploration* exploration, Known known)
    : system_(system),
      exploration_(exploration),
      known_(std::move(known)),
      computed_(system.modules().size()) {}

const Sequence* ExplorationRun::find(std::size_t module) const {
  return computed_[module] ? computed_[module].get() : known_(module);
}

std::vector<const Sequence*> ExplorationRun::inputs_of(std::size_t module) const {
  std::vector<const Sequence*> inputs;
  const std::vector<std::size_t>& modules = system_.modules()[module].inputs;
  inputs.reserve(modules.size());
  for (const std::size_t input : modules) inputs.push_back(find(input));
  return inputs;
}

Result<void> ExplorationRun::compute(const std::vector<bool>& wanted) {
  const std::vector<bool> needed =
      needed_for(system_, wanted, [&](std::size_t module) { return find(module) != nullptr; });
  for (const auto& group : system_.wiring().groups()) {
    const bool is_needed =
        std::any_of(group.begin(), group.end(), [&](std::size_t module) { return needed[module]; });
    if (!is_needed) continue;
    if (auto computed = compute_group(group); !computed) return computed;
  }
  return {};
}

Result<void> ExplorationRun::compute_group(const std::vector<std::size_t>& group) {
  if (system_.wiring().is_loop(group)) return compute_loop(group);
  const std::size_t module = group.front();
  Result<Sequence> sequence = compute_module(module);
  if (sequence) {
    if (auto finite = check_finite(*sequence); !finite) sequence = fail(std::move(finite.error()));
  }
  if (!sequence) return fail(system_.at_module(std::move(sequence.error()), module));
  computed_[module] = std::make_shared<const Sequence>(std::move(*sequence));
  return {};
}

Result<Sequence> ExplorationRun::compute_module(std::size_t module) const {
  const Module& runs = *system_.modules()[module].module;
  try {
    if (const auto* source = dynamic_cast<const Source*>(&runs)) return source->read(*exploration_);
    return runs.run(inputs_of(module));
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::kSystem,
                fmt::format("there is not enough memory for its output of {}",
                            to_string(system_.modules()[module].output)),
                {}, "give it fewer elements");
  }
}

Result<void> ExplorationRun::compute_loop(const std::vector<std::size_t>& group) {
  FrameWalk walk(system_, group);
  auto started = walk.start([&](std::size_t module) { return find(module); });
  if (!started) return started;
  std::vector<std::vector<Signal>> outputs(group.size());
  for (std::size_t frame = 0; frame < walk.frames(); ++frame) {
    if (auto stepped = walk.step(); !stepped) return stepped;
    for (std::size_t i = 0; i < group.size(); ++i) outputs[i].push_back(walk.output(group[i]));
  }
  for (std::size_t i = 0; i < group.size(); ++i) {
    computed_[group[i]] =
        std::make_shared<const Sequence>(Sequence{Samples::from_signals(outputs[i]), walk.rate()});
  }
  return {};
}

std::vector<bool> needed_for(const System& system, const std::vector<bool>& wanted,
                             const std::function<bool(std::size_t)>& is_known) {
  std::vector<bool> needed(wanted.size(), false);
  std::vector<std::size_t> left;
  const auto need = [&](std::size_t module) {
    if (needed[module] || is_known(module)) return;
    needed[module] = true;
    left.push_back(module);
  };
  for (std::size_t module = 0; module < wanted.size(); ++module) {
    if (wanted[module]) need(module);
  }
  while (!left.empty()) {
    const std::size_t module = left.back();
    left.pop_back();
    for (const std::size_t input : system.modules()[module].inputs) need(input);
  }
  return needed;
}

}  // namespace somato
