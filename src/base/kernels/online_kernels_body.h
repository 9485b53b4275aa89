// The kernels of online_kernels.h, written once; included after kernels_body.h, whose vectors they
// use, in the namespace of one instruction set.

#include "base/kernels/online_kernels.h"

namespace somato::kernels::SOMATO_KERNELS {
namespace {

// Inputs at once: as many as there are registers for.
#if defined(__AVX512F__)
constexpr std::size_t kInputsAtOnce = 16;
#else
constexpr std::size_t kInputsAtOnce = 4;
#endif

// Turns of a loop over inputs that are written out, where short vectors leave little work to a
// turn.
#if defined(SOMATO_NEON)
constexpr int kInputsInTurn = 2;
#else
constexpr int kInputsInTurn = 1;
#endif

// Calls work<Count>() for the count, at most Most.
template <std::size_t Most, typename Work>
inline void for_count(std::size_t count, const Work& work) {
  if (count == Most) {
    work.template operator()<Most>();
  } else if constexpr (Most > 1) {
    for_count<Most - 1>(count, work);
  }
}

inline InputRows from_row(InputRows rows, std::size_t j) {
  return {rows.first + j * rows.stride, rows.stride};
}

template <std::size_t Count, typename Weight>
inline void multiply_by(const Weight* tile, std::size_t columns, InputRows inputs, float* sums,
                        std::size_t stride) {
  constexpr std::size_t kPair = 2;
  Vector<float> sum[Count];
#pragma GCC unroll 16
  for (std::size_t j = 0; j < Count; ++j) sum[j] = Vector<float>::all(0);
  std::size_t column = 0;
  for (; column + kPair <= columns; column += kPair) {
    const auto weight = Vector<float>::load(tile + column * kLaneCount<float>);
    const auto next = Vector<float>::load(tile + (column + 1) * kLaneCount<float>);
#pragma GCC unroll 16
    for (std::size_t j = 0; j < Count; ++j) {
      const float* input = inputs.first + j * inputs.stride + column;
      sum[j] = multiply_add(weight, Vector<float>::all(input[0]), sum[j]);
      sum[j] = multiply_add(next, Vector<float>::all(input[1]), sum[j]);
    }
  }
  for (; column < columns; ++column) {
    const auto weight = Vector<float>::load(tile + column * kLaneCount<float>);
#pragma GCC unroll 16
    for (std::size_t j = 0; j < Count; ++j) {
      const float value = inputs.first[j * inputs.stride + column];
      sum[j] = multiply_add(weight, Vector<float>::all(value), sum[j]);
    }
  }
#pragma GCC unroll 16
  for (std::size_t j = 0; j < Count; ++j) {
    (Vector<float>::load(sums + j * stride) + sum[j]).store(sums + j * stride);
  }
}

template <typename Weight>
void multiply(const Weight* tile, std::size_t columns, InputRows inputs, std::size_t count,
              float* sums, std::size_t stride) {
  for (std::size_t j = 0; j < count;) {
    const std::size_t some = count - j < kInputsAtOnce ? count - j : kInputsAtOnce;
    for_count<kInputsAtOnce>(some, [&]<std::size_t Count>() {
      multiply_by<Count>(tile, columns, from_row(inputs, j), sums + j * stride, stride);
    });
    j += some;
  }
}

// So many neighbouring columns at once hide the latency of the multiply-add.
constexpr std::size_t kColumnsAtOnce = 4;

// So far ahead weights are fetched that are in no near cache.
constexpr std::size_t kColumnsAhead = 48;

// Columns columns of one tile; the last inputs' turn (Last) clears and measures.
template <std::size_t Count, std::size_t Columns, bool Last>
inline void add_inputs(const float* from, const Vector<float>& kept, const Vector<float>* gain,
                       InputRows inputs, const Vector<float>& limit, float* to,
                       Vector<float>& squares) {
  Vector<float> moved[Columns];
#pragma GCC unroll 4
  for (std::size_t i = 0; i < Columns; ++i) {
    __builtin_prefetch(from + (i + kColumnsAhead) * kLaneCount<float>, 1, 2);
    moved[i] = kept * Vector<float>::load(from + i * kLaneCount<float>);
  }
#pragma GCC unroll 16
  for (std::size_t j = 0; j < Count; ++j) {
    const float* input = inputs.first + j * inputs.stride;
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Columns; ++i) {
      moved[i] = multiply_add(gain[j], Vector<float>::all(input[i]), moved[i]);
    }
  }
#pragma GCC unroll 4
  for (std::size_t i = 0; i < Columns; ++i) {
    if (Last) {
      moved[i] = zero_below(moved[i], limit);
      squares = multiply_add(moved[i], moved[i], squares);
    }
    moved[i].store(to + i * kLaneCount<float>);
  }
}

template <std::size_t Count, bool Last>
inline void combine_with(const float* from, std::size_t columns, const Vector<float>& kept,
                         const float* gains, InputRows inputs, const Vector<float>& limit,
                         float* to, float* squares) {
  Vector<float> gain[Count];
#pragma GCC unroll 16
  for (std::size_t j = 0; j < Count; ++j) {
    gain[j] = Vector<float>::load(gains + j * kLaneCount<float>);
  }
  auto sum = Vector<float>::all(0);
  const auto add = [&]<std::size_t Columns>(std::size_t column) {
    add_inputs<Count, Columns, Last>(from + column * kLaneCount<float>, kept, gain,
                                     {inputs.first + column, inputs.stride}, limit,
                                     to + column * kLaneCount<float>, sum);
  };
  std::size_t column = 0;
  for (; column + kColumnsAtOnce <= columns; column += kColumnsAtOnce) {
    add.template operator()<kColumnsAtOnce>(column);
  }
  for (; column < columns; ++column) add.template operator()<1>(column);
  if (Last) (Vector<float>::load(squares) + sum).store(squares);
}

void combine(const float* tile, std::size_t columns, const float* kept, const float* gains,
             InputRows inputs, std::size_t count, float limit, float* to, float* squares) {
  const auto limits = Vector<float>::all(limit);
  auto keep = Vector<float>::load(kept);
  const float* from = tile;
  std::size_t j = 0;
  for (; count - j > kInputsAtOnce; j += kInputsAtOnce) {
    combine_with<kInputsAtOnce, false>(from, columns, keep, gains + j * kLaneCount<float>,
                                       from_row(inputs, j), limits, to, squares);
    from = to;
    keep = Vector<float>::all(1);
  }
  for_count<kInputsAtOnce>(count - j, [&]<std::size_t Count>() {
    combine_with<Count, true>(from, columns, keep, gains + j * kLaneCount<float>,
                              from_row(inputs, j), limits, to, squares);
  });
}

void combine_row(float* row, std::size_t columns, float kept, const float* gains, InputRows inputs,
                 std::size_t count, float limit) {
  const auto keep = Vector<float>::all(kept);
  const auto limits = Vector<float>::all(limit);
  for (std::size_t i = 0; i < columns; i += kLaneCount<float>) {
    auto moved = keep * Vector<float>::load(row + i);
#pragma GCC unroll kInputsInTurn
    for (std::size_t j = 0; j < count; ++j) {
      const auto input = Vector<float>::load(inputs.first + j * inputs.stride + i);
      moved = multiply_add(Vector<float>::all(gains[j]), input, moved);
    }
    zero_below(moved, limits).store(row + i);
  }
}

// So many chunks at once hide the latency of the multiply-add.
constexpr std::size_t kChunksAtOnce = 4;

// Adds the sums of neighbouring chunks to `total`, one after the other.
template <std::size_t Chunks, typename Weight>
inline Vector<float> add_chunks(const Weight* tile, std::size_t chunk, const float* input,
                                Vector<float> total) {
  Vector<float> sum[Chunks];
#pragma GCC unroll 4
  for (std::size_t i = 0; i < Chunks; ++i) sum[i] = Vector<float>::all(0);
  for (std::size_t column = 0; column < chunk; ++column) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Chunks; ++i) {
      const std::size_t at = i * chunk + column;
      sum[i] = multiply_add(Vector<float>::load(tile + at * kLaneCount<float>),
                            Vector<float>::all(input[at]), sum[i]);
    }
  }
