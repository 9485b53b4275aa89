#pragma once

#include <cstddef>

#include "somato/core/matrix.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"

namespace somato {

/// The parameters of a resampling.
struct ResamplingParameters {
  std::size_t points = 10;

  static const Declarations<ResamplingParameters>& declarations();
};

/// `frames` (frames x elements) as `points` frames, evenly spread from the first to the last and
/// interpolated linearly between neighbours, so that explorations of any length become vectors of
/// one length. First and last frame are kept as they are; a single frame is repeated. Output:
/// points x elements.
///
/// Errors (kData): no frames. Throws InvalidArgument for fewer than 2 points.
Result<Matrix<float>> resampled(const Matrix<float>& frames,
                                const ResamplingParameters& parameters);

}  // namespace somato
