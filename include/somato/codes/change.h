#pragma once

#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/core/signal.h"

namespace somato {

/// The last of `frames` (frames x elements) less the first: what an exploration changed, whatever
/// the sensors showed at rest. A dense signal of shape {elements}; zeros for a single frame.
///
/// Errors (kData): no frames.
Result<Signal> change_of(const Matrix<float>& frames);

}  // namespace somato
