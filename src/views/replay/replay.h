#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "views/http/event_hub.h"
#include "views/replay/live_reader.h"
#include "views/replay/pace.h"
#include "views/replay/played_exploration.h"
#include "views/replay/reading_tap.h"
#include "views/session/view_json.h"

namespace somato::live {

struct BodyStep;

/// Shows the moments of an exploration, forwards and back, and what the chosen system makes of
/// them. Used by one thread.
class Replay {
 public:
  /// `pace` says whether a moment will be followed by the next one; `readings` receives what the
  /// system says.
  Replay(EventHub& hub, const Pace& pace, ReadingSink readings = {})
      : hub_(hub), pace_(pace), tap_(std::move(readings)) {}

  /// Begins an exploration at its first moment; it must live until another begins, or end().
  void begin(PlayedExploration played);

  /// Shows nothing any more.
  void end();

  /// The exploration that was played while it grew has ended with the last moment: the receiver of
  /// the readings is informed.
  void say_end();

  /// Shows a moment. The system's memory depends on every moment before, so that this may
  /// take long: it ends early, and is_behind() holds until follow() has shown the moment. Once the
  /// first moments are no longer kept, there is no reading of earlier moments.
  void show(std::size_t moment);

  bool is_behind() const { return wanted_.has_value(); }

  /// Follows the exploration to the moment that is to be shown, but works no longer than
  /// `patience`: it does not count while the processor does other things.
  void follow(std::chrono::milliseconds patience);

  /// Leaves it at the moment that is shown.
  void give_up() { wanted_.reset(); }

  /// Shows a step of the body after the last moment, which is not recorded itself.
  void show_between(const BodyStep& step);

  /// See LiveReader.
  void limit_memory(std::size_t most) { reader_.limit_memory(most); }

  /// Chooses the system that reads, or none with nullptr, and shows the moment again.
  void choose(const ViewSystem* system, const std::optional<RecordingLayout>& layout);

  const LiveReader& reader() const { return reader_; }

  ReadingTap& tap() { return tap_; }
  const ReadingTap& tap() const { return tap_; }

  /// The exploration that is played; nullptr without one.
  const PlayedExploration* played() const { return played_ ? &*played_ : nullptr; }

  /// The number of moments, and the first that is kept.
  std::size_t first() const { return played_ ? played_->timeline->first() : 0; }
  std::size_t moments() const { return played_ ? played_->timeline->moments() : 0; }

  /// The moment to come.
  std::size_t next() const { return next_; }
  bool is_over() const { return next_ >= moments(); }

  /// Seconds from the moment that is shown to the next one.
  double pause() const;

 private:
  void publish_scene() const;
  std::size_t frames(std::size_t channel, std::size_t moments) const;
  std::size_t kept_frames(std::size_t channel, std::size_t moments) const;
  ShownMoment shown_after(std::size_t moments) const;
  void publish_moment(std::size_t moment);
  void publish(const ShownMoment& shown);

  EventHub& hub_;
  const Pace& pace_;
  ReadingTap tap_;
  LiveReader reader_;
  std::optional<PlayedExploration> played_;
  std::size_t next_ = 0;
  std::size_t followed_ = 0;           // moments
  std::optional<std::size_t> wanted_;  // the moment to be shown once all before is followed
};

}  // namespace somato::live
