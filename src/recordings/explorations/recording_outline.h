#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "somato/recording/frame_sink.h"
#include "somato/recording/layout.h"

namespace somato {

/// The number and rate of the frames of a channel in an exploration.
struct ChannelExtent {
  std::size_t frames = 0;
  double rate = 0.0;  ///< See Channel::frame_rate().
};

/// An exploration without its frames.
struct ExplorationOutline {
  std::vector<Label> labels;
  std::vector<ChannelExtent> channels;
};

/// The outlines of all explorations of a recording.
std::vector<ExplorationOutline> outlines_of(const Recording& recording);

/// The layout of the recording with these outlines; `first` is its first exploration with at least
/// one frame of each channel.
RecordingLayout layout_of(const Exploration& first,
                          const std::vector<ExplorationOutline>& explorations);

/// Notes the outlines of explorations and forgets their frames. The rate of a channel with times is
/// that of its first 65536 steps.
class RecordingOutline final : public FrameSink {
 public:
  const std::vector<ExplorationOutline>& explorations() const { return explorations_; }

  Result<void> begin_exploration(const ExplorationStart& start) override;
  Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                     std::span<const std::uint8_t> valid) override;
  Result<void> end_exploration() override;

 private:
  // A channel of the exploration that is open.
  struct ChannelTimes {
    bool are_known = false;
    double latest = 0.0;
    std::vector<double> steps;
  };

  std::vector<ExplorationOutline> explorations_;
  std::vector<ChannelTimes> times_;
};

namespace detail {

/// The frames per second of a channel with these steps between its times: the inverse of their
/// median, or 0 if there are none or it is 0.
double rate_of_steps(std::vector<double> steps);

}  // namespace detail

}  // namespace somato
