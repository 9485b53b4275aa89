#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "views/http/audience.h"
#include "views/http/event_hub.h"
#include "views/live/chosen_system.h"
#include "views/replay/pace.h"
#include "views/replay/replay.h"
#include "views/session/view_source.h"
#include "views/teaching/kept_explorations.h"

namespace somato::live {

/// The parts of a session that Playback, BodySession and Naming share. Used by the thread of the
/// player.
struct Stage {
  /// `hub` must outlive it.
  Stage(ViewSource viewed, const ViewSettings& settings, EventHub& hub);
  Stage(const Stage&) = delete;
  Stage(Stage&&) = delete;
  Stage& operator=(const Stage&) = delete;
  Stage& operator=(Stage&&) = delete;
  ~Stage() = default;

  /// Begins to play a kept exploration.
  void begin_exploration(std::size_t index);
  void begin_exploration(std::size_t index, std::shared_ptr<const Timeline> timeline);

  /// Nothing plays any more.
  void rest();

  ViewSource source;
  Pace pace;
  Replay replay;
  ChosenSystem chosen;
  KeptExplorations kept;
  Audience audience;
  std::string problem;                    ///< The last one, a sentence; or empty.
  std::size_t moments_left = 0;           ///< To be shown though nothing plays.
  std::function<void()> publish = [] {};  ///< Publishes the state.
};

/// The error of a command that cannot be done now.
inline tl::unexpected<Error> not_now(std::string what) {
  return fail(ErrorKind::kUsage, std::move(what));
}

}  // namespace somato::live
