#pragma once

#include "somato/core/result.h"
#include "somato/core/signal.h"
#include "somato/graph/port.h"

namespace somato {

/// Refuses (kData) an output that left the range of single precision on its way: nothing after it
/// could say what went wrong.
Result<void> check_finite(const SignalView& output);

/// The same for every value of a sequence, with the number of the frame.
Result<void> check_finite(const Sequence& output);

}  // namespace somato
