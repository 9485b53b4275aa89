#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "maps/products/sample_columns.h"
#include "somato/core/matrix.h"
#include "somato/core/samples.h"

namespace somato {

/// Samples as maps see them, with their inner products: what training by products needs of them
/// again and again.
class SampleProducts {
 public:
  SampleProducts(Samples samples, std::size_t threads);

  /// Those of `samples` as they are, or scaled to length 1: computed by the first map that needs
  /// them, and shared by all that learn these samples or a copy.
  static std::shared_ptr<const SampleProducts> of(const Samples& samples, bool normalized,
                                                  std::size_t threads);

  const Samples& samples() const { return samples_; }

  /// The columns of sparse samples; else empty.
  const SampleColumns& columns() const { return columns_; }

  /// Samples x samples.
  const Matrix<double>& products() const { return products_; }

  /// For dense samples, writes the values of elements first .. first + count - 1: element by
  /// element, and within it sample by sample.
  void write_elements(std::size_t first, std::size_t count, std::span<double> out) const;

 private:
  void multiply(std::size_t begin, std::size_t end);
  void multiply_dense(std::size_t begin, std::size_t end, AlignedVector<double>& lines) const;
  void multiply_sparse(std::size_t begin, std::size_t end, AlignedVector<double>& lines) const;
  void write_lines(std::size_t first, std::size_t count, std::size_t first_sample,
                   AlignedVector<double>& lines) const;

  Samples samples_;
  SampleColumns columns_;
  Matrix<double> products_;
};

}  // namespace somato
