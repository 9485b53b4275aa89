#include "live/showing.h"

namespace somato::live {

void Showing::frame(const ShownMoment& moment, const std::function<Exploration()>& so_far) {
  const Saying* saying = narrator.say(moment.last || !pace.playing, so_far);
  hub_.publish(EventKind::kFrame, frame_text(moment, narrator.model(), saying));
  if (narrator.problem() != told_problem_) change();
}

void Showing::scene(const Scene* scene) {
  std::string text = scene != nullptr ? json_text(scene_json(*scene)) : "null";
  const EventHub::Text before = hub_.latest(EventKind::kScene);
  if (!before || *before != text) hub_.publish(EventKind::kScene, std::move(text));
}

void Showing::state(const ViewState& state) {
  told_problem_ = state.system_problem;
  hub_.publish(EventKind::kState, json_text(state_json(state)));
}

}  // namespace somato::live
