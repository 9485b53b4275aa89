#pragma once

// Inner loops of learning one input after the other. As with the other kernels every instruction
// set gives the same bits (kernels.h).

#include <cstddef>

namespace somato::kernels {

/// So many updates are put off and then made in one pass over the weights.
inline constexpr std::size_t kPending = 16;

/// The kernels. A tile is some columns of one block of rows (LaneMatrix). Inputs are
/// given column by column: element c of input j stands at inputs[c * kPending + j]. Pointers start
/// on a cache line, but for those to inputs.
struct OnlineTable {
  /// sums[j * stride + lane] += sum over columns of w * input j, for `count` inputs.
  void (*multiply)(const float* tile, std::size_t columns, const float* inputs, std::size_t count,
                   float* sums, std::size_t stride);
  /// to = kept * w + sum over `count` (at least 1) inputs of gains_j * input j in order, then 0
  /// where its magnitude is below `limit`; squares += to^2. `kept` and `squares` have a value a
  /// lane, `gains` one for each input and lane.
  void (*combine)(const float* tile, std::size_t columns, const float* kept, const float* gains,
                  const float* inputs, std::size_t count, float limit, float* to, float* squares);
  /// sums = sum over columns of w * input, for some blocks of rows: what multiply() gives, called
  /// for one chunk of `chunk` columns after the other.
  void (*multiply_blocks)(const float* const* weights, std::size_t blocks, std::size_t columns,
                          std::size_t chunk, const float* input, float* sums);
  /// row += x * factors; change += the new squares less the old ones.
  void (*move_row)(float* row, float x, const float* factors, std::size_t count, double* change);
  /// row *= factors, then 0 where its magnitude is below kNegligible; squares += row^2.
  void (*fold_row)(float* row, const float* factors, std::size_t count, double* squares);
};

/// The kernels of the instruction set in use.
const OnlineTable& online_table();

}  // namespace somato::kernels
