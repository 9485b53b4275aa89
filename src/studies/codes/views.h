#pragma once

#include <array>
#include <cstddef>

#include "somato/core/samples.h"
#include "somato/recording/recording.h"

namespace somato {

/// The frames of an exploration that a representation is computed from.
enum class View { kWhole, kOdd, kEven, kFirst, kSecond };

inline constexpr std::size_t kViews = 5;

/// A value for each view.
template <typename T>
class PerView {
 public:
  T& operator[](View view) { return values_[static_cast<std::size_t>(view)]; }
  const T& operator[](View view) const { return values_[static_cast<std::size_t>(view)]; }

 private:
  std::array<T, kViews> values_{};
};

inline constexpr std::array<View, kViews> kAllViews{View::kWhole, View::kOdd, View::kEven,
                                                    View::kFirst, View::kSecond};

/// From which half of the frames which other half is predicted.
struct Split {
  View from;
  View to;
};

inline constexpr std::array<Split, 4> kSplits{Split{View::kOdd, View::kEven},
                                              {View::kEven, View::kOdd},
                                              {View::kFirst, View::kSecond},
                                              {View::kSecond, View::kFirst}};

/// The explorations with only the frames of the view: the odd ones (the first, the third, and so
/// on), the even ones, or the first or second half; with an odd number of frames the one in the
/// middle belongs to both halves. A single frame belongs to every view. Channels keep their rates,
/// so that frequencies are relative to the number of frames; times are removed.
Recording seen_in(const Recording& recording, View view);

/// The vectors with only the elements of the view, divided as the frames of an exploration are: for
/// senses whose explorations have one frame. Vectors of a single element, and sparse ones, belong
/// to every view.
Samples seen_in(const Samples& vectors, View view);

}  // namespace somato
