#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"

namespace somato {

/// Statistics of the columns of samples, collected part by part in order; independent of the
/// division into parts.
class KnownValues {
 public:
  /// Takes samples, or one of them. Errors (kData, with the sample from 1): a sample without any
  /// known value.
  Result<void> take(const Samples& part);
  Result<void> take(std::span<const float> row);

  std::size_t samples() const { return samples_; }
  std::size_t missing() const { return missing_; }        ///< Values.
  std::size_t incomplete() const { return incomplete_; }  ///< Samples with a missing value.

  /// The least and the greatest known value of each column; NaN where there is none.
  const std::vector<float>& low() const { return low_; }
  const std::vector<float>& high() const { return high_; }

  /// The mean of each column over the samples that know it, summed in their order in double
  /// precision. `names` of columns may be empty. Errors (kData): a column without known values.
  Result<std::vector<double>> means(const std::vector<std::string>& names) const;

 private:
  void begin(std::size_t columns);

  std::size_t samples_ = 0;
  std::size_t missing_ = 0;
  std::size_t incomplete_ = 0;
  std::vector<float> low_;
  std::vector<float> high_;
  std::vector<double> sums_;
  std::vector<std::size_t> known_;  // Samples that know a column.
};

}  // namespace somato
