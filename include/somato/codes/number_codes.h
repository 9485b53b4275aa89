#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "somato/codes/one_hot.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/signal.h"

namespace somato {

/// How the level of a number is written as elements that are 0 or 1.
enum class NumberCodeKind {
  kBinary,       ///< Its binary digits; a small step may turn many of them (0111 to 1000).
  kGray,         ///< Its digits in the reflected Gray code: neighbouring levels differ in one.
  kThermometer,  ///< Level l has the first l elements on: the further apart, the more differ.
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

  /// Whether the parameters fit each other. Errors (kUsage): 'low' not below 'high' in single
  /// precision; no bits, more than 24 of a binary or Gray code, or more than 2^20.
  Result<void> validate() const;
};

/// Codes a number as `bits` elements that are 0 or 1, most significant first, as the hardness probe
/// hands over 18 raw bits (P11 section IV-C; order, offset and scale are not given in the paper).
///
/// [low, high] is cut into equal levels, which hold their values as the bins of OneHot do: limits
/// and edges are compared in single precision, so that where numbers of that size are coarser than
/// a level some levels never occur.
class NumberCode {
 public:
  /// Throws InvalidArgument for what NumberCodeParameters::validate() refuses.
  explicit NumberCode(const NumberCodeParameters& parameters);

  std::size_t bits() const { return parameters_.bits; }

  /// 2^bits, or bits + 1 of a thermometer.
  std::uint32_t levels() const;

  /// The level of `value`, from 0. Errors (kData): NaN, and with `refuse` a value outside the
  /// range.
  Result<std::uint32_t> level(float value) const;

  /// A dense signal of shape {bits} for level(value); the same errors.
  Result<Signal> encode(float value) const;

 private:
  float edge(std::uint32_t level) const;

  NumberCodeParameters parameters_;
};

}  // namespace somato
