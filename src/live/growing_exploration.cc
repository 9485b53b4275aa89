#include "live/growing_exploration.h"

#include <utility>

#include "bodies/driving.h"

namespace somato::live {

GrowingExploration::GrowingExploration(const BodyDescription& body)
    : frames_(body.sensors.size(), 0) {
  exploration_.channels.reserve(body.sensors.size());
  for (const ChannelDescription& sensor : body.sensors) {
    Channel channel = detail::empty_channel(sensor);
    // What declares nothing, such as a height, is one number as far as anybody knows by now.
    if (channel.frames.columns() == 0) channel.frames = Matrix<float>(0, 1);
    exploration_.channels.push_back(std::move(channel));
  }
}

void GrowingExploration::append(const BodyState& state) {
  for (std::size_t i = 0; i < state.readings.size() && i < frames_.size(); ++i) {
    const Matrix<float>& taken = state.readings[i];
    if (taken.empty()) continue;
    Channel& channel = exploration_.channels[i];
    const auto before = channel.frames.values();
    std::vector<float> values(before.begin(), before.end());
    values.insert(values.end(), taken.values().begin(), taken.values().end());
    frames_[i] += taken.rows();
    channel.frames = Matrix<float>(frames_[i], taken.columns(), std::move(values));
    if (channel.rate == 0.0) channel.times.push_back(state.time);
  }
  moments_.push_back({state.time, frames_});
}

}  // namespace somato::live
