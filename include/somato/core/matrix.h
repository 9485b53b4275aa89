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

  /// Takes `values`, row after row; throws InvalidArgument unless there are rows x columns.
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

  /// All values, row after row.
  std::span<T> values() { return values_; }
  std::span<const T> values() const { return values_; }

  bool operator==(const Matrix&) const = default;

 private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::vector<T> values_;
};

}  // namespace somato
