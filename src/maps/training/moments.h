#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "somato/maps/som.h"
#include "somato/maps/som_training.h"

namespace somato {

/// Shows an observer the moments of one training.
class Moments {
 public:
  Moments(const TrainingObserver& observer, const Som& som, std::uint64_t steps)
      : observer_(observer), weights_(som.neurons() * som.elements().count()), steps_(steps) {}

  /// The first moment after `step` < steps.
  std::uint64_t next(std::uint64_t step) const {
    if (!observer_) return steps_;
    const std::uint64_t number = step * kMoments / steps_ + 1;
    return std::min(steps_, (number * steps_ + kMoments - 1) / kMoments);
  }

  /// Whether to stop after `step` of `total`; after those of the schedule every call is a moment.
  bool stop_after(std::uint64_t step, std::uint64_t total, double learning_rate, double radius,
                  const std::function<Som()>& map) const {
    if (!observer_ || (step <= steps_ && next(step - 1) != step)) return false;
    return !observer_({step, total, learning_rate, radius, weights_, map});
  }

 private:
  static constexpr std::uint64_t kMoments = 100;

  const TrainingObserver& observer_;
  std::size_t weights_;
  std::uint64_t steps_;
};

}  // namespace somato
