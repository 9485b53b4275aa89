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

/// The frames per second of a channel in the explorations of a recording, 0 if unknown.
struct FrameRates {
  double first = 0.0;  ///< In the first exploration.
  double least = 0.0;  ///< In those where it is known.
  double most = 0.0;

  bool operator==(const FrameRates&) const = default;
};

/// Properties shared by all explorations of a recording.
struct RecordingLayout {
  std::vector<ChannelLayout> channels;
  std::size_t explorations = 0;
  std::size_t frames = 0;  ///< Total number in all explorations, of the channel with most frames.
  std::vector<FrameRates> rates = {};  ///< One for each channel; or empty.

  bool operator==(const RecordingLayout&) const = default;
};

/// The layout of a recording, which must be valid.
RecordingLayout layout_of(const Recording& recording);

}  // namespace somato
