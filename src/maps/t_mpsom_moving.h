#pragma once

#include <cstddef>
#include <span>

#include "somato/core/lane_matrix.h"
#include "somato/maps/t_mpsom_parameters.h"

namespace somato {

/// What weights move towards, and how far.
struct TMpsomMove {
  std::span<const float> sample;
  float squared_length = 0.0F;   ///< Of `sample`.
  std::span<const float> gains;  ///< In 0 .. 1, one a padded neuron, on a cache line.
  bool all_rows = false;         ///< Normalizes rows whose gains are zero, too.
};

/// w <- normalized(w + gain (x - w)) in each row: each row is read for its length to come, and read
/// and written once more while it is in the nearest cache. With the L2 norm rows of zeros stay so.
void move_weights(LaneMatrix<float>& weights, const TMpsomMove& move, TMpsomNorm norm);

/// The same of one row, in double precision, where nothing overflows; always with the L2 norm.
void move_row(LaneMatrix<float>& weights, std::size_t row, std::span<const float> sample,
              float gain);

}  // namespace somato
