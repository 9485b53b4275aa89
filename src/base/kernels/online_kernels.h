#pragma once

// Inner loops of learning one input after the other. As with the other kernels every instruction
// set gives the same bits (kernels.h).

#include <cstddef>
#include <cstdint>

namespace somato::kernels {

/// So many updates are put off and then made in one pass over the weights.
inline constexpr std::size_t kPending = 16;

/// Values of which row j starts at first + j * stride.
struct InputRows {
  const float* first;
  std::size_t stride;
};

/// The kernels. A tile is some columns of one block of rows (LaneMatrix). Rows of weights, of which
/// there are some, have `count` lanes, whole blocks. Pointers start on a cache line, but for those
/// to inputs and values.
struct OnlineTable {
  /// sums[j * stride + lane] += sum over columns of w * input j, for `count` inputs.
  void (*multiply)(const float* tile, std::size_t columns, InputRows inputs, std::size_t count,
                   float* sums, std::size_t stride);
  /// The same for a tile of integers.
  void (*multiply_integers)(const std::int16_t* tile, std::size_t columns, InputRows inputs,
                            std::size_t count, float* sums, std::size_t stride);
  /// to = kept * w + sum over `count` (1 to kPending) inputs of gains_j * input j in order, then 0
  /// where its magnitude is below `limit`; squares += to^2. `kept` and `squares` have a value a
  /// lane, `gains` one for each input and lane.
  void (*combine)(const float* tile, std::size_t columns, const float* kept, const float* gains,
                  InputRows inputs, std::size_t count, float limit, float* to, float* squares);
  /// The same of a single neuron's weights in a row, of whole blocks, as are the inputs.
  void (*combine_row)(float* row, std::size_t columns, float kept, const float* gains,
                      InputRows inputs, std::size_t count, float limit);
  /// sums = sum over columns of w * input: what multiply() gives, called for one chunk of `chunk`
  /// columns after the other. A tile of all columns.
  void (*multiply_block)(const float* tile, std::size_t columns, std::size_t chunk,
                         const float* input, float* sums);
  /// The same for a tile of integers.
  void (*multiply_block_of_integers)(const std::int16_t* tile, std::size_t columns,
                                     std::size_t chunk, const float* input, float* sums);
  /// sums[j] = row j . x for `number` rows, summed in chunks as in multiply_block().
  void (*multiply_rows)(InputRows rows, std::size_t number, const float* x, std::size_t columns,
                        std::size_t chunk, float* sums);
  /// The same of whole blocks of columns, summed in lanes: faster, with no more roundings where
  /// there are more than kChunk columns.
  void (*multiply_long_rows)(InputRows rows, std::size_t number, const float* x,
                             std::size_t columns, float* sums);
  /// to = w * factors, which must be in range, rounded to the nearest integer (even where two are
  /// as near); greatest = the greatest magnitude of w and of what it was. Both have a value a lane.
  void (*round_tile)(const float* tile, std::size_t columns, const float* factors, std::int16_t* to,
                     float* greatest);
  /// sums += the sum of values * rows, one row after the other.
  void (*add_rows)(const float* const* rows, const float* values, std::size_t number,
                   std::size_t count, double* sums);
  /// Each row += its value * factors; change += the new squares less the old ones, one row after
  /// the other.
  void (*move_rows)(float* const* rows, const float* values, std::size_t number,
                    const float* factors, std::size_t count, double* change);
  /// row *= factors, then 0 where its magnitude is below kNegligible; squares += row^2.
  void (*fold_row)(float* row, const float* factors, std::size_t count, double* squares);
  /// to = scales * row, 0 where its magnitude is below kNegligible, rounded once; a block of
  /// `to` starts `stride` after the one before.
  void (*scale_row)(const float* row, const double* scales, std::size_t count, float* to,
                    std::size_t stride);
};

/// The kernels of the instruction set in use.
const OnlineTable& online_table();

}  // namespace somato::kernels
