#pragma once

#include <algorithm>
#include <cmath>

namespace somato::devices {

/// The speed at which a servo is sent to its goal, which each tick moves a little. A servo lags
/// behind: if the goal rests, the servo must go on at the speed of the goals before, and not creep.
class GoalSpeed {
 public:
  /// The speed towards `goal`, `seconds` after `last_goal`, of a servo that was last seen at
  /// `position` (NaN: unknown), per second: that of the goal, or that of the last call, if it is
  /// higher and the servo is not yet there. Never above the speed that the goal once had.
  double next(double goal, double last_goal, double position, double seconds) {
    constexpr double kShortest = 1e-3;  // s
    const double duration = std::max(seconds, kShortest);
    const double left = std::isfinite(position) ? std::abs(goal - position) / duration : 0.0;
    speed_ = std::max(std::abs(goal - last_goal) / duration, std::min(left, speed_));
    return speed_;
  }

 private:
  double speed_ = 0.0;
};

}  // namespace somato::devices
