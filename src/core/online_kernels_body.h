// The kernels of online_kernels.h, written once; included after kernels_body.h, whose vectors they
// use, in the namespace of one instruction set.

#include "core/online_kernels.h"

namespace somato::kernels::SOMATO_KERNELS {
namespace {

// Inputs at once: as many as there are registers for.
#if defined(__AVX512F__)
constexpr std::size_t kInputsAtOnce = 16;
#else
constexpr std::size_t kInputsAtOnce = 4;
#endif

template <std::size_t Count>
inline void multiply_by(const float* tile, std::size_t columns, const float* inputs, float* sums,
                        std::size_t stride) {
  Vector<float> sum[Count];
#pragma GCC unroll 16
  for (std::size_t j = 0; j < Count; ++j) sum[j] = Vector<float>::all(0);
  for (std::size_t column = 0; column < columns; ++column) {
    const auto weight = Vector<float>::load(tile + column * kLaneCount<float>);
#pragma GCC unroll 16
    for (std::size_t j = 0; j < Count; ++j) {
      sum[j] = multiply_add(weight, Vector<float>::all(inputs[column * kPending + j]), sum[j]);
    }
  }
#pragma GCC unroll 16
  for (std::size_t j = 0; j < Count; ++j) {
    (Vector<float>::load(sums + j * stride) + sum[j]).store(sums + j * stride);
  }
}

void multiply(const float* tile, std::size_t columns, const float* inputs, std::size_t count,
              float* sums, std::size_t stride) {
  std::size_t j = 0;
  for (; j + kInputsAtOnce <= count; j += kInputsAtOnce) {
    multiply_by<kInputsAtOnce>(tile, columns, inputs + j, sums + j * stride, stride);
  }
  for (; j + 4 <= count; j += 4) {
    multiply_by<4>(tile, columns, inputs + j, sums + j * stride, stride);
  }
  for (; j < count; ++j) multiply_by<1>(tile, columns, inputs + j, sums + j * stride, stride);
}

// So many neighbouring columns at once hide the latency of the multiply-add.
constexpr std::size_t kColumnsAtOnce = 4;

// Columns columns of one tile; the last inputs' turn (Last) clears and measures.
template <std::size_t Count, std::size_t Columns, bool Last>
inline void add_inputs(const float* from, const Vector<float>& kept, const Vector<float>* gain,
                       const float* inputs, const Vector<float>& limit, float* to,
                       Vector<float>& squares) {
  Vector<float> moved[Columns];
#pragma GCC unroll 4
  for (std::size_t i = 0; i < Columns; ++i) {
    moved[i] = kept * Vector<float>::load(from + i * kLaneCount<float>);
  }
#pragma GCC unroll 16
  for (std::size_t j = 0; j < Count; ++j) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Columns; ++i) {
      moved[i] = multiply_add(gain[j], Vector<float>::all(inputs[i * kPending + j]), moved[i]);
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
                         const float* gains, const float* inputs, const Vector<float>& limit,
                         float* to, float* squares) {
  Vector<float> gain[Count];
#pragma GCC unroll 16
  for (std::size_t j = 0; j < Count; ++j) {
    gain[j] = Vector<float>::load(gains + j * kLaneCount<float>);
  }
  auto sum = Vector<float>::all(0);
  std::size_t column = 0;
  for (; column + kColumnsAtOnce <= columns; column += kColumnsAtOnce) {
    add_inputs<Count, kColumnsAtOnce, Last>(from + column * kLaneCount<float>, kept, gain,
                                            inputs + column * kPending, limit,
                                            to + column * kLaneCount<float>, sum);
  }
  for (; column < columns; ++column) {
    add_inputs<Count, 1, Last>(from + column * kLaneCount<float>, kept, gain,
                               inputs + column * kPending, limit, to + column * kLaneCount<float>,
                               sum);
  }
  if (Last) (Vector<float>::load(squares) + sum).store(squares);
}

// The first Count of the inputs; returns how many are left.
template <std::size_t Count>
inline std::size_t combine_some(const float* from, std::size_t columns, const Vector<float>& kept,
                                const float* gains, const float* inputs, std::size_t count,
                                const Vector<float>& limit, float* to, float* squares) {
  if (count == Count) {
    combine_with<Count, true>(from, columns, kept, gains, inputs, limit, to, squares);
  } else {
    combine_with<Count, false>(from, columns, kept, gains, inputs, limit, to, squares);
  }
  return count - Count;
}

void combine(const float* tile, std::size_t columns, const float* kept, const float* gains,
             const float* inputs, std::size_t count, float limit, float* to, float* squares) {
  const auto limits = Vector<float>::all(limit);
  auto keep = Vector<float>::load(kept);
  const float* from = tile;
  for (std::size_t left = count; left > 0; from = to, keep = Vector<float>::all(1)) {
    const float* these_gains = gains + (count - left) * kLaneCount<float>;
    const float* these = inputs + (count - left);
    if (left >= kInputsAtOnce) {
      left = combine_some<kInputsAtOnce>(from, columns, keep, these_gains, these, left, limits, to,
                                         squares);
    } else if (left >= 4) {
      left = combine_some<4>(from, columns, keep, these_gains, these, left, limits, to, squares);
    } else {
      left = combine_some<1>(from, columns, keep, these_gains, these, left, limits, to, squares);
    }
  }
}

template <std::size_t Count>
inline void multiply_some(const float* const* weights, std::size_t columns, std::size_t chunk,
                          const float* input, float* sums) {
  Vector<float> totals[Count];
#pragma GCC unroll 4
  for (std::size_t i = 0; i < Count; ++i) totals[i] = Vector<float>::all(0);
  for (std::size_t start = 0; start < columns; start += chunk) {
    const std::size_t end = start + chunk < columns ? start + chunk : columns;
    Vector<float> sum[Count];
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Count; ++i) sum[i] = Vector<float>::all(0);
    for (std::size_t column = start; column < end; ++column) {
      const auto element = Vector<float>::all(input[column]);
#pragma GCC unroll 4
      for (std::size_t i = 0; i < Count; ++i) {
        const auto weight = Vector<float>::load(weights[i] + column * kLaneCount<float>);
        sum[i] = multiply_add(weight, element, sum[i]);
      }
    }
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Count; ++i) totals[i] = totals[i] + sum[i];
  }
#pragma GCC unroll 4
  for (std::size_t i = 0; i < Count; ++i) totals[i].store(sums + i * kLaneCount<float>);
}

