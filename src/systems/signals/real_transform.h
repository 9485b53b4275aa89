#pragma once

#include <complex>
#include <cstddef>
#include <kissfft/kissfft.hh>
#include <span>
#include <vector>

namespace somato {

/// The discrete Fourier transform of real values, X_k = sum_i x_i exp(-2 pi i k / length), in
/// double precision. The plan contains scratch memory: each thread requires a copy.
class RealTransform {
 public:
  /// Throws InvalidArgument for the length 0.
  explicit RealTransform(std::size_t length);

  std::size_t length() const { return length_; }

  /// Frequencies from 0 to half a cycle a value.
  std::size_t bins() const { return length_ / 2 + 1; }

  /// Writes |X_k|^2 for k = 0 .. bins() - 1 to `squares`; throws InvalidArgument unless there are
  /// length() values and bins() squares.
  void squares(std::span<const double> values, std::span<double> squares);

 private:
  void transform_even(std::span<const double> values);
  void transform_odd(std::span<const double> values);

  std::size_t length_;
  kissfft<double> plan_;
  std::vector<std::complex<double>> input_;   // of an odd length only
  std::vector<std::complex<double>> output_;  // at least bins()
};

}  // namespace somato
