#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "somato/core/check.h"

namespace somato {

/// Rows x columns values in row-major order, owned.
template <typename T>
class Matrix {
 public:
  Matrix() = default;

  /// A matrix of `rows` x `columns` copies of `value`.
  Matrix(std::size_t rows, std::size_t columns, T value = T{})
      : rows_(rows), columns_(columns), values_(rows * columns, value) {}

  /// Takes `values` in row-major order; throws InvalidArgument unless there are rows x columns.
  Matrix(std::size_t rows, std::size_t columns, std::vector<T> values)
      : rows_(rows), columns_(columns), values_(std::move(values)) {
    require(values_.size() == rows * columns, "a matrix needs rows x columns values");
  }

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  bool empty() const { return values_.empty(); }

  T& operator()(std::size_t row, std::size_t column) { return values_[row * columns_ + column]; }
  const T& operator()(std::size_t row, std::size_t column) const {
    return values_[row * columns_ + column];
  }

  std::span<T> row(std::size_t row) { return {values_.data() + row * columns_, columns_}; }
  std::span<const T> row(std::size_t row) const {
    return {values_.data() + row * columns_, columns_};
  }

  /// Appends a row of T{}; invalidates spans of rows.
  std::span<T> add_row() {
    values_.resize(values_.size() + columns_);
    return row(rows_++);
  }

  /// Releases memory that was reserved for further rows.
  void shrink_to_fit() { values_.shrink_to_fit(); }

  /// Appends the rows of `more`, in amortized constant time per value. Throws InvalidArgument if
  /// the number of columns differs.
  void append(const Matrix& more) {
    require(more.columns_ == columns_, "Matrix::append: rows of another length");
    values_.insert(values_.end(), more.values_.begin(), more.values_.end());
    rows_ += more.rows_;
  }

  /// All values in row-major order.
  std::span<T> values() { return values_; }
  std::span<const T> values() const { return values_; }

  bool operator==(const Matrix&) const = default;

 private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::vector<T> values_;
};

namespace detail {

/// Memory that starts on a cache line; large blocks use large pages if the system has them, which
/// are much faster to access for the first time.
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
/// Rows are grouped in blocks of one cache line (16 floats or 8 doubles); within a block the lanes
/// of column 0 are contiguous, followed by those of column 1, and so on. The last block is padded
/// with rows of zeros. Sums along a row are then the same for every width of vector.
template <typename Real>
class LaneMatrix {
 public:
  static constexpr std::size_t kLanes = 64 / sizeof(Real);

  LaneMatrix() = default;

  /// A matrix of `rows` x `columns` zeros.
  LaneMatrix(std::size_t rows, std::size_t columns)
      : rows_(rows),
        columns_(columns),
        blocks_((rows + kLanes - 1) / kLanes),
        values_(blocks_ * columns * kLanes) {}

  /// A copy of `matrix` in this layout.
  explicit LaneMatrix(const Matrix<Real>& matrix) : LaneMatrix(matrix.rows(), matrix.columns()) {
    for (std::size_t row = 0; row < rows_; ++row) set_row(row, matrix.row(row));
  }

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  std::size_t blocks() const { return blocks_; }

  /// The number of rows including the padding of the last block: the length of a vector with one
  /// value per row.
  std::size_t padded_rows() const { return blocks_ * kLanes; }

  Real& operator()(std::size_t row, std::size_t column) { return values_[offset(row, column)]; }
  Real operator()(std::size_t row, std::size_t column) const {
    return values_[offset(row, column)];
  }

  /// The lanes of block 0, column 0; the class comment describes the layout.
  Real* data() { return values_.data(); }
  const Real* data() const { return values_.data(); }

  void set_row(std::size_t row, std::span<const Real> values) {
    for (std::size_t column = 0; column < columns_; ++column) (*this)(row, column) = values[column];
  }

  /// Writes row `row` to `out`, which has columns() values.
  void copy_row(std::size_t row, std::span<Real> out) const {
    for (std::size_t column = 0; column < columns_; ++column) out[column] = (*this)(row, column);
  }

  /// A copy in row-major order, without the padding.
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