#pragma GCC unroll 4
  for (std::size_t i = 0; i < Chunks; ++i) total = total + sum[i];
  return total;
}

template <typename Weight>
void multiply_block(const Weight* tile, std::size_t columns, std::size_t chunk, const float* input,
                    float* sums) {
  auto total = Vector<float>::all(0);
  std::size_t start = 0;
  const auto at = [&] { return tile + start * kLaneCount<float>; };
  for (; start + kChunksAtOnce * chunk <= columns; start += kChunksAtOnce * chunk) {
    total = add_chunks<kChunksAtOnce>(at(), chunk, input + start, total);
  }
  for (; start + chunk <= columns; start += chunk) {
    total = add_chunks<1>(at(), chunk, input + start, total);
  }
  if (start < columns) total = add_chunks<1>(at(), columns - start, input + start, total);
  total.store(sums);
}

// The sums for so many rows stay in registers.
constexpr std::size_t kRowsAtOnce = 4;

// Adds the sums of neighbouring chunks to the totals, one after the other. Elements stay in order,
// as where lanes are neurons, so that zeros among them change nothing.
template <std::size_t Rows, std::size_t Chunks>
inline void add_chunks_of_rows(InputRows rows, const float* x, std::size_t chunk, float* totals) {
  float sum[Chunks][Rows] = {};
  for (std::size_t column = 0; column < chunk; ++column) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Chunks; ++i) {
      const std::size_t at = i * chunk + column;
#pragma GCC unroll 4
      for (std::size_t r = 0; r < Rows; ++r) {
        sum[i][r] = __builtin_fmaf(rows.first[r * rows.stride + at], x[at], sum[i][r]);
      }
    }
  }
  for (std::size_t i = 0; i < Chunks; ++i) {
    for (std::size_t r = 0; r < Rows; ++r) totals[r] += sum[i][r];
  }
}

