#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

namespace somato {

/// The mean and the spread of the finite values among those that are added; Welford's updates,
/// because values may be large and their differences small.
class MeanAndSpread {
 public:
  void add(double value) {
    if (!std::isfinite(value)) return;
    ++count_;
    const double before = value - mean_;
    mean_ += before / static_cast<double>(count_);
    squares_ += before * (value - mean_);
  }
  std::size_t count() const { return count_; }
  /// NaN without values.
  double mean() const { return count_ > 0 ? mean_ : std::numeric_limits<double>::quiet_NaN(); }
  /// The sum of the squared differences from the mean.
  double squares() const { return squares_; }
  double variance() const {
    return count_ > 0 ? squares_ / static_cast<double>(count_)
                      : std::numeric_limits<double>::quiet_NaN();
  }
  double deviation() const { return std::sqrt(variance()); }

 private:
  std::size_t count_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;
};

}  // namespace somato
