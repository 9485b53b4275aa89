#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/recording/recording.h"

namespace somato {

/// Properties of a channel that are the same in every exploration of a recording.
struct ChannelLayout {
  std::string name;
  std::string unit;
  std::vector<std::size_t> shape;  ///< The shape of a frame, in row-major order.
  std::vector<std::string> element_names;
  /// The first channel that has the same number of frames as this one in every exploration: their
  /// frames can be combined.
  std::string clock;

  bool operator==(const ChannelLayout&) const = default;
};

/// Properties shared by all explorations of a recording.
struct RecordingLayout {
  std::vector<ChannelLayout> channels;
  std::size_t explorations = 0;
  std::size_t frames = 0;  ///< Total number in all explorations, of the channel with most frames.
  /// Frames per second of each channel in the first exploration, 0 if unknown; or empty.
  std::vector<double> rates = {};
};

/// The layout of a recording, which must be valid.
RecordingLayout layout_of(const Recording& recording);

}  // namespace somato
