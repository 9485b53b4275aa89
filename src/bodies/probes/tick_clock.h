#pragma once

#include <cmath>
#include <cstdint>

namespace somato::detail {

/// Time in ticks of a fixed length, however callers cut it into steps.
class TickClock {
 public:
  explicit TickClock(double rate) : rate_(rate) {}

  /// Advances by `seconds`; returns the number of ticks that are due.
  std::int64_t pass(double seconds) {
    time_ += seconds;
    const std::int64_t due = std::llround(time_ * rate_) - ticks_;
    ticks_ += due;
    return due;
  }

  double time() const { return time_; }

 private:
  double rate_;
  double time_ = 0.0;
  std::int64_t ticks_ = 0;
};

}  // namespace somato::detail
