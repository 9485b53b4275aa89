#include "bodies/physics/biquad.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace somato::detail {
namespace {

constexpr double kRate = 8000.0;

// The gain at a frequency: the Fourier sum of the response to one pulse, written out.
template <typename Filter>
double gain_at(Filter filter, double frequency) {
  std::complex<double> sum = 0.0;
  for (int i = 0; i < 40000; ++i) {
    const double angle = -2.0 * std::numbers::pi * frequency * i / kRate;
    sum += filter(i == 0 ? 1.0 : 0.0) * std::polar(1.0, angle);
  }
  return std::abs(sum);
}

// The frequency of the analogue filter that the bilinear transform puts at `frequency`.
double analogue(double frequency) {
  return std::tan(std::numbers::pi * frequency / kRate);
}

TEST(Biquad, LowPassHasTheGainOfItsAnalogueFilter) {
  const double quality = 6.0;
  const auto filter = Biquad::low_pass(900.0, quality, kRate);
  for (const double frequency : {0.0, 100.0, 850.0, 900.0, 1500.0, 3900.0}) {
    const double s = analogue(frequency) / analogue(900.0);
    const double expected = 1.0 / std::abs(std::complex<double>(1.0 - s * s, s / quality));
    EXPECT_NEAR(gain_at(filter, frequency), expected, 1e-9 * quality) << frequency;
  }
}

TEST(Biquad, HighPassHasTheGainOfItsAnalogueFilter) {
  const double quality = 0.7;
  const auto filter = Biquad::high_pass(20.0, quality, kRate);
  for (const double frequency : {0.0, 5.0, 20.0, 100.0, 3000.0}) {
    const double s = analogue(frequency) / analogue(20.0);
    const double expected = s * s / std::abs(std::complex<double>(1.0 - s * s, s / quality));
    EXPECT_NEAR(gain_at(filter, frequency), expected, 1e-9) << frequency;
  }
}

TEST(Biquad, ButterworthFallsAsItsOrderSays) {
  const auto all = [sections = butterworth_low_pass(1000.0, 4, kRate)](double value) mutable {
    for (Biquad& section : sections) value = section(value);
    return value;
  };
  for (const double frequency : {0.0, 500.0, 1000.0, 1500.0, 2000.0}) {
    const double s = analogue(frequency) / analogue(1000.0);
    const double expected = 1.0 / std::sqrt(1.0 + std::pow(s, 16.0));
    EXPECT_NEAR(gain_at(all, frequency), expected, 1e-9) << frequency;
  }
}

}  // namespace
}  // namespace somato::detail
