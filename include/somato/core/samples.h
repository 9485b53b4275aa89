#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/signal.h"

namespace somato {

/// A set of samples of one size, all dense or all sparse: what a map is trained on.
class Samples {
 public:
  Samples() = default;

  /// One dense sample a row.
  explicit Samples(Matrix<float> rows);

  /// One sample a signal, dense if any of them is; throws InvalidArgument when sizes differ.
  static Samples from_signals(const std::vector<Signal>& signals);

  std::size_t count() const { return sparse_ ? row_starts_.size() - 1 : rows_.rows(); }
  std::size_t size() const { return size_; }
  bool is_sparse() const { return sparse_; }

  /// Bytes that the elements take, with their positions where they are sparse.
  std::size_t bytes() const;

  /// Sample `index`, flat, valid as long as this object.
  SignalView operator[](std::size_t index) const;

  /// The samples at `indices`, in that order.
  Samples subset(const std::vector<std::size_t>& indices) const;

 private:
  std::size_t size_ = 0;
  bool sparse_ = false;
  Matrix<float> rows_;
  std::vector<std::size_t> row_starts_;
  std::vector<std::uint32_t> indices_;
  std::vector<float> values_;
};

}  // namespace somato
