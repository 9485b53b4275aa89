#include "maps/grid/activity.h"

#include <algorithm>
#include <cmath>

#include "base/core/elementary.h"

namespace somato {
namespace {

// By squaring: a few products, each rounded once, where power() takes a logarithm.
double whole_power(double base, unsigned exponent) {
  double result = 1.0;
  for (; exponent > 0; exponent >>= 1U) {
    if ((exponent & 1U) != 0) result *= base;
    base *= base;
  }
  return result;
}

double power_term(double similarity, double exponent) {
  constexpr double kMost = 64.0;
  const bool whole = exponent >= 1.0 && exponent <= kMost && exponent == std::floor(exponent);
  return whole ? whole_power(similarity, static_cast<unsigned>(exponent))
               : power(similarity, exponent);
}

double softmax_term(Softmax softmax, double exponent, double similarity) {
  return softmax == Softmax::kPower ? power_term(similarity, exponent)
                                    : exponential(exponent * similarity);
}

}  // namespace

float similarity_at(double squared_distance) {
  return static_cast<float>(1.0 / (1.0 + std::sqrt(squared_distance)));
}

void activity_of_similarities(const SomParameters& parameters, std::span<float> values) {
  for (float& value : values) value = std::max(value, 0.0F);
  const double largest = *std::max_element(values.begin(), values.end());
  const bool power_form = parameters.softmax == Softmax::kPower;
  if (power_form && largest == 0.0) return;
  // Relative to the largest one, so that nothing overflows; the quotient below is the same.
  double sum = 0.0;
  for (float& value : values) {
    const double relative = power_form ? value / largest : value - largest;
    const double term = softmax_term(parameters.softmax, parameters.softmax_exponent, relative);
    value = static_cast<float>(term);
    sum += term;
  }
  if (parameters.activity_norm == ActivityNorm::kMaximum) return;
  for (float& value : values) value = static_cast<float>(value / sum);
}

}  // namespace somato
