#pragma once

// Inner loops over a LaneMatrix, one implementation an instruction set, chosen when the program
// runs. Vector lanes run over rows (neurons), and a sum along a row has one fixed order: chunks of
// kChunk columns are summed on their own and the chunks' sums are added in order. So every
// instruction set gives the same bits, and rounding grows with kChunk + columns / kChunk, not with
// the number of columns.

#include <cstddef>
#include <cstdint>

namespace somato::kernels {

inline constexpr std::size_t kChunk = 256;

/// So many sums of spread() are taken at once.
inline constexpr std::size_t kSpreadGroup = 4;

/// Smaller magnitudes are not worth keeping: the product of two of them leaves the range of normal
/// numbers, where processors are up to a hundred times slower.
template <typename Real>
inline constexpr Real kNegligible =
    sizeof(Real) == sizeof(float) ? static_cast<Real>(1e-18) : static_cast<Real>(1e-150);

/// The matrix as the kernels see it: plain pointers, so that no inline function of another header
/// is compiled for an instruction set that the machine may lack. See LaneMatrix for the order. A
/// range of columns has the same stride as all columns.
template <typename Real>
struct Lanes {
  Real* values;
  std::size_t blocks;
  std::size_t columns;
  std::size_t stride = columns;  ///< Columns from one block to the next.
};

/// The kernels for one type of number. `out`, `gains` and `factors` hold a value for each padded
/// row and start on a cache line.
template <typename Real>
struct Table {
  /// out = sum over columns of (w - x)^2.
  void (*squared_distances)(Lanes<const Real> w, const Real* x, Real* out);
  /// out = sum over columns of w * x.
  void (*inner_products)(Lanes<const Real> w, const Real* x, Real* out);
  /// out = sum over the listed columns of w * x.
  void (*sparse_inner_products)(Lanes<const Real> w, const std::uint32_t* columns, const Real* x,
                                std::size_t count, Real* out);
  /// out = sum over columns of w^2.
  void (*squared_norms)(Lanes<const Real> w, Real* out);
  /// w += gain * (x - w) in each row; blocks whose gains are all zero are not touched.
  void (*move_towards)(Lanes<Real> w, const Real* x, const Real* gains);
  /// sums += factor * x, element by element in double precision; no alignment needed.
  void (*add_scaled)(const Real* x, double factor, std::size_t count, double* sums);
  /// The sum of a * b in double precision, one element after the other; no alignment needed.
  double (*product)(const Real* a, const Real* b, std::size_t count);
  /// The same of values at `places` of b.
  double (*sparse_product)(const std::uint32_t* places, const Real* values, std::size_t count,
                           const Real* b);
  /// w *= factor in each row.
  void (*scale_rows)(Lanes<Real> w, const Real* factors);
  /// w = 0 where its magnitude is below kNegligible. Weights of elements that are always zero decay
  /// towards the slow subnormal numbers and would stay there.
  void (*clear_negligible)(Lanes<Real> w);
};

/// The kernels of the instruction set in use.
template <typename Real>
const Table<Real>& table();
template <>
const Table<float>& table<float>();
template <>
const Table<double>& table<double>();

}  // namespace somato::kernels
