#include "systems/signals/real_transform.h"

#include <algorithm>

#include "somato/core/check.h"

namespace somato {
namespace {

bool is_even(std::size_t length) {
  return length % 2 == 0;
}

std::size_t plan_length(std::size_t length) {
  require(length > 0, "a transform needs a value");
  return is_even(length) ? length / 2 : length;
}

}  // namespace

RealTransform::RealTransform(std::size_t length)
    : length_(length),
      plan_(plan_length(length), false),
      input_(is_even(length) ? 0 : length),
      output_(is_even(length) ? bins() : length) {}

void RealTransform::squares(std::span<const double> values, std::span<double> squares) {
  require(values.size() == length_ && squares.size() == bins(),
          "a transform takes as many values as its length and returns one square per bin");
  is_even(length_) ? transform_even(values) : transform_odd(values);
  for (std::size_t k = 0; k < squares.size(); ++k) {
    const std::complex<double> x = output_[k];
    squares[k] = x.real() * x.real() + x.imag() * x.imag();
  }
}

// Half a complex transform; the first place holds the two real ends of the spectrum.
void RealTransform::transform_even(std::span<const double> values) {
  plan_.transform_real(values.data(), output_.data());
  output_.back() = output_.front().imag();
  output_.front() = output_.front().real();
}

void RealTransform::transform_odd(std::span<const double> values) {
  std::ranges::copy(values, input_.begin());
  plan_.transform(input_.data(), output_.data());
}

}  // namespace somato
