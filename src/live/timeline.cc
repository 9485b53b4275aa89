#include "live/timeline.h"

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

template <typename Number>
Matrix<Number> first_rows(const Matrix<Number>& whole, std::size_t rows) {
  const auto values = whole.values().first(rows * whole.columns());
  return Matrix<Number>(rows, whole.columns(), std::vector<Number>(values.begin(), values.end()));
}

}  // namespace

Timeline::Timeline(const Exploration& exploration) {
  channel_frames_.reserve(exploration.channels.size());
  rates_.reserve(exploration.channels.size());
  for (const Channel& channel : exploration.channels) {
    channel_frames_.push_back(channel.frames.rows());
    rates_.push_back(channel.frame_rate());
  }
  const Channel* main = longest(exploration);
  if (main == nullptr || main->frames.rows() == 0) return;
  most_frames_ = main->frames.rows();
  const double rate = main->frame_rate();
  if (rate > kMomentsPerSecond) stretch_ = static_cast<std::size_t>(std::lround(rate / kMoments));
  moments_ = (most_frames_ + stretch_ - 1) / stretch_;
  times_.reserve(moments_);
  for (std::size_t moment = 0; moment < moments_; ++moment) {
    times_.push_back(time_of(*main, std::min((moment + 1) * stretch_, most_frames_) - 1, moment));
  }
}

// A channel with fewer frames is taken to be spread over the same time, as far as it is full.
std::size_t Timeline::frames(std::size_t channel, std::size_t moment) const {
  const std::size_t come = std::min((moment + 1) * stretch_, most_frames_);
  const std::size_t all = channel_frames_[channel];
  return all == most_frames_ ? come : all * come / most_frames_;
}

Exploration cut_at(const Exploration& exploration, const Timeline& timeline, std::size_t moment) {
  Exploration cut;
  cut.labels = exploration.labels;
  cut.source = exploration.source;
  for (std::size_t i = 0; i < exploration.channels.size(); ++i) {
    const Channel& whole = exploration.channels[i];
    const std::size_t rows = timeline.frames(i, moment);
    Channel channel{whole.name, whole.unit, whole.element_names, first_rows(whole.frames, rows),
                    {},         whole.rate, whole.shape,         {}};
    if (!whole.times.empty())
      channel.times.assign(whole.times.begin(),
                           whole.times.begin() + static_cast<std::ptrdiff_t>(rows));
    if (!whole.valid.empty()) channel.valid = first_rows(whole.valid, rows);
    cut.channels.push_back(std::move(channel));
  }
  return cut;
}

}  // namespace somato::live
