#pragma once

#include <optional>

#include "somato/core/result.h"
#include "views/live/body_session.h"
#include "views/live/naming.h"
#include "views/live/stage.h"
#include "views/replay/pace.h"
#include "views/session/view_command.h"

namespace somato::live {

/// Shows one moment after the other: of kept explorations, and of the one that a body makes. Used
/// by the thread of the player.
class Playback {
 public:
  /// All of these must outlive it. A demonstration shows each result for `result_pause` seconds.
  Playback(Stage& stage, Naming& naming, BodySession& body, double result_pause)
      : stage_(stage), naming_(naming), body_(body), result_pause_(result_pause) {}

  /// The time at which the next moment, step of the body or exploration is to be shown; never while
  /// all rests.
  std::optional<Pace::Clock::time_point> due() const;

  /// Shows what is due.
  void advance();

  /// Commands of viewers. Errors (kUsage): an impossible command.
  Result<void> play();
  Result<void> step(std::int64_t frames);
  Result<void> seek(const SeekCommand& seek);

  /// Begins to play with the first viewer where that was waited for. A recording and a
  /// demonstration then rest while there are no viewers.
  void on_viewers(std::size_t viewers);

 private:
  void begin_seen();
  void play_next();
  void play_next_of_demonstration();
  double pause_after_result() const;

  Stage& stage_;
  Naming& naming_;
  BodySession& body_;
  double result_pause_;  // s
};

}  // namespace somato::live
