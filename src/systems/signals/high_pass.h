#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "somato/core/parameter.h"

namespace somato {

/// Not in the papers, whose sensors do not drift.
struct HighPassParameters {
  double time_constant = 10.0;
  std::optional<double> rate;

  static const Declarations<HighPassParameters>& declarations();
};

/// First-order high-pass filter, which removes slow drift of a sensor: the discrete form of an RC
/// circuit whose capacitor is charged to the first frame. With the time constant T in seconds and
/// the frame rate f in frames per second, frame t of an exploration, counted from 1, becomes
///
///     y(1) = 0,   y(t) = a (y(t-1) + x(t) - x(t-1)),   a = T / (T + 1 / f),
///
/// element by element. A step of the input decays to the share a^n after n frames, which is about
/// exp(-n / (f T)); a ramp of slope s per second tends to the constant s T. The state is in double
/// precision.
class HighPass {
 public:
  /// Throws InvalidArgument for a time constant or rate that is not positive and finite.
  HighPass(std::size_t elements, double time_constant, double rate);

  /// The next frame, in place. Throws InvalidArgument for another number of elements.
  void step(std::span<float> frame);

 private:
  double keep_;  // a
  bool has_frame_ = false;
  std::vector<double> before_;  // x(t-1)
  std::vector<double> passed_;  // y(t-1)
};

}  // namespace somato
