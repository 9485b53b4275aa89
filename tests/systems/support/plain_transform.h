#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

namespace somato::testing {

/// |X_k|^2 for k = 0 .. length / 2, every term written out.
inline std::vector<double> plain_squares(const std::vector<double>& values) {
  const std::size_t length = values.size();
  std::vector<double> squares;
  for (std::size_t k = 0; k <= length / 2; ++k) {
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < length; ++i) {
      const double turns = static_cast<double>(i * k % length) / static_cast<double>(length);
      sum += values[i] * std::polar(1.0, -2.0 * std::numbers::pi * turns);
    }
    squares.push_back(std::norm(sum));
  }
  return squares;
}

}  // namespace somato::testing