template <std::size_t Rows>
inline void multiply_some_rows(InputRows rows, const float* x, std::size_t columns,
                               std::size_t chunk, float* sums) {
  constexpr std::size_t kChunks = 2;
  float totals[Rows] = {};
  std::size_t start = 0;
  const auto here = [&] { return InputRows{rows.first + start, rows.stride}; };
  for (; start + kChunks * chunk <= columns; start += kChunks * chunk) {
    add_chunks_of_rows<Rows, kChunks>(here(), x + start, chunk, totals);
  }
  for (; start + chunk <= columns; start += chunk) {
    add_chunks_of_rows<Rows, 1>(here(), x + start, chunk, totals);
  }
  add_chunks_of_rows<Rows, 1>(here(), x + start, columns - start, totals);
  for (std::size_t r = 0; r < Rows; ++r) sums[r] = totals[r];
}

void multiply_rows(InputRows rows, std::size_t number, const float* x, std::size_t columns,
                   std::size_t chunk, float* sums) {
  for (std::size_t r = 0; r < number; r += kRowsAtOnce) {
    const std::size_t some = number - r < kRowsAtOnce ? number - r : kRowsAtOnce;
    for_count<kRowsAtOnce>(some, [&]<std::size_t Rows>() {
      multiply_some_rows<Rows>(from_row(rows, r), x, columns, chunk, sums + r);
    });
  }
}

// Lanes are summed over kChunk columns, then over chunks, then in pairs.
template <std::size_t Rows>
inline void multiply_some_long_rows(InputRows rows, const float* x, std::size_t count,
                                    float* sums) {
  Vector<float> totals[Rows];
#pragma GCC unroll 4
  for (std::size_t r = 0; r < Rows; ++r) totals[r] = Vector<float>::all(0);
  for (std::size_t start = 0; start < count; start += kChunk) {
    const std::size_t end = start + kChunk < count ? start + kChunk : count;
    Vector<float> sum[Rows];
#pragma GCC unroll 4
    for (std::size_t r = 0; r < Rows; ++r) sum[r] = Vector<float>::all(0);
    for (std::size_t i = start; i < end; i += kLaneCount<float>) {
      const auto values = Vector<float>::load(x + i);
#pragma GCC unroll 4
      for (std::size_t r = 0; r < Rows; ++r) {
        sum[r] =
            multiply_add(Vector<float>::load(rows.first + r * rows.stride + i), values, sum[r]);
      }
    }
#pragma GCC unroll 4
    for (std::size_t r = 0; r < Rows; ++r) totals[r] = totals[r] + sum[r];
  }
#pragma GCC unroll 4
  for (std::size_t r = 0; r < Rows; ++r) {
    alignas(64) float lanes[kLaneCount<float>];
    totals[r].store(lanes);
    for (std::size_t half = kLaneCount<float> / 2; half > 0; half /= 2) {
      for (std::size_t i = 0; i < half; ++i) lanes[i] += lanes[i + half];
    }
    sums[r] = lanes[0];
  }
}

void multiply_long_rows(InputRows rows, std::size_t number, const float* x, std::size_t columns,
                        float* sums) {
  std::size_t r = 0;
  for (; r + 4 <= number; r += 4) {
    multiply_some_long_rows<4>(from_row(rows, r), x, columns, sums + r);
  }
  for (; r < number; ++r) multiply_some_long_rows<1>(from_row(rows, r), x, columns, sums + r);
}

void round_tile(const float* tile, std::size_t columns, const float* factors, std::int16_t* to,
                float* greatest_so_far) {
  const auto factor = Vector<float>::load(factors);
  auto greatest_weight = Vector<float>::load(greatest_so_far);
#pragma GCC unroll 4
  for (std::size_t column = 0; column < columns; ++column) {
    const auto weight = Vector<float>::load(tile + column * kLaneCount<float>);
    (weight * factor).store_rounded(to + column * kLaneCount<float>);
    greatest_weight = greatest(greatest_weight, weight);
  }
  greatest_weight.store(greatest_so_far);
}

