#pragma once

// Scores of a whole map for a few inputs at once, by distances that do not follow from inner
// products. Vector lanes run over neurons; sums are taken in the order of kernels.h, so every
// instruction set and every number of inputs gives the same bits.

#include <cstddef>

#include "base/kernels/kernels.h"

namespace somato::kernels {

/// At most so many inputs are compared at once.
inline constexpr std::size_t kInputsTogether = 4;

/// Each kernel writes the scores of input i, of which there are `count` (1 to kInputsTogether), to
/// out[i], which has a value for each padded row and starts on a cache line.
struct DistanceTable {
  /// The sum over columns of |x - w|.
  void (*absolute)(Lanes<const float> w, const float* const* x, std::size_t count,
                   float* const* out);
  /// The greatest |x - w| of all columns.
  void (*greatest)(Lanes<const float> w, const float* const* x, std::size_t count,
                   float* const* out);
  /// The sum over columns of (x - w)^2.
  void (*squares)(Lanes<const float> w, const float* const* x, std::size_t count,
                  float* const* out);
  /// The sum over columns of w * x.
  void (*products)(Lanes<const float> w, const float* const* x, std::size_t count,
                   float* const* out);
};

/// The kernels of the instruction set in use.
const DistanceTable& distance_table();

}  // namespace somato::kernels
