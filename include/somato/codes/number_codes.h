#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "somato/codes/one_hot.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/signal.h"

namespace somato {

/// Representation of the level of a number as elements that are 0 or 1.
enum class NumberCodeKind {
  kBinary,       ///< Binary digits; a small step may change many of them (0111 to 1000).
  kGray,         ///< Digits of the reflected Gray code: neighbouring levels differ in one.
  kThermometer,  ///< Level l has the first l elements on: the number of differing elements is the
                 ///< distance.
};

template <>
struct Choices<NumberCodeKind> {
  static const std::vector<std::pair<NumberCodeKind, std::string>>& all();
};

/// The parameters of a number code.
struct NumberCodeParameters {
  NumberCodeKind code = NumberCodeKind::kBinary;
  double low = 0.0;
  double high = 1.0;
  std::size_t bits = 18;
  OutsideRange outside = OutsideRange::kRefuse;

  static const Declarations<NumberCodeParameters>& declarations();

  /// Whether the parameters are consistent. Errors (kUsage): 'low' not below 'high' in single
  /// precision; no bits, more than 24 of a binary or Gray code, or more than 2^20.
  Result<void> validate() const;
};

/// Codes a number as `bits` elements that are 0 or 1, most significant first, like the 18 raw bits
/// of the hardness probe (P11 section IV-C; order, offset and scale are not given in the paper).
///
/// [low, high] is divided into equal levels, which contain values like the bins of OneHot: limits
/// and edges are compared in single precision, so that some levels never occur if the spacing of
/// floating-point numbers is larger than a level.
class NumberCode {
 public:
  /// Throws InvalidArgument for parameters that NumberCodeParameters::validate() refuses.
  explicit NumberCode(const NumberCodeParameters& parameters);

  std::size_t bits() const { return parameters_.bits; }

  /// 2^bits, or bits + 1 for a thermometer.
  std::uint32_t levels() const;

  /// The level of `value`, from 0. Errors (kData): NaN, and with `refuse` a value outside the
  /// range.
  Result<std::uint32_t> level(float value) const;

  /// A dense signal of shape {bits} for level(value); the same errors.
  Result<Signal> encode(float value) const;

  /// The same into `out`, which has bits() values; throws InvalidArgument for another size.
  Result<void> encode(float value, std::span<float> out) const;

 private:
  float edge(std::uint32_t level) const;

  NumberCodeParameters parameters_;
};

}  // namespace somato
