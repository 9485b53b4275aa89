#pragma once

#include <chrono>

namespace somato::live {

/// The longest pause between two moments in s: nothing was recorded in a longer one.
inline constexpr double kLongestPause = 1.0;

/// Whether the display is playing, how fast, and when its next moment is due.
class Pace {
 public:
  using Clock = std::chrono::steady_clock;

  bool playing = false;
  double speed = 1.0;  ///< 1: as fast as it was.

  /// The moment that is shown begins now.
  void begin() { shown_at_ = Clock::now(); }

  /// The time at which the next moment is due that came so many seconds after this one.
  Clock::time_point due(double seconds) const;

  /// The next moment is shown, which was due then: a small delay is made up for, a large one not.
  void keep(Clock::time_point due);

 private:
  Clock::time_point shown_at_;  // or when it should have been
};

}  // namespace somato::live
