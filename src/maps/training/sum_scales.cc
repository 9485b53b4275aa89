#include "maps/training/sum_scales.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/core/lanes.h"

namespace somato {
namespace {

constexpr int kBitsOfSum = 62;
constexpr int kMostBits = 51;  // so that a double holds an integer and the next halves

int bits_of_values(std::size_t samples) {
  return std::min(kMostBits, kBitsOfSum - static_cast<int>(std::bit_width(samples)));
}

// The power of 2 that takes every value below 2^bits.
double power_for(double greatest, int bits) {
  if (greatest == 0.0) return 1.0;
  int exponent = 0;
  static_cast<void>(std::frexp(greatest, &exponent));
  return std::ldexp(1.0, bits - exponent);
}

}  // namespace

SumScales::SumScales(std::size_t samples, std::span<const float> low, std::span<const float> high)
    : bits_(bits_of_values(samples)),
      scales_((low.size() / kDoubleLanes + 1) * kDoubleLanes, 1.0),
      units_(scales_) {
  for (std::size_t d = 0; d < low.size(); ++d) {
    scales_[d] = power_for(std::max(std::fabs(low[d]), std::fabs(high[d])), bits_);
    units_[d] = 1.0 / scales_[d];
  }
}

double SumScales::scale_for(double greatest) const {
  return power_for(greatest, bits_);
}

std::int64_t SumScales::integer(std::size_t element, float value) const {
  constexpr double kOneIsLast = 0x1.8p52;  // a double of this size has no places behind the point
  return static_cast<std::int64_t>((double{value} * scales_[element] + kOneIsLast) - kOneIsLast);
}

}  // namespace somato
