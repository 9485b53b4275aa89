#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/matrix.h"

namespace somato {

namespace detail {

/// Memory that starts on a cache line; where it is large, on large pages if the system has them,
/// which are much faster to touch for the first time.
void* allocate_lines(std::size_t bytes);
void free_lines(void* memory, std::size_t bytes) noexcept;

/// The same for vectors.
template <typename T>
struct CacheLineAllocator {
  using value_type = T;

  CacheLineAllocator() = default;
  template <typename U>
  CacheLineAllocator(const CacheLineAllocator<U>& /*other*/) {}  // NOLINT: allocators convert

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_lines(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) noexcept { free_lines(memory, count * sizeof(T)); }
  bool operator==(const CacheLineAllocator&) const = default;
};

}  // namespace detail

/// Values that start on a cache line.
template <typename T>
using AlignedVector = std::vector<T, detail::CacheLineAllocator<T>>;

/// Rows x columns values for kernels whose vector lanes run over the rows (neurons).
///
/// Rows are taken in blocks of one cache line (16 floats or 8 doubles); within a block the lanes of
/// column 0 stand side by side, then those of column 1, and so on. The last block is filled up with
/// rows of zeros. Sums along a row are then the same for every width of vector.
template <typename Real>
class LaneMatrix {
 public:
  static constexpr std::size_t kLanes = 64 / sizeof(Real);

  LaneMatrix() = default;

  /// Rows x columns zeros.
  LaneMatrix(std::size_t rows, std::size_t columns)
      : rows_(rows),
        columns_(columns),
        blocks_((rows + kLanes - 1) / kLanes),
        values_(blocks_ * columns * kLanes) {}

  /// A copy of `matrix` in this order.
  explicit LaneMatrix(const Matrix<Real>& matrix) : LaneMatrix(matrix.rows(), matrix.columns()) {
    for (std::size_t row = 0; row < rows_; ++row) set_row(row, matrix.row(row));
  }

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  std::size_t blocks() const { return blocks_; }

  /// Rows counted with the filling of the last block: the length of a vector with a value a row.
  std::size_t padded_rows() const { return blocks_ * kLanes; }

  Real& operator()(std::size_t row, std::size_t column) { return values_[offset(row, column)]; }
  Real operator()(std::size_t row, std::size_t column) const {
    return values_[offset(row, column)];
  }

  /// The lanes of block 0, column 0; see the class comment for the order.
  Real* data() { return values_.data(); }
  const Real* data() const { return values_.data(); }

  void set_row(std::size_t row, std::span<const Real> values) {
    for (std::size_t column = 0; column < columns_; ++column) (*this)(row, column) = values[column];
  }

  /// Writes row `row` to `out`, which holds columns() values.
  void copy_row(std::size_t row, std::span<Real> out) const {
    for (std::size_t column = 0; column < columns_; ++column) out[column] = (*this)(row, column);
  }

  /// A copy in row-major order, without the filling.
  Matrix<Real> to_matrix() const {
    Matrix<Real> matrix(rows_, columns_);
    for (std::size_t row = 0; row < rows_; ++row) copy_row(row, matrix.row(row));
    return matrix;
  }

  bool operator==(const LaneMatrix&) const = default;

 private:
  std::size_t offset(std::size_t row, std::size_t column) const {
    return (row / kLanes * columns_ + column) * kLanes + row % kLanes;
  }

  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::size_t blocks_ = 0;
  AlignedVector<Real> values_;
};

}  // namespace somato
