#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "views/replay/live_reader.h"
#include "views/replay/played_exploration.h"
#include "views/session/reading_sink.h"

namespace somato::live {

/// Passes on to a sink what a reader says after each moment of each exploration: each moment once
/// and in order, also if earlier moments are shown again. Used by one thread.
class ReadingTap {
 public:
  explicit ReadingTap(ReadingSink sink) : sink_(std::move(sink)) {}

  /// Whether something is passed on: a sink is given, and finish() was not called.
  bool is_open() const { return static_cast<bool>(sink_.on_done); }

  /// An exploration begins, or begins again.
  void begin(const PlayedExploration& played);

  /// The reader has followed the exploration for so many moments. The last moment of a whole
  /// exploration is followed by its end. A body's exploration is whole once it is explored, and may
  /// have other moments then: only its end is passed on.
  void say(const PlayedExploration& played, std::size_t moments, LiveReader& reader);

  /// The name that the exploration whose end was passed on is given, once; or nothing.
  std::optional<std::string> take_name() { return std::exchange(name_, std::nullopt); }

  /// The system has learned a name, or could not.
  void say_taught(const TaughtName& name);

  /// The system has forgotten a name that was taken back.
  void say_forgotten(const GivenName& name);

  /// An exploration has failed; others may follow.
  void say_failure(const Error& error) const;

  /// The file of the session cannot be written.
  void say_unsaved(const Error& error) const;

  /// All has been said, or an error ends it.
  void finish(const Result<void>& outcome);

  /// The number of explorations whose end was passed on.
  std::size_t ended() const { return ended_; }

 private:
  void note(std::size_t moments, double time);
  void end(const SaidReading& said, const PlayedExploration& played);
  void check(const Result<void>& taken);

  ReadingSink sink_;
  std::optional<std::size_t> index_;  // of the exploration
  bool has_grown_ = false;            // the exploration is that of a body
  bool is_whole_ = false;             // its end has been passed on
  std::size_t said_ = 0;              // moments
  double begun_ = 0.0;                // time of its first moment
  double time_ = 0.0;                 // s from there to the last one that was said
  std::size_t ended_ = 0;
  std::optional<std::string> name_;
};

}  // namespace somato::live
