#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// The properties of an exploration that are known at its beginning.
struct ExplorationStart {
  std::vector<Label> labels;
  std::string source;
  std::vector<ChannelDescription> channels;
  double time = 0.0;  ///< Seconds, on the clock of its frames; not after any of them.
};

/// Takes explorations frame by frame, so that none needs to be in memory as a whole.
class FrameSink {
 public:
  FrameSink() = default;
  FrameSink(const FrameSink&) = delete;
  FrameSink(FrameSink&&) = default;
  FrameSink& operator=(const FrameSink&) = delete;
  FrameSink& operator=(FrameSink&&) = default;
  virtual ~FrameSink() = default;

  /// Begins an exploration; none is open.
  virtual Result<void> begin_exploration(const ExplorationStart& start) = 0;

  /// Adds a frame of the channel with that index in ExplorationStart::channels. Channels may be in
  /// any order, the frames of a channel are in the order of their times (s). All frames of a
  /// channel have the same number of values. An element with a 0 in `valid` (which may be empty) is
  /// invalid.
  virtual Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                             std::span<const std::uint8_t> valid) = 0;

  /// Ends the exploration that is open.
  virtual Result<void> end_exploration() = 0;
};

}  // namespace somato
