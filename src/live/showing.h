#pragma once

#include <functional>
#include <string>
#include <utility>

#include "live/event_hub.h"
#include "live/narrator.h"
#include "live/pace.h"
#include "live/view_json.h"
#include "live/view_state.h"

namespace somato::live {

/// What is before everybody's eyes: its pace, what the chosen system says of it, and the telling of
/// both. Used by one thread.
class Showing {
 public:
  /// `changed` is called when there is a new state to be told.
  Showing(EventHub& hub, std::function<void()> changed) : hub_(hub), changed_(std::move(changed)) {}

  Pace pace;
  Narrator narrator;

  /// Tells a moment; `so_far` makes the exploration up to there.
  void frame(const ShownMoment& moment, const std::function<Exploration()>& so_far);

  /// Tells a scene, or with nullptr that there is none, unless it is told already.
  void scene(const Scene* scene);

  /// Tells the state.
  void state(const ViewState& state);

  /// Has the state told.
  void change() { changed_(); }

 private:
  EventHub& hub_;
  std::function<void()> changed_;
  std::string told_problem_;  // of the system, in the last state
};

}  // namespace somato::live
