#include "systems/graph/phase_plan.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "base/core/contains.h"
#include "systems/graph/wiring.h"

namespace somato {
namespace {

tl::unexpected<Error> refuse(const PhaseDescription& phase, std::string what, std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), phase.where, std::move(advice));
}

class Planner {
 public:
  explicit Planner(const System& system) : system_(system), planned_(system.modules().size()) {}

  Result<std::vector<Phase>> plan() {
    SOMATO_TRY(const auto named, find_named());
    for (std::size_t i = 0; i < named.size(); ++i) {
      SOMATO_TRY_VOID(add(system_.description().phases[i], named[i], named));
    }
    for (const std::size_t module : in_order()) {
      if (!learns(module) || planned_[module]) continue;
      SOMATO_TRY_VOID(add_own(module));
    }
    return std::move(phases_);
  }

 private:
  bool learns(std::size_t module) const {
    return system_.modules()[module].module->learner() != nullptr;
  }
  Learner& learner(std::size_t module) const {
    return *system_.modules()[module].module->learner();
  }
  const std::string& name(std::size_t module) const { return system_.modules()[module].name; }

  std::vector<std::size_t> in_order() const {
    std::vector<std::size_t> order;
    for (const auto& group : system_.wiring().groups()) {
      order.insert(order.end(), group.begin(), group.end());
    }
    return order;
  }

  // The learners of each phase of the description, in the order in which they run.
  Result<std::vector<std::vector<std::size_t>>> find_named() const {
    std::vector<std::vector<std::size_t>> named;
    std::vector<std::size_t> all;
    for (const PhaseDescription& phase : system_.description().phases) {
      if (phase.learn.empty()) {
        return refuse(phase, "'learn' is missing or empty", "write learn = [\"NAME\", ...]");
      }
      named.emplace_back();
      for (const std::string& module_name : phase.learn) {
        SOMATO_TRY(const auto module, system_.find(module_name, phase.where));
        if (!learns(module)) {
          return refuse(phase, "'" + module_name + "' has nothing to learn",
                        "remove it from 'learn'");
        }
        if (contains(all, module)) {
          return refuse(phase, "'" + module_name + "' is listed twice",
                        "list each module once in all phases");
        }
        all.push_back(module);
        named.back().push_back(module);
      }
      sort_as_run(named.back());
    }
    return named;
  }

  void sort_as_run(std::vector<std::size_t>& learners) const {
    const std::vector<std::size_t> order = in_order();
    std::sort(learners.begin(), learners.end(), [&](std::size_t a, std::size_t b) {
      return std::find(order.begin(), order.end(), a) < std::find(order.begin(), order.end(), b);
    });
  }

  // Modules that the learners depend on learn before them: in a separate phase if no phase names
  // them.
  Result<void> add(const PhaseDescription& description, const std::vector<std::size_t>& learners,
                   const std::vector<std::vector<std::size_t>>& named) {
    for (const std::size_t before : in_order()) {
      if (!learns(before) || planned_[before] || contains(learners, before)) continue;
      for (const std::size_t after : learners) {
        if (!system_.wiring().reaches(before, after)) continue;
        const bool later = std::any_of(named.begin(), named.end(),
                                       [&](const auto& phase) { return contains(phase, before); });
        if (later) {
          return refuse(
              description,
              "'" + name(after) + "' learns before '" + name(before) + "', which it depends on",
              "put the phase of '" + name(before) + "' first, or name both in one phase");
        }
        SOMATO_TRY_VOID(add_own(before));
        break;
      }
    }
    return add_phase({learners, description.draws, description.order, Rate::kExploration},
                     description);
  }

  Result<void> add_own(std::size_t module) {
    return add_phase({{module}, {}, {}, Rate::kExploration},
                     PhaseDescription{{}, {}, {}, {}, system_.modules()[module].where});
  }

  Result<void> add_phase(Phase phase, const PhaseDescription& description) {
    SOMATO_TRY_VOID(check_ready(phase, description));
    SOMATO_TRY_VOID(find_rate(phase, description));
    SOMATO_TRY_VOID(check_learners(phase, description));
    SOMATO_TRY_VOID(check_said_once(phase));
    for (const std::size_t module : phase.learners) planned_[module] = true;
    phases_.push_back(std::move(phase));
    return {};
  }

  // In a loop each module depends on all others.
  Result<void> check_ready(const Phase& phase, const PhaseDescription& description) const {
    for (std::size_t before = 0; before < planned_.size(); ++before) {
      if (!learns(before) || planned_[before] || contains(phase.learners, before)) continue;
      for (const std::size_t after : phase.learners) {
        if (!system_.wiring().reaches(before, after)) continue;
        return refuse(description,
                      "'" + name(after) + "' and '" + name(before) + "' depend on each other",
                      "list both in one [[phase]]");
      }
    }
    return {};
  }

  Rate rate_of(std::size_t module) const {
    return system_.modules()[system_.modules()[module].inputs.front()].output.rate;
  }

  const std::string& clock_of(std::size_t module) const {
    return system_.modules()[system_.modules()[module].inputs.front()].output.clock;
  }

