#pragma once

#include "somato/core/signal.h"

namespace somato {

/// The greatest length of a sample as a map takes it: distances are summed in single precision, and
/// beyond its range every winner would be the first.
inline constexpr double kLongestSample = 1e18;

/// Whether a sample is not longer than that; one with a value that is not finite is.
bool is_in_range(const SignalView& prepared);

}  // namespace somato
