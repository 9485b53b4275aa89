#pragma once

#include <chrono>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "views/session/system_reading.h"
#include "views/session/view_source.h"
#include "views/session/viewed_system.h"

namespace somato::live {

/// Evaluates a growing exploration with the selected system; used by one thread.
class LiveReader {
 public:
  /// The most memory of the frames that modules store, in bytes, from the next choice on.
  void limit_memory(std::size_t most) { most_memory_ = most; }

  /// Chooses a system, or none with nullptr; it then goes to the start.
  void choose(const ViewSystem* system, const std::optional<RecordingLayout>& layout);

  /// Goes to the start of an exploration.
  void start();

  /// Follows the exploration until the channels have given so many frames each, of which the first
  /// `dropped` are no longer there.
  void follow(const Exploration& exploration, const std::vector<std::size_t>& frames,
              const std::vector<std::size_t>& dropped);

  /// There is no reading of this exploration: its beginning is no longer kept.
  void give_up();

  /// The present reading, or nullptr; if reading is costly, it is the reading of up to a quarter of
  /// a second ago, or ten times as long as it took to say, unless it is wanted `now`. Nothing is
  /// computed twice for the same frames.
  const Reading* read(bool now);

  /// The reading that was computed last for this exploration, or nullptr.
  const Reading* latest() const { return latest_ ? &*latest_ : nullptr; }

  const SystemModel* model() const { return reading_ ? &reading_->model() : nullptr; }
  const SystemPicture& picture() const { return picture_; }

  /// Why there is nothing to say, a sentence; empty without a reason.
  const std::string& problem() const { return problem_; }

  /// The error with which following an exploration ended, if any.
  const std::optional<Error>& error() const { return error_; }

 private:
  using Clock = std::chrono::steady_clock;

  void keep(const Error& error);

  SystemPicture picture_;
  std::string problem_;
  std::unique_ptr<SystemReading> reading_;
  std::size_t most_memory_ = std::numeric_limits<std::size_t>::max();
  std::optional<Error> error_;
  std::optional<Reading> latest_;
  bool is_said_ = false;  // latest_ is of all that was followed
  Clock::time_point said_at_;
  Clock::duration took_{};
};

}  // namespace somato::live
