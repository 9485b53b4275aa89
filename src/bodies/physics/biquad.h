#pragma once

#include <vector>

namespace somato::detail {

/// A linear filter of second order, one value in and one out; the same bits everywhere.
class Biquad {
 public:
  /// Passes what lies below `frequency` (Hz, below half of `rate`): its gain is 1 at 0 Hz and
  /// `quality` at the frequency, around which a quality above 0.7 makes it ring. It is the analogue
  /// filter 1 / (s^2 + s / quality + 1), brought to the sampled world by the bilinear transform.
  static Biquad low_pass(double frequency, double quality, double rate);

  /// The same with s^2 in the numerator: a high-pass filter.
  static Biquad high_pass(double frequency, double quality, double rate);

  double operator()(double value) {
    const double out = b0_ * value + first_;
    first_ = b1_ * value - a1_ * out + second_;
    second_ = b0_ * value - a2_ * out;
    return out;
  }

 private:
  Biquad() = default;

  // Numerator b0, b1, b0; denominator 1, a1, a2.
  double b0_ = 0.0;
  double b1_ = 0.0;
  double a1_ = 0.0;
  double a2_ = 0.0;
  double first_ = 0.0;
  double second_ = 0.0;
};

/// A Butterworth low-pass of order 2 x `sections`, to be applied one after the other.
std::vector<Biquad> butterworth_low_pass(double frequency, std::size_t sections, double rate);

}  // namespace somato::detail
