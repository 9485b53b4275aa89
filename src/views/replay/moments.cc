#include "views/replay/moments.h"

#include <algorithm>
#include <cmath>

namespace somato::live {
namespace {

constexpr double kMomentsPerSecond = 60.0;
constexpr double kStretchesPerSecond = 16.0;  // Where a channel has more frames.

std::size_t stretch_of(double rate) {
  const bool is_fast = rate > kMomentsPerSecond;
  return is_fast ? static_cast<std::size_t>(std::lround(rate / kStretchesPerSecond)) : 1;
}

}  // namespace

Moments::Moments(const std::vector<ChannelExtent>& channels) {
  frames_.reserve(channels.size());
  for (const ChannelExtent& channel : channels) frames_.push_back(channel.frames);
  const auto longest = std::max_element(frames_.begin(), frames_.end());
  if (longest == frames_.end()) return;
  longest_ = static_cast<std::size_t>(longest - frames_.begin());
  most_ = *longest;
  stretch_ = stretch_of(channels[longest_].rate);
}

std::size_t Moments::frames(std::size_t channel, std::size_t moment) const {
  const std::size_t end = std::min((moment + 1) * stretch_, most_);
  return frames_[channel] * end / most_;
}

}  // namespace somato::live
