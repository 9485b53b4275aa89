#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/kernels/product_kernels.h"
#include "somato/core/samples.h"

namespace somato {

/// Sparse samples seen element by element: a column for each element where any of them holds a
/// value, in ascending order, with the values of the samples, ascending too.
class SampleColumns {
 public:
  SampleColumns() = default;
  explicit SampleColumns(const Samples& sparse);

  std::span<const std::uint32_t> elements() const { return elements_; }

  /// The values of column `c` are at starts()[c] to starts()[c + 1].
  std::span<const std::uint32_t> starts() const { return starts_; }
  std::span<const std::uint32_t> samples() const { return samples_; }
  std::span<const float> values() const { return values_; }

  /// The columns from `first` on.
  kernels::ListedValues from(std::size_t first) const {
    return {starts_.data() + first, starts_.data() + first + 1, samples_.data(), values_.data()};
  }

 private:
  std::vector<std::uint32_t> elements_;
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint32_t> samples_;
  std::vector<float> values_;
};

}  // namespace somato
