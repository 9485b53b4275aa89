#pragma once

#include <cstddef>
#include <vector>

#include "somato/recording/recording.h"

namespace somato::live {

/// An exploration in moments that follow each other as one looks on: the frames of its channel with
/// most frames, or stretches of them where there are more than sixty a second.
class Timeline {
 public:
  /// Nothing at all.
  Timeline() = default;
  explicit Timeline(const Exploration& exploration);

  std::size_t moments() const { return moments_; }

  /// Seconds from the first moment's beginning; where nobody knows, ten moments a second.
  double time(std::size_t moment) const { return times_[moment]; }

  /// Frames a second of the channel; 0 where nobody knows.
  double rate(std::size_t channel) const { return rates_[channel]; }

  /// How many frames of the channel have come when that moment is over.
  std::size_t frames(std::size_t channel, std::size_t moment) const;

 private:
  std::size_t moments_ = 0;
  std::size_t stretch_ = 1;                  ///< Frames a moment, of the channel with most.
  std::vector<std::size_t> channel_frames_;  ///< Of each channel.
  std::vector<double> rates_;                ///< Of each channel.
  std::size_t most_frames_ = 0;
  std::vector<double> times_;
};

/// The exploration as far as it went: what had come when that moment was over.
Exploration cut_at(const Exploration& exploration, const Timeline& timeline, std::size_t moment);

}  // namespace somato::live
