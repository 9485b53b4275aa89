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
  explicit Timeline(std::vector<double> rates)
      : rates_(std::move(rates)), dropped_(rates_.size()) {}

  /// Those of a whole exploration: the frames of its channel with most frames, or stretches of them
  /// where there are more than sixty a second.
  explicit Timeline(const Exploration& exploration);

  /// Adds a moment: its time, and how many frames each channel has given until then.
  void append(double time, std::span<const std::size_t> frames);

  /// The moments before `first`, one of them, are dropped.
  void drop_before(std::size_t first);

  /// The number of moments; those from first() on are kept.
  std::size_t moments() const { return first_ + times_.size(); }
  std::size_t first() const { return first_; }

  /// Seconds from the first moment's beginning; ten moments per second if unknown.
  double time(std::size_t moment) const { return times_[moment - first_]; }

  /// Frames per second of the channel; 0 if unknown.
  double rate(std::size_t channel) const { return rates_[channel]; }

  /// The number of frames of the channel that have come when that moment is over.
  std::size_t frames(std::size_t channel, std::size_t moment) const {
    return frames_[(moment - first_) * rates_.size() + channel];
  }

  /// The number of the oldest frames of the channel that no kept moment needs: a moment without a
  /// new frame shows the one before.
  std::size_t dropped(std::size_t channel) const { return dropped_[channel]; }
  const std::vector<std::size_t>& dropped() const { return dropped_; }

 private:
  std::vector<double> rates_;  // of each channel
  std::vector<double> times_;
  std::vector<std::size_t> frames_;   // moments x channels
  std::vector<std::size_t> dropped_;  // of each channel
  std::size_t first_ = 0;
};

}  // namespace somato::live
