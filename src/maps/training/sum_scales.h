#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "somato/core/matrix.h"

namespace somato {

/// The scales at which values of samples are added as 64-bit integers: a power of 2 for each
/// element. Sums of integers are the same in any order, so neither the division of samples among
/// threads, parts and processes nor an instruction set changes them. A value is rounded by at most
/// half of 2^(1 - bits) of the greatest one of its element, where bits = min(51, 62 - b) and b is
/// the number of binary digits of the number of samples; a sum is below 2^62.
class SumScales {
 public:
  /// For sums of at most `samples` samples, with values of each element from `low` to `high`; and
  /// for sums of integers in the place of one more element.
  SumScales(std::size_t samples, std::span<const float> low, std::span<const float> high);

  /// The scales from element `first` on, a multiple of 8.
  const double* from(std::size_t first) const { return scales_.data() + first; }

  /// The integer that stands for a value.
  std::int64_t integer(std::size_t element, float value) const;

  /// The power of 2 for sums of other values of as many samples, from 0 to `greatest`.
  double scale_for(double greatest) const;

  /// The number that a sum stands for, rounded to double precision.
  double number(std::size_t element, std::int64_t sum) const {
    return static_cast<double>(sum) * units_[element];
  }

 private:
  int bits_;
  AlignedVector<double> scales_;
  AlignedVector<double> units_;  // 1 / scale
};

}  // namespace somato