template <std::size_t Rows>
inline void add_some_rows(const float* const* rows, const float* values, std::size_t count,
                          double* sums) {
  Vector<double> value[Rows];
#pragma GCC unroll 4
  for (std::size_t r = 0; r < Rows; ++r) {
    value[r] = Vector<double>::all(static_cast<double>(values[r]));
  }
  for (std::size_t i = 0; i < count; i += kLaneCount<float>) {
    auto low = Vector<double>::load(sums + i);
    auto high = Vector<double>::load(sums + i + kLaneCount<double>);
#pragma GCC unroll 4
    for (std::size_t r = 0; r < Rows; ++r) {
      const auto lanes = Vector<float>::load(rows[r] + i);
      low = multiply_add(value[r], lower_half(lanes), low);
      high = multiply_add(value[r], upper_half(lanes), high);
    }
    low.store(sums + i);
    high.store(sums + i + kLaneCount<double>);
  }
}

void add_rows(const float* const* rows, const float* values, std::size_t number, std::size_t count,
              double* sums) {
  std::size_t r = 0;
  for (; r + kRowsAtOnce <= number; r += kRowsAtOnce) {
    add_some_rows<kRowsAtOnce>(rows + r, values + r, count, sums);
  }
  for (; r < number; ++r) add_some_rows<1>(rows + r, values + r, count, sums);
}

inline Vector<double> add_change(const Vector<double>& was, const Vector<double>& is,
                                 const Vector<double>& change) {
  const auto less = multiply_add(Vector<double>::all(0) - was, was, change);
  return multiply_add(is, is, less);
}

template <std::size_t Rows>
inline void move_some_rows(float* const* rows, const float* values, const float* factors,
                           std::size_t count, double* change) {
  for (std::size_t i = 0; i < count; i += kLaneCount<float>) {
    const auto factor = Vector<float>::load(factors + i);
    auto low = Vector<double>::load(change + i);
    auto high = Vector<double>::load(change + i + kLaneCount<double>);
#pragma GCC unroll 4
    for (std::size_t r = 0; r < Rows; ++r) {
      const auto was = Vector<float>::load(rows[r] + i);
      const auto is = multiply_add(Vector<float>::all(values[r]), factor, was);
      is.store(rows[r] + i);
      low = add_change(lower_half(was), lower_half(is), low);
      high = add_change(upper_half(was), upper_half(is), high);
    }
    low.store(change + i);
    high.store(change + i + kLaneCount<double>);
  }
}

void move_rows(float* const* rows, const float* values, std::size_t number, const float* factors,
               std::size_t count, double* change) {
  std::size_t r = 0;
  for (; r + kRowsAtOnce <= number; r += kRowsAtOnce) {
    move_some_rows<kRowsAtOnce>(rows + r, values + r, factors, count, change);
  }
  for (; r < number; ++r) move_some_rows<1>(rows + r, values + r, factors, count, change);
}

void fold_row(float* row, const float* factors, std::size_t count, double* squares) {
  const auto limit = Vector<float>::all(kNegligible<float>);
  for (std::size_t i = 0; i < count; i += kLaneCount<float>) {
    const auto scaled = Vector<float>::load(row + i) * Vector<float>::load(factors + i);
    const auto kept = zero_below(scaled, limit);
    kept.store(row + i);
    double* to = squares + i;
    multiply_add(lower_half(kept), lower_half(kept), Vector<double>::load(to)).store(to);
    to += kLaneCount<double>;
    multiply_add(upper_half(kept), upper_half(kept), Vector<double>::load(to)).store(to);
  }
}

void scale_row(const float* row, const double* scales, std::size_t count, float* to,
               std::size_t stride) {
  const auto limit = Vector<double>::all(static_cast<double>(kNegligible<float>));
  for (std::size_t i = 0; i < count; i += kLaneCount<float>, to += stride) {
    const auto lanes = Vector<float>::load(row + i);
    const auto low = Vector<double>::load(scales + i) * lower_half(lanes);
    const auto high = Vector<double>::load(scales + i + kLaneCount<double>) * upper_half(lanes);
    store_halves(zero_below(low, limit), zero_below(high, limit), to);
  }
}

}  // namespace

// NOLINTNEXTLINE(misc-definitions-in-headers): each source that includes this has its own namespace
extern const OnlineTable kOnlineTable = {multiply<float>,
                                         multiply<std::int16_t>,
                                         combine,
                                         combine_row,
                                         multiply_block<float>,
                                         multiply_block<std::int16_t>,
                                         multiply_rows,
                                         multiply_long_rows,
                                         round_tile,
                                         add_rows,
                                         move_rows,
                                         fold_row,
                                         scale_row};

}  // namespace somato::kernels::SOMATO_KERNELS
