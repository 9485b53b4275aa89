#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "maps/sample_columns.h"
#include "somato/core/lane_matrix.h"
#include "somato/core/matrix.h"
#include "somato/core/samples.h"

namespace somato {

/// Samples as maps see them, with their inner products: what training by products needs of them
/// again and again.
class SampleProducts {
 public:
  SampleProducts(std::shared_ptr<const Samples> samples, std::size_t threads);

  const Samples& samples() const { return *samples_; }

  /// Of sparse samples; else empty.
  const SampleColumns& columns() const { return columns_; }

  /// Samples x samples.
  const Matrix<double>& products() const { return products_; }

  /// Of dense samples, the values of elements first .. first + count - 1: element by element, and
  /// within it sample by sample.
  void write_elements(std::size_t first, std::size_t count, std::span<double> out) const;

 private:
  void multiply_dense(std::size_t first_sample, AlignedVector<double>& out) const;
  void multiply_sparse(std::size_t first_sample, AlignedVector<double>& out) const;
  void multiply(std::size_t block);

  std::shared_ptr<const Samples> samples_;
  SampleColumns columns_;
  Matrix<double> products_;
};

}  // namespace somato