// Four at once hide the latency of the multiply-add.
void multiply_blocks(const float* const* weights, std::size_t blocks, std::size_t columns,
                     std::size_t chunk, const float* input, float* sums) {
  std::size_t i = 0;
  for (; i + 4 <= blocks; i += 4) {
    multiply_some<4>(weights + i, columns, chunk, input, sums + i * kLaneCount<float>);
  }
  for (; i + 2 <= blocks; i += 2) {
    multiply_some<2>(weights + i, columns, chunk, input, sums + i * kLaneCount<float>);
  }
  for (; i < blocks; ++i) {
    multiply_some<1>(weights + i, columns, chunk, input, sums + i * kLaneCount<float>);
  }
}

// These two are plain, for the compiler to vectorize: the elements do not depend on each other.
void move_row(float* __restrict row, float x, const float* __restrict factors, std::size_t count,
              double* __restrict change) {
  for (std::size_t i = 0; i < count; ++i) {
    const float before = row[i];
    const float after = __builtin_fmaf(x, factors[i], before);
    row[i] = after;
    const auto was = static_cast<double>(before);
    const auto is = static_cast<double>(after);
    change[i] = __builtin_fma(is, is, __builtin_fma(-was, was, change[i]));
  }
}

void fold_row(float* __restrict row, const float* __restrict factors, std::size_t count,
              double* __restrict squares) {
  for (std::size_t i = 0; i < count; ++i) {
    const float scaled = row[i] * factors[i];
    const float kept = __builtin_fabsf(scaled) < kNegligible<float> ? 0.0F : scaled;
    row[i] = kept;
    squares[i] = __builtin_fma(static_cast<double>(kept), static_cast<double>(kept), squares[i]);
  }
}

}  // namespace

// NOLINTNEXTLINE(misc-definitions-in-headers): each source that includes this has its own namespace
extern const OnlineTable kOnlineTable = {multiply, combine, multiply_blocks, move_row, fold_row};

}  // namespace somato::kernels::SOMATO_KERNELS