  Result<void> find_rate(Phase& phase, const PhaseDescription& description) const {
    phase.of = rate_of(phase.learners.front());
    for (const std::size_t module : phase.learners) {
      if (rate_of(module) == phase.of) {
        if (clock_of(module) == clock_of(phase.learners.front())) continue;
        return refuse(description,
                      "'" + name(phase.learners.front()) + "' and '" + name(module) +
                          "' cannot learn together, because their frames are not recorded together",
                      "use a separate phase for each");
      }
      return refuse(description,
                    "'" + name(phase.learners.front()) + "' and '" + name(module) +
                        "' cannot learn together, because one learns from frames and the other "
                        "from explorations",
                    "use a separate phase for each");
    }
    if (!description.of || *description.of == phase.of) return {};
    if (*description.of == Rate::kFrame) {
      phase.of = Rate::kFrame;
      phase.settles = true;
      return {};
    }
    return refuse(description,
                  "'" + name(phase.learners.front()) + "' learns " + choice_name(phase.of) +
                      ", not " + choice_name(*description.of),
                  "write of = \"" + choice_name(phase.of) + "\", or remove 'of'");
  }

  Result<void> check_learners(const Phase& phase, const PhaseDescription& description) const {
    if (learns_separately(system_, phase)) return check_separate(phase, description);
    for (const std::size_t module : phase.learners) {
      if (learner(module).learns_by_draws()) continue;
      return refuse(
          description,
          "'" + name(module) + "' learns from all samples at once, which it cannot do " +
              (phase.learners.size() > 1 ? "together with other modules" : "here"),
          phase.learners.size() > 1
              ? "remove it from this phase; it then learns before the modules that depend on it"
              : "reduce its input to one value per exploration, and remove it from loops");
    }
    if (phase.learners.size() > 1 && !phase.draws) {
      return refuse(description, "the phase does not specify how long its modules learn",
                    "write draws = ...");
    }
    return check_between(phase, description);
  }

  // A setting of a phase cannot be set in its modules as well; and if a phase draws, its modules do
  // not.
  Result<void> check_said_once(const Phase& phase) const {
    for (const std::size_t module : phase.learners) {
      const bool phase_draws = !learns_separately(system_, phase);
      for (const auto& [key, of_phase, elsewhere] :
           {std::tuple{"iterations", "draws", phase.draws.has_value()},
            std::tuple{"draws", "order", phase.order.has_value() || phase_draws}}) {
        const Table::Entry* entry = system_.description().modules[module].settings.find(key);
        if (!elsewhere || !entry) continue;
        return fail(system_.at_module(
            without_effect(key, std::string("it is set by its [[phase]], as '") + of_phase + "'",
                           entry->where),
            module));
      }
    }
    return {};
  }

  Result<void> check_separate(const Phase& phase, const PhaseDescription& description) const {
    if (learner(phase.learners.front()).learns_by_draws()) return {};
    if (!description.draws && !description.order) return {};
    return refuse(
        description,
        "'" + name(phase.learners.front()) + "' learns from all samples at once, without draws",
        "remove 'draws' and 'order'");
  }

  // Frames are computed one after the other, so that no module in between may require them all.
  Result<void> check_between(const Phase& phase, const PhaseDescription& description) const {
    if (phase.of == Rate::kExploration) return {};
    for (const std::size_t module : computed_in(system_, phase)) {
      if (system_.modules()[module].module->is_stepped()) continue;
      return refuse(
          description,
          "'" + name(module) +
              (phase.settles ? "' requires whole explorations, so that '" +
                                   name(phase.learners.front()) + "' cannot learn from frames"
                             : "' requires whole explorations, so the modules before "
                               "and after it cannot learn from frames together"),
          phase.settles ? "remove 'of'" : "use a separate phase for each");
    }
    return {};
  }

  const System& system_;
  std::vector<bool> planned_;
  std::vector<Phase> phases_;
};

}  // namespace

Result<std::vector<Phase>> plan_phases(const System& system) {
  return Planner(system).plan();
}

std::vector<std::size_t> computed_in(const System& system, const Phase& phase) {
  const Wiring& wiring = system.wiring();
  const auto is_near = [&](std::size_t module, bool after) {
    return std::any_of(phase.learners.begin(), phase.learners.end(), [&](std::size_t learner) {
      return learner == module ||
             (after ? wiring.reaches(learner, module) : wiring.reaches(module, learner));
    });
  };
  const auto is_value = [&](std::size_t module) {
    return phase.settles && system.modules()[module].output.rate == Rate::kExploration;
  };
  std::vector<std::size_t> computed;
  for (const auto& group : wiring.groups()) {
    for (const std::size_t module : group) {
      const bool is_after = is_near(module, true) || is_value(module);
      if (is_after && is_near(module, false)) computed.push_back(module);
    }
  }
  return computed;
}

bool learns_separately(const System& system, const Phase& phase) {
  const std::size_t module = phase.learners.front();
  return phase.learners.size() == 1 && !phase.settles &&
         system.modules()[module].module->learner()->learns_at_once() &&
         !system.wiring().reaches(module, module);
}

}  // namespace somato
