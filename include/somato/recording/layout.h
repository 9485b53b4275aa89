#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/recording/recording.h"

namespace somato {

/// What a channel is like in every exploration of a recording.
struct ChannelLayout {
  std::string name;
  std::string unit;
  std::vector<std::size_t> shape;  ///< Of a frame, row-major.
  std::vector<std::string> element_names;
  /// The first channel that has as many frames as this one in every exploration: their frames can
  /// be put together.
  std::string clock;

  bool operator==(const ChannelLayout&) const = default;
};

/// What all explorations of a recording have in common.
struct RecordingLayout {
  std::vector<ChannelLayout> channels;
  std::size_t explorations = 0;
  std::size_t frames = 0;  ///< Of the channel with most frames, in all explorations together.
};

/// The layout of a recording, which must be valid.
RecordingLayout layout_of(const Recording& recording);

}  // namespace somato
