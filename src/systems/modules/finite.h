#pragma once

#include "somato/core/result.h"
#include "somato/core/signal.h"
#include "somato/graph/module.h"

namespace somato {

/// Refuses (kData) an output outside the range of single precision, because later modules could not
/// report the cause.
Result<void> check_finite(const SignalView& output);

/// The same for every value of a sequence, with the number of the frame.
Result<void> check_finite(const Sequence& output);

}  // namespace somato
