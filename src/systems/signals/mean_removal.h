#pragma once

#include "somato/core/matrix.h"

namespace somato {

/// `frames` (frames x elements) with each element's mean over the frames subtracted, so that what
/// stays is how an exploration varied, not where it lay. Means are summed in the order of the
/// frames, in double precision.
Matrix<float> mean_removed(Matrix<float> frames);

}  // namespace somato
