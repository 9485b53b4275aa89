#include "views/replay/timeline.h"

#include <vector>

#include "views/replay/moments.h"

namespace somato::live {
namespace {

double time_of(const Channel& channel, std::size_t frame, std::size_t moment) {
  if (!channel.times.empty()) return channel.times[frame] - channel.times.front();
  if (channel.rate > 0.0) return static_cast<double>(frame) / channel.rate;
  return kUnknownStep * static_cast<double>(moment);
}

}  // namespace

Timeline::Timeline(const Exploration& exploration) {
  std::vector<ChannelExtent> extents;
  extents.reserve(exploration.channels.size());
  for (const Channel& channel : exploration.channels) {
    extents.push_back({channel.frames.rows(), channel.frame_rate()});
    rates_.push_back(extents.back().rate);
  }
  dropped_.resize(rates_.size());
  const Moments moments(extents);
  std::vector<std::size_t> come(extents.size());
  for (std::size_t moment = 0; moment < moments.count(); ++moment) {
    for (std::size_t i = 0; i < come.size(); ++i) come[i] = moments.frames(i, moment);
    const std::size_t longest = moments.longest();
    append(time_of(exploration.channels[longest], come[longest] - 1, moment), come);
  }
}

void Timeline::drop_before(std::size_t first) {
  if (first <= first_) return;
  for (std::size_t i = 0; i < rates_.size(); ++i) {
    const std::size_t before = frames(i, first - 1);
    dropped_[i] = before > 0 && frames(i, first) == before ? before - 1 : before;
  }
  const auto moments = static_cast<std::ptrdiff_t>(first - first_);
  times_.erase(times_.begin(), times_.begin() + moments);
  frames_.erase(frames_.begin(),
                frames_.begin() + moments * static_cast<std::ptrdiff_t>(rates_.size()));
  first_ = first;
}

void Timeline::append(double time, std::span<const std::size_t> frames) {
  times_.push_back(time);
  frames_.insert(frames_.end(), frames.begin(), frames.end());
}

}  // namespace somato::live
