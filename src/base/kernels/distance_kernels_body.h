// The kernels of distance_kernels.h, written once. Each kernels_*.cc defines SOMATO_KERNELS as a
// namespace of its own and includes this file, compiled for its instruction set.

#include <cstddef>
#include <cstdint>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "base/kernels/distance_kernels.h"

namespace somato::kernels::SOMATO_KERNELS {
namespace {

#include "base/kernels/vector.h"  // NOLINT(bugprone-suspicious-include): meant to be inside the namespace

struct AddAbsolute {
  static Vector<float> term(Vector<float> w, Vector<float> x, Vector<float> sum) {
    return sum + magnitude(x - w);
  }
  static Vector<float> together(Vector<float> a, Vector<float> b) { return a + b; }
};

struct TakeGreatest {
  static Vector<float> term(Vector<float> w, Vector<float> x, Vector<float> most) {
    return greatest(most, x - w);
  }
  static Vector<float> together(Vector<float> a, Vector<float> b) { return greatest(a, b); }
};

struct AddSquare {
  static Vector<float> term(Vector<float> w, Vector<float> x, Vector<float> sum) {
    const auto difference = x - w;
    return multiply_add(difference, difference, sum);
  }
  static Vector<float> together(Vector<float> a, Vector<float> b) { return a + b; }
};

struct AddProduct {
  static Vector<float> term(Vector<float> w, Vector<float> x, Vector<float> sum) {
    return multiply_add(w, x, sum);
  }
  static Vector<float> together(Vector<float> a, Vector<float> b) { return a + b; }
};

// Blocks x Inputs results stand in registers, enough to hide the latency of an addition.
template <typename Terms, std::size_t Blocks, std::size_t Inputs>
inline void compare_blocks(const Lanes<const float>& w, std::size_t block, const float* const* x,
                           float* const* out) {
  constexpr std::size_t kLanes = 64 / sizeof(float);
  const float* from = w.values + block * w.stride * kLanes;
  Vector<float> totals[Blocks][Inputs];
#pragma GCC unroll 4
  for (std::size_t b = 0; b < Blocks; ++b) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Inputs; ++i) totals[b][i] = Vector<float>::all(0);
  }
  for (std::size_t start = 0; start < w.columns; start += kChunk) {
    const std::size_t end = start + kChunk < w.columns ? start + kChunk : w.columns;
    Vector<float> sums[Blocks][Inputs];
#pragma GCC unroll 4
    for (std::size_t b = 0; b < Blocks; ++b) {
#pragma GCC unroll 4
      for (std::size_t i = 0; i < Inputs; ++i) sums[b][i] = Vector<float>::all(0);
    }
    for (std::size_t column = start; column < end; ++column) {
#pragma GCC unroll 4
      for (std::size_t b = 0; b < Blocks; ++b) {
        const auto weights = Vector<float>::load(from + (b * w.stride + column) * kLanes);
#pragma GCC unroll 4
        for (std::size_t i = 0; i < Inputs; ++i) {
          sums[b][i] = Terms::term(weights, Vector<float>::all(x[i][column]), sums[b][i]);
        }
      }
    }
#pragma GCC unroll 4
    for (std::size_t b = 0; b < Blocks; ++b) {
#pragma GCC unroll 4
      for (std::size_t i = 0; i < Inputs; ++i) {
        totals[b][i] = Terms::together(totals[b][i], sums[b][i]);
      }
    }
  }
#pragma GCC unroll 4
  for (std::size_t b = 0; b < Blocks; ++b) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Inputs; ++i) totals[b][i].store(out[i] + (block + b) * kLanes);
  }
}

template <typename Terms, std::size_t Blocks, std::size_t Inputs>
inline void compare_some(const Lanes<const float>& w, const float* const* x, float* const* out) {
  std::size_t block = 0;
  for (; block + Blocks <= w.blocks; block += Blocks) {
    compare_blocks<Terms, Blocks, Inputs>(w, block, x, out);
  }
  for (; block < w.blocks; ++block) compare_blocks<Terms, 1, Inputs>(w, block, x, out);
}

template <typename Terms>
void compare(Lanes<const float> w, const float* const* x, std::size_t count, float* const* out) {
  switch (count) {
    case 1:
      return compare_some<Terms, 4, 1>(w, x, out);
    case 2:
      return compare_some<Terms, 2, 2>(w, x, out);
    case 3:
      return compare_some<Terms, 1, 3>(w, x, out);
    default:
      return compare_some<Terms, 1, 4>(w, x, out);
  }
}

}  // namespace

// NOLINTNEXTLINE(misc-definitions-in-headers): each source that includes this has its own namespace
extern const DistanceTable kDistanceTable = {compare<AddAbsolute>, compare<TakeGreatest>,
                                             compare<AddSquare>, compare<AddProduct>};

}  // namespace somato::kernels::SOMATO_KERNELS
