#include "views/replay/timeline.h"

#include <algorithm>
#include <cmath>

namespace somato::live {
namespace {

constexpr double kMomentsPerSecond = 60.0;  // a second
constexpr double kMoments = 16.0;           // a second, of what has more frames
constexpr double kUnknown = 0.1;            // s

const Channel* longest(const Exploration& exploration) {
  const auto found = std::max_element(
      exploration.channels.begin(), exploration.channels.end(),
      [](const Channel& a, const Channel& b) { return a.frames.rows() < b.frames.rows(); });
  return found == exploration.channels.end() ? nullptr : &*found;
}

double time_of(const Channel& channel, std::size_t frame, std::size_t moment) {
  if (!channel.times.empty()) return channel.times[frame] - channel.times.front();
  if (channel.rate > 0.0) return static_cast<double>(frame) / channel.rate;
  return kUnknown * static_cast<double>(moment);
}

}  // namespace

// A channel with fewer frames is taken to be spread over the same time, as far as it is full.
Timeline::Timeline(const Exploration& exploration) {
  rates_.reserve(exploration.channels.size());
  for (const Channel& channel : exploration.channels) rates_.push_back(channel.frame_rate());
  dropped_.resize(rates_.size());
  const Channel* main = longest(exploration);
  if (main == nullptr) return;
  const std::size_t most = main->frames.rows();
  const double rate = main->frame_rate();
  const bool fast = rate > kMomentsPerSecond;
  const std::size_t stretch = fast ? static_cast<std::size_t>(std::lround(rate / kMoments)) : 1;
  std::vector<std::size_t> come(exploration.channels.size());
  for (std::size_t moment = 0; moment * stretch < most; ++moment) {
    const std::size_t end = std::min((moment + 1) * stretch, most);
    for (std::size_t i = 0; i < come.size(); ++i) {
      come[i] = exploration.channels[i].frames.rows() * end / most;
    }
    append(time_of(*main, end - 1, moment), come);
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
