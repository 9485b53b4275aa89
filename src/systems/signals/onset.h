#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"

namespace somato {

/// The quantity of an element that is compared with the threshold of an onset.
enum class OnsetQuantity {
  kValue,      ///< Its value.
  kMagnitude,  ///< Its value without the sign.
  kChange,     ///< Its distance from its value in the first frame, so that an offset is no onset.
};

template <>
struct Choices<OnsetQuantity> {
  static const std::vector<std::pair<OnsetQuantity, std::string>>& all();
};

/// Values of a window beyond the frames.
enum class BeyondFrames {
  kRefuse,  ///< It is an error.
  kHold,    ///< The first frame before the start, the last one after the end.
};

template <>
struct Choices<BeyondFrames> {
  static const std::vector<std::pair<BeyondFrames, std::string>>& all();
};

/// The parameters of an onset and of the window around it. Not given in the papers, whose
/// explorations start and end with the movement of the hand.
struct OnsetParameters {
  std::size_t element = 0;
  OnsetQuantity quantity = OnsetQuantity::kChange;
  double threshold = 1.0;
  std::size_t before = 0;
  std::size_t length = 1;
  BeyondFrames beyond = BeyondFrames::kRefuse;

  static const Declarations<OnsetParameters>& declarations();
};

/// The first of `frames` (frames x elements), counted from 0, in which the quantity of the element,
/// or of any element, reaches the threshold.
///
/// Errors: no frame does (kData, with the greatest value there is); there is no such element
/// (kUsage).
Result<std::size_t> find_onset(const Matrix<float>& frames, const OnsetParameters& parameters);

/// `length` frames, the first of them `before` frames before the onset: aligns explorations by
/// their contact. Output: length x elements.
///
/// Errors: those of find_onset(); with `refuse`, a window that extends beyond the frames (kData).
/// Throws InvalidArgument for a length of 0.
Result<Matrix<float>> window_at_onset(const Matrix<float>& frames,
                                      const OnsetParameters& parameters);

}  // namespace somato
