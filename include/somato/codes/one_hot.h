#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/signal.h"

namespace somato {

/// Treatment of a value outside the range of a one-hot code.
enum class OutsideRange {
  kRefuse,  ///< It is an error.
  kClamp,   ///< It is assigned to the nearest bin.
};

template <>
struct Choices<OutsideRange> {
  static const std::vector<std::pair<OutsideRange, std::string>>& all();
};

/// The parameters of a one-hot code.
struct OneHotParameters {
  double low = 0.0;
  double high = 1.0;
  std::size_t elements = 10;
  OutsideRange outside = OutsideRange::kRefuse;

  static const Declarations<OneHotParameters>& declarations();
};

/// Codes a value by the one of `elements` equal bins over [low, high] that contains it (P06
/// section 2.1 for wrist angle and height; ranges are not given in the paper).
///
/// A bin includes its lower edge, the last bin both. Limits and edges are compared in single
/// precision, the precision of recordings.
class OneHot {
 public:
  /// Throws InvalidArgument unless low < high and there are 1 to 2^20 elements.
  explicit OneHot(const OneHotParameters& parameters);

  std::size_t elements() const { return parameters_.elements; }

  /// The bin of `value`, from 0. Errors (kData): NaN, and with `refuse` a value outside the range.
  Result<std::uint32_t> bin(float value) const;

  /// A sparse signal of shape {elements} with a 1 at bin(value); the same errors.
  Result<Signal> encode(float value) const;

 private:
  OneHotParameters parameters_;
  std::vector<float> edges_;  // elements + 1 of them, from low to high
};

/// Codes several joints, each by a one-hot code over a separate range, concatenated. Six joints
/// with ten elements each form the 60 elements of the papers' joint code (P06 section 2.1, P11
/// section III-A; ranges are not given in the paper).
class OneHotSequence {
 public:
  /// Throws InvalidArgument without joints, or unless all have the same number of elements; see
  /// OneHot for each.
  explicit OneHotSequence(const std::vector<OneHotParameters>& joints);

  std::size_t joints() const { return codes_.size(); }

  /// A sparse signal of shape {joints, elements} with one 1 per joint. Errors (kData) as for
  /// OneHot, with the number of the joint, counted from 1; throws InvalidArgument unless there is
  /// one value per joint.
  Result<Signal> encode(std::span<const float> values) const;

  /// The same, flat, into `out`; does not allocate if `out` is large enough.
  Result<void> encode(std::span<const float> values, SignalBuffer& out) const;

 private:
  std::vector<OneHot> codes_;
};

}  // namespace somato
