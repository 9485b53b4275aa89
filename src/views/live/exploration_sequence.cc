#include "views/live/exploration_sequence.h"

namespace somato::live {

// The explorations of a demonstration were the first trial.
Result<void> ExplorationSequence::take_over() {
  if (is_planned() && !demonstrates()) {
    return fail(ErrorKind::kUsage, "the explorations of this session are fixed");
  }
  if (demonstrates()) trials_ = 1;
  demonstration_.end();
  plan_.clear();
  planned_ = 0;
  return {};
}

ExplorationSequence::Next ExplorationSequence::next() {
  if (!is_planned()) return {thing_, trials_++, placement_};
  const PlannedExploration& planned = plan_[planned_++];
  thing_ = planned.thing;
  return {planned.thing, planned.trial, {}};
}

}  // namespace somato::live
