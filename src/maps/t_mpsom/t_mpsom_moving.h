#pragma once

#include <cstddef>
#include <span>

#include "base/kernels/t_mpsom_kernels.h"
#include "somato/core/matrix.h"
#include "somato/maps/t_mpsom.h"

namespace somato {

/// The target of weights, and the step towards it.
struct TMpsomMove {
  std::span<const float> sample;
  float squared_length = 0.0F;   ///< The squared length of `sample`.
  std::span<const float> gains;  ///< In 0 .. 1, one a padded neuron, on a cache line.
  bool all_rows = false;         ///< Normalizes rows whose gains are zero, too.
};

/// w <- normalized(w + gain (x - w)) in each row: each row is read for its length to come, and read
/// and written once more while it is in the nearest cache. With the L2 norm rows of zeros stay so.
void move_weights(LaneMatrix<float>& weights, const TMpsomMove& move, TMpsomNorm norm);

/// A few blocks of rows, from the row `first` on.
struct TMpsomRows {
  std::size_t first = 0;
  std::size_t blocks = 0;
};

/// Moves the rows that `moves` marks as doubtful in double precision, where nothing overflows,
/// always with the L2 norm; what is left in `moves` keeps them as they are. `gains` and `moves`
/// begin at the first of the rows.
void move_doubtful_rows(LaneMatrix<float>& weights, const TMpsomRows& rows,
                        std::span<const float> sample, const float* gains,
                        const kernels::Moves& moves);

}  // namespace somato
