#include "systems/walk/walk_plan.h"

#include <algorithm>
#include <utility>

#include "base/core/contains.h"
#include "systems/graph/wiring.h"

namespace somato {
namespace {

const Module& module_of(const System& system, std::size_t module) {
  return *system.modules()[module].module;
}

bool is_source(const System& system, std::size_t module) {
  return system.modules()[module].inputs.empty();
}

Rate rate_into(const System& system, std::size_t module) {
  if (is_source(system, module)) return Rate::kFrame;
  return system.modules()[system.modules()[module].inputs.front()].output.rate;
}

// The dependencies of `wanted`, including themselves, unless they are known.
std::vector<bool> needed_for(const System& system, const std::vector<std::size_t>& wanted,
                             const std::vector<bool>& known) {
  std::vector<bool> needed(known.size(), false);
  std::vector<std::size_t> left;
  const auto need = [&](std::size_t module) {
    if (needed[module] || known[module]) return;
    needed[module] = true;
    left.push_back(module);
  };
  for (const std::size_t module : wanted) need(module);
  while (!left.empty()) {
    const std::size_t module = left.back();
    left.pop_back();
    for (const std::size_t input : system.modules()[module].inputs) need(input);
  }
  return needed;
}

}  // namespace

WalkPlan::WalkPlan(const System& system, const std::vector<std::size_t>& wanted, Outputs outputs,
                   const std::function<bool(std::size_t)>& is_known)
    : system_(system), known_(system.modules().size(), false), roles_(system.modules().size()) {
  for (std::size_t module = 0; is_known && module < known_.size(); ++module) {
    known_[module] = is_known(module);
  }
  const std::vector<bool> needed = needed_for(system, wanted, known_);
  for (const auto& group : system.wiring().groups()) {
    if (needed[group.front()]) add(group);
  }
  for (const std::size_t module : wanted) roles_[module].is_kept = outputs == Outputs::kAll;
  for (const Part& part : parts_) keep_inputs_of(part);
}

void WalkPlan::add(const std::vector<std::size_t>& modules) {
  Part part{modules, {}, false, rate_into(system_, modules.front()) == Rate::kFrame, 0};
  for (auto module = modules.begin(); module != modules.end(); ++module) {
    roles_[*module].is_walked = true;
    for (const std::size_t input : system_.modules()[*module].inputs) {
      if (!contains(part.modules, input)) part.outer_input = input;
      const bool later = std::find(module, modules.end(), input) != modules.end();
      roles_[*module].delays_loop = roles_[*module].delays_loop || later;
    }
  }
  part.advances = advances(part);
  part.group = part.advances ? stream_of(part) : roles_.size() + parts_.size();
  for (const std::size_t module : modules) roles_[module].group = part.group;
  parts_.push_back(std::move(part));
}

bool WalkPlan::advances(const Part& part) const {
  const auto comes_with_frames = [&](std::size_t input) {
    const bool in_time =
        contains(part.modules, input) || known_[input] || roles_[input].group < clocks_.size();
    return system_.modules()[input].output.rate == Rate::kFrame && in_time;
  };
  return std::all_of(part.modules.begin(), part.modules.end(), [&](std::size_t module) {
    const std::vector<std::size_t>& inputs = system_.modules()[module].inputs;
    return module_of(system_, module).is_stepped() &&
           std::all_of(inputs.begin(), inputs.end(), comes_with_frames);
  });
}

// Frames that are taken together come in together.
std::size_t WalkPlan::stream_of(const Part& part) {
  const std::string& clock =
      system_.modules()[part.outer_input.value_or(part.modules.front())].output.clock;
  const auto known = std::find(clocks_.begin(), clocks_.end(), clock);
  const auto stream = static_cast<std::size_t>(known - clocks_.begin());
  if (known == clocks_.end()) clocks_.push_back(clock);
  return stream;
}

// Modules that run in settle() need all frames, and a module on explorations all values.
void WalkPlan::keep_inputs_of(const Part& part) {
  if (part.advances) return;
  for (const std::size_t module : part.modules) {
    const bool is_whole = !module_of(system_, module).is_stepped();
    for (const std::size_t input : system_.modules()[module].inputs) {
      const bool frames = system_.modules()[input].output.rate == Rate::kFrame;
      if (!contains(part.modules, input) && (frames || is_whole)) roles_[input].is_kept = true;
    }
  }
}

bool WalkPlan::is_costly() const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [](const Part& part) { return !part.advances && part.takes_frames; });
}

}  // namespace somato
