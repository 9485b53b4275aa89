#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/kernels/product_kernels.h"

namespace somato {

/// The values of sparse samples in a few columns, sample by sample; scratch memory of a thread.
class StripRows {
 public:
  /// Reads the values of `samples` samples in `count` columns.
  void read(const kernels::ListedValues& columns, std::size_t count, std::size_t samples) {
    starts_.assign(samples + 2, 0);
    std::size_t values = 0;
    for (std::size_t e = 0; e < count; ++e) {
      values += columns.ends[e] - columns.begins[e];
      for (std::uint32_t k = columns.begins[e]; k < columns.ends[e]; ++k) {
        ++starts_[columns.samples[k] + 2];
      }
    }
    for (std::size_t s = 2; s < samples + 2; ++s) starts_[s] += starts_[s - 1];
    elements_.resize(std::max(values, elements_.size()));
    values_.resize(elements_.size());
    for (std::size_t e = 0; e < count; ++e) {
      for (std::uint32_t k = columns.begins[e]; k < columns.ends[e]; ++k) {
        const std::uint32_t at = starts_[columns.samples[k] + 1]++;
        elements_[at] = static_cast<std::uint32_t>(e);
        values_[at] = columns.values[k];
      }
    }
  }

  /// Adds the products of lines of weights, one a column; see ProductTable.
  void add_products(const double* weights, double* products, std::size_t stride) const {
    kernels::product_table().add_listed_products(weights, starts_.data(), elements_.data(),
                                                 values_.data(), starts_.size() - 2, products,
                                                 stride);
  }

 private:
  std::vector<std::uint32_t> starts_;  // of sample s at s; while they are read one further on
  std::vector<std::uint32_t> elements_;
  std::vector<float> values_;
};

}  // namespace somato
