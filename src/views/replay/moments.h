#pragma once

#include <cstddef>
#include <vector>

#include "recordings/explorations/recording_outline.h"

namespace somato::live {

/// The moments of a whole exploration: the frames of its channel with most frames, or stretches of
/// them where there are more than sixty a second. A channel with fewer frames is taken to be spread
/// over the same time, as far as it is full.
class Moments {
 public:
  explicit Moments(const std::vector<ChannelExtent>& channels);

  std::size_t count() const { return stretch_ == 0 ? 0 : (most_ + stretch_ - 1) / stretch_; }

  /// The number of the channel with most frames; there must be moments.
  std::size_t longest() const { return longest_; }

  /// The frames of a channel that have come when that moment is over.
  std::size_t frames(std::size_t channel, std::size_t moment) const;

 private:
  std::vector<std::size_t> frames_;  // of each channel
  std::size_t longest_ = 0;
  std::size_t most_ = 0;
  std::size_t stretch_ = 0;  // Frames of the longest channel in a moment.
};

/// Seconds between moments of unknown times.
inline constexpr double kUnknownStep = 0.1;

}  // namespace somato::live
