// The kernels, written once. Each kernels_*.cc defines SOMATO_KERNELS as a namespace of its own and
// includes this file, compiled for its instruction set.

#include <cstddef>
#include <cstdint>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "base/kernels/kernels.h"

namespace somato::kernels::SOMATO_KERNELS {
namespace {

#include "base/kernels/vector.h"  // NOLINT(bugprone-suspicious-include): meant to be inside the namespace

template <typename Real>
constexpr std::size_t kLaneCount = 64 / sizeof(Real);

// Sums term(block, column) over `columns` columns for Count neighbouring blocks at once: so many
// independent sums hide the latency of the multiply-add. Here and below loops over Count are
// unrolled by hand: g++ -O2 leaves them, and then keeps the sums in memory.
template <typename Real, std::size_t Count, typename Term>
inline void sum_blocks(std::size_t first_block, std::size_t columns, Real* out, const Term& term) {
  Vector<Real> totals[Count];
#pragma GCC unroll 4
  for (std::size_t i = 0; i < Count; ++i) totals[i] = Vector<Real>::all(0);
  for (std::size_t start = 0; start < columns; start += kChunk) {
    const std::size_t end = start + kChunk < columns ? start + kChunk : columns;
    Vector<Real> sums[Count];
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Count; ++i) sums[i] = Vector<Real>::all(0);
    for (std::size_t column = start; column < end; ++column) {
#pragma GCC unroll 4
      for (std::size_t i = 0; i < Count; ++i) {
        sums[i] = term(first_block + i, column, sums[i]);
      }
    }
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Count; ++i) totals[i] = totals[i] + sums[i];
  }
#pragma GCC unroll 4
  for (std::size_t i = 0; i < Count; ++i) {
    totals[i].store(out + (first_block + i) * kLaneCount<Real>);
  }
}

// The same for all blocks.
template <typename Real, typename Term>
inline void sum_rows(std::size_t blocks, std::size_t columns, Real* out, const Term& term) {
  std::size_t block = 0;
  for (; block + 4 <= blocks; block += 4) sum_blocks<Real, 4>(block, columns, out, term);
  for (; block + 2 <= blocks; block += 2) sum_blocks<Real, 2>(block, columns, out, term);
  for (; block < blocks; ++block) sum_blocks<Real, 1>(block, columns, out, term);
}

// The lanes of one column of one block.
template <typename Real>
inline Real* lanes_at(const Lanes<Real>& w, std::size_t block, std::size_t column) {
  return w.values + (block * w.stride + column) * kLaneCount<Real>;
}

template <typename Real>
void squared_distances(Lanes<const Real> w, const Real* x, Real* out) {
  sum_rows<Real>(
      w.blocks, w.columns, out, [&](std::size_t block, std::size_t column, Vector<Real> sum) {
        const auto difference =
            Vector<Real>::all(x[column]) - Vector<Real>::load(lanes_at(w, block, column));
        return multiply_add(difference, difference, sum);
      });
}

template <typename Real>
void inner_products(Lanes<const Real> w, const Real* x, Real* out) {
  sum_rows<Real>(w.blocks, w.columns, out,
                 [&](std::size_t block, std::size_t column, Vector<Real> sum) {
                   return multiply_add(Vector<Real>::load(lanes_at(w, block, column)),
                                       Vector<Real>::all(x[column]), sum);
                 });
}

template <typename Real>
void sparse_inner_products(Lanes<const Real> w, const std::uint32_t* columns, const Real* x,
                           std::size_t count, Real* out) {
  sum_rows<Real>(w.blocks, count, out, [&](std::size_t block, std::size_t i, Vector<Real> sum) {
    return multiply_add(Vector<Real>::load(lanes_at(w, block, columns[i])), Vector<Real>::all(x[i]),
                        sum);
  });
}

template <typename Real>
void squared_norms(Lanes<const Real> w, Real* out) {
  sum_rows<Real>(w.blocks, w.columns, out,
                 [&](std::size_t block, std::size_t column, Vector<Real> sum) {
                   const auto weight = Vector<Real>::load(lanes_at(w, block, column));
                   return multiply_add(weight, weight, sum);
                 });
}

template <typename Real>
void move_towards(Lanes<Real> w, const Real* x, const Real* gains) {
  for (std::size_t block = 0; block < w.blocks; ++block) {
    const auto gain = Vector<Real>::load(gains + block * kLaneCount<Real>);
    if (gain.is_zero()) continue;
    for (std::size_t column = 0; column < w.columns; ++column) {
      Real* lanes = lanes_at(w, block, column);
      const auto weight = Vector<Real>::load(lanes);
      multiply_add(gain, Vector<Real>::all(x[column]) - weight, weight).store(lanes);
    }
  }
}

// Plain, for the compiler to vectorize: the elements do not depend on each other.
template <typename Real>
void add_scaled(const Real* x, double factor, std::size_t count, double* sums) {
  for (std::size_t i = 0; i < count; ++i) {
    sums[i] = __builtin_fma(factor, static_cast<double>(x[i]), sums[i]);
  }
}

// One element after the other, whose order every instruction set keeps: the gain is the instruction
// in the place of a call.
template <typename Real>
double product(const Real* a, const Real* b, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    sum = __builtin_fma(static_cast<double>(a[i]), static_cast<double>(b[i]), sum);
  }
  return sum;
}

template <typename Real>
double sparse_product(const std::uint32_t* places, const Real* values, std::size_t count,
                      const Real* b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    sum = __builtin_fma(static_cast<double>(values[i]), static_cast<double>(b[places[i]]), sum);
  }
  return sum;
}

template <typename Real>
void scale_rows(Lanes<Real> w, const Real* factors) {
  for (std::size_t block = 0; block < w.blocks; ++block) {
    const auto factor = Vector<Real>::load(factors + block * kLaneCount<Real>);
    for (std::size_t column = 0; column < w.columns; ++column) {
      Real* lanes = lanes_at(w, block, column);
      (Vector<Real>::load(lanes) * factor).store(lanes);
    }
  }
}

template <typename Real>
void clear_negligible(Lanes<Real> w) {
  const auto limit = Vector<Real>::all(kNegligible<Real>);
  for (std::size_t block = 0; block < w.blocks; ++block) {
    for (std::size_t column = 0; column < w.columns; ++column) {
      Real* lanes = lanes_at(w, block, column);
      zero_below(Vector<Real>::load(lanes), limit).store(lanes);
    }
  }
}

template <typename Real>
constexpr Table<Real> make_table() {
  return {squared_distances<Real>, inner_products<Real>, sparse_inner_products<Real>,
          squared_norms<Real>,     move_towards<Real>,   add_scaled<Real>,
          product<Real>,           sparse_product<Real>, scale_rows<Real>,
          clear_negligible<Real>};
}

}  // namespace

// NOLINTBEGIN(misc-definitions-in-headers): each source that includes this has its own namespace
extern const Table<float> kFloatTable = make_table<float>();
extern const Table<double> kDoubleTable = make_table<double>();
// NOLINTEND(misc-definitions-in-headers)

}  // namespace somato::kernels::SOMATO_KERNELS
