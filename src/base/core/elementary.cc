#include "base/core/elementary.h"

#include <array>
#include <cmath>
#include <limits>

namespace somato {
namespace {

constexpr double kLog2High = 0x1.62e42fefa3800p-1;     // log(2), its low bits zero
constexpr double kLog2Low = 0x1.ef35793c76730p-45;     // log(2) - kLog2High
constexpr double kLog2Inverse = 0x1.71547652b82fep+0;  // 1 / log(2)

template <std::size_t Terms>
double horner(const std::array<double, Terms>& coefficients, double x) {
  double sum = coefficients[Terms - 1];
  for (std::size_t i = Terms - 1; i-- > 0;) sum = std::fma(sum, x, coefficients[i]);
  return sum;
}

// 1/k! for k = 0 .. 13: the remainder on |x| <= log(2)/2 is below 2^-57.
constexpr std::array<double, 14> inverse_factorials() {
  std::array<double, 14> terms{};
  double factorial = 1.0;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if (k > 0) factorial *= static_cast<double>(k);
    terms[k] = 1.0 / factorial;
  }
  return terms;
}

// 2/(2k+1) for k = 1 .. 11: log((1+s)/(1-s)) = 2s + s * sum of these times s^2k.
constexpr std::array<double, 11> odd_reciprocals() {
  std::array<double, 11> terms{};
  for (std::size_t k = 0; k < terms.size(); ++k) terms[k] = 2.0 / static_cast<double>(2 * k + 3);
  return terms;
}

constexpr double kTwoPi = 0x1.921fb54442d18p+2;

// (-1)^k / (2k + Odd)! for k = 0 .. 8: cosine (Odd = 0) and sine (Odd = 1) as series in x^2; on
// |x| <= pi/4 the remainder is below 2^-59.
template <std::size_t Odd>
constexpr std::array<double, 9> alternating_inverse_factorials() {
  std::array<double, 9> terms{};
  double factorial = 1.0;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if (k > 0) factorial *= static_cast<double>((2 * k + Odd - 1) * (2 * k + Odd));
    terms[k] = (k % 2 == 0 ? 1.0 : -1.0) / factorial;
  }
  return terms;
}

}  // namespace

double exponential(double x) {
  static constexpr auto kTerms = inverse_factorials();
  if (std::isnan(x)) return x;
  if (x > 709.79) return std::numeric_limits<double>::infinity();
  if (x < -745.14) return 0.0;
  const double multiple = std::floor(std::fma(x, kLog2Inverse, 0.5));
  double rest = std::fma(-multiple, kLog2High, x);
  rest = std::fma(-multiple, kLog2Low, rest);
  return std::ldexp(horner(kTerms, rest), static_cast<int>(multiple));
}

double natural_log(double x) {
  static constexpr auto kTerms = odd_reciprocals();
  if (std::isnan(x) || x < 0.0) return std::numeric_limits<double>::quiet_NaN();
  if (x == 0.0) return -std::numeric_limits<double>::infinity();
  if (std::isinf(x)) return x;
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);  // in [0.5, 1)
  if (mantissa < 0x1.6a09e667f3bcdp-1) {       // below sqrt(1/2)
    mantissa *= 2.0;
    --exponent;
  }
  // log(1+f) = f - s*(f - tail), with s = f/(2+f): the large part f is exact.
  const double f = mantissa - 1.0;
  const double s = f / (2.0 + f);
  const double square = s * s;
  const double tail = square * horner(kTerms, square);
  const double correction = s * (f - tail);
  const double count = exponent;
  return std::fma(count, kLog2High, f - (correction - count * kLog2Low));
}

double power(double base, double exponent) {
  if (exponent == 0.0) return 1.0;
  if (base == 0.0 && exponent > 0.0) return 0.0;
  return exponential(exponent * natural_log(base));
}

double cosine_of_turns(double turns) {
  static constexpr auto kCosine = alternating_inverse_factorials<0>();
  static constexpr auto kSine = alternating_inverse_factorials<1>();
  if (!std::isfinite(turns)) return std::numeric_limits<double>::quiet_NaN();
  const double part = std::fabs(turns - std::nearbyint(turns));  // 0 to 1/2, exact
  const double folded = part > 0.25 ? 0.5 - part : part;         // 0 to 1/4, exact
  const double sign = part > 0.25 ? -1.0 : 1.0;
  const double x = kTwoPi * (folded > 0.125 ? 0.25 - folded : folded);
  return sign * (folded > 0.125 ? x * horner(kSine, x * x) : horner(kCosine, x * x));
}

}  // namespace somato
