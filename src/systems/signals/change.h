#pragma once

#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/core/signal.h"

namespace somato {

/// The last of `frames` (frames x elements) minus the first: the change during an exploration,
/// independent of the readings at rest. A dense signal of shape {elements}; zeros for a single
/// frame.
///
/// Errors (kData): no frames.
Result<Signal> change_of(const Matrix<float>& frames);

}  // namespace somato
