#include "somato/codes/normalization.h"

#include <algorithm>
#include <cmath>

namespace somato {
namespace {

double sum_of_squares(std::span<const float> values) {
  double sum = 0.0;
  for (const float value : values) sum = std::fma(double{value}, double{value}, sum);
  return sum;
}

double sum_of_magnitudes(std::span<const float> values) {
  double sum = 0.0;
  for (const float value : values) sum += std::fabs(double{value});
  return sum;
}

double largest_magnitude(std::span<const float> values) {
  double largest = 0.0;
  for (const float value : values) largest = std::max(largest, std::fabs(double{value}));
  return largest;
}

}  // namespace

const std::vector<std::pair<Norm, std::string>>& Choices<Norm>::all() {
  static const std::vector<std::pair<Norm, std::string>> kAll{
      {Norm::kNone, "none"}, {Norm::kL2, "l2"}, {Norm::kL1, "l1"}, {Norm::kMaximum, "maximum"}};
  return kAll;
}

double norm_of(Norm norm, std::span<const float> values) {
  if (norm == Norm::kL2) return std::sqrt(sum_of_squares(values));
  if (norm == Norm::kL1) return sum_of_magnitudes(values);
  if (norm == Norm::kMaximum) return largest_magnitude(values);
  return 1.0;
}

void normalize(Norm norm, std::span<float> values) {
  const double length = norm_of(norm, values);
  if (norm == Norm::kNone || length == 0.0) return;
  for (float& value : values) value = static_cast<float>(double{value} / length);
}

Signal normalized(Norm norm, Signal signal) {
  normalize(norm, signal.values());
  return signal;
}

}  // namespace somato
