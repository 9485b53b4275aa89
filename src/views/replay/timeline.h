#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "somato/recording/recording.h"

namespace somato::live {

/// The moments of an exploration, one after the other as they are shown. More may come.
class Timeline {
 public:
  /// Without moments; the channels have these rates, frames a second, or 0 where they have none.
  explicit Timeline(std::vector<double> rates) : rates_(std::move(rates)) {}

  /// Those of a whole exploration: the frames of its channel with most frames, or stretches of them
  /// where there are more than sixty a second.
  explicit Timeline(const Exploration& exploration);

  /// Adds a moment: its time, and how many frames each channel has given until then.
  void append(double time, std::span<const std::size_t> frames);

  std::size_t moments() const { return times_.size(); }

  /// Seconds from the first moment's beginning; ten moments per second if unknown.
  double time(std::size_t moment) const { return times_[moment]; }

  /// Frames per second of the channel; 0 if unknown.
  double rate(std::size_t channel) const { return rates_[channel]; }

  /// The number of frames of the channel that have come when that moment is over.
  std::size_t frames(std::size_t channel, std::size_t moment) const {
    return frames_[moment * rates_.size() + channel];
  }

 private:
  std::vector<double> rates_;  // of each channel
  std::vector<double> times_;
  std::vector<std::size_t> frames_;  // moments x channels
};

}  // namespace somato::live
