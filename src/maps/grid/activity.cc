#include "maps/grid/activity.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/core/elementary.h"
#include "base/kernels/neuron_activity_kernels.h"

namespace somato {
namespace {

constexpr std::size_t kLine = LaneMatrix<float>::kLanes;
constexpr std::size_t kTermsAtOnce = 16 * kLine;

std::size_t lines_of(const AlignedVector<float>& values) {
  return values.size() / kLine;
}

// An exponent for which a few products, each rounded once, take the place of a logarithm.
std::optional<unsigned> whole_exponent(const SomParameters& parameters) {
  constexpr double kMost = 64.0;
  const double exponent = parameters.softmax_exponent;
  const bool whole = exponent >= 1.0 && exponent <= kMost && exponent == std::floor(exponent);
  if (parameters.softmax != Softmax::kPower || !whole) return {};
  return static_cast<unsigned>(exponent);
}

// The terms of the softmax relative to the largest one, so that nothing overflows.
class SoftmaxTerms {
 public:
  SoftmaxTerms(const SomParameters& parameters, float largest)
      : is_power_(parameters.softmax == Softmax::kPower),
        exponent_(parameters.softmax_exponent),
        whole_exponent_(whole_exponent(parameters)),
        largest_(double{largest}) {}

  // Replaces the values by their terms.
  void replace(AlignedVector<float>& values) const {
    if (whole_exponent_) {
      kernels::activity_table().powers(values.data(), lines_of(values), largest_, *whole_exponent_);
      return;
    }
    for (float& value : values) value = static_cast<float>(term(value));
  }

  // The same, and returns the sum of the first `count` terms, which is that of unrounded ones in
  // their order.
  double replace_and_sum(AlignedVector<float>& values, std::size_t count) const {
    double sum = 0.0;
    alignas(64) double terms[kTermsAtOnce];
    for (std::size_t first = 0; first < count; first += kTermsAtOnce) {
      float* const part = values.data() + first;
      const std::size_t in_lines = std::min(kTermsAtOnce, values.size() - first);
      const std::size_t in_sum = std::min(kTermsAtOnce, count - first);
      write_terms(part, in_lines, terms);
      for (std::size_t i = 0; i < in_sum; ++i) {
        part[i] = static_cast<float>(terms[i]);
        sum += terms[i];
      }
    }
    return sum;
  }

 private:
  void write_terms(const float* values, std::size_t count, double* terms) const {
    if (whole_exponent_) {
      kernels::activity_table().power_terms(values, count / kLine, largest_, *whole_exponent_,
                                            terms);
      return;
    }
    for (std::size_t i = 0; i < count; ++i) terms[i] = term(values[i]);
  }

  double term(float similarity) const {
    return is_power_ ? power(similarity / largest_, exponent_)
                     : exponential(exponent_ * (similarity - largest_));
  }

  bool is_power_;
  double exponent_;
  std::optional<unsigned> whole_exponent_;
  double largest_;
};

}  // namespace

float similarity_at(double squared_distance) {
  return static_cast<float>(1.0 / (1.0 + std::sqrt(squared_distance)));
}

void similarities_of_squares(AlignedVector<float>& values, double left_out) {
  kernels::activity_table().similarities(values.data(), lines_of(values), left_out);
}

void activity_of_similarities(const SomParameters& parameters, std::span<float> values) {
  AlignedVector<float> lines((values.size() + kLine - 1) / kLine * kLine);
  std::copy(values.begin(), values.end(), lines.begin());
  activity_of_similarities(parameters, lines, values.size());
  std::copy_n(lines.begin(), values.size(), values.begin());
}

void activity_of_similarities(const SomParameters& parameters, AlignedVector<float>& values,
                              std::size_t count) {
  std::fill(values.begin() + static_cast<std::ptrdiff_t>(count), values.end(), 0.0F);
  const auto& kernels = kernels::activity_table();
  const float largest = kernels.rectify(values.data(), lines_of(values));
  if (parameters.softmax == Softmax::kPower && largest == 0.0F) return;
  const SoftmaxTerms terms(parameters, largest);
  if (parameters.activity_norm == ActivityNorm::kMaximum) return terms.replace(values);
  const double sum = terms.replace_and_sum(values, count);
  kernels.divide(values.data(), lines_of(values), sum);
}

}  // namespace somato
