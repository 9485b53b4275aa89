#include "somato/recording/layout.h"

#include <algorithm>

namespace somato {
namespace {

std::vector<std::size_t> frames_of(const Recording& recording, std::size_t channel) {
  std::vector<std::size_t> frames;
  frames.reserve(recording.explorations.size());
  for (const Exploration& exploration : recording.explorations) {
    frames.push_back(exploration.channels[channel].frames.rows());
  }
  return frames;
}

FrameRates rates_of(const Recording& recording, std::size_t channel) {
  FrameRates rates;
  rates.first = recording.explorations.front().channels[channel].frame_rate();
  for (const Exploration& exploration : recording.explorations) {
    const double rate = exploration.channels[channel].frame_rate();
    if (rate <= 0.0) continue;
    rates.least = rates.least > 0.0 ? std::min(rates.least, rate) : rate;
    rates.most = std::max(rates.most, rate);
  }
  return rates;
}

}  // namespace

RecordingLayout layout_of(const Recording& recording) {
  RecordingLayout layout;
  layout.explorations = recording.explorations.size();
  if (recording.explorations.empty()) return layout;
  std::vector<std::vector<std::size_t>> frames;
  for (const Channel& channel : recording.explorations.front().channels) {
    frames.push_back(frames_of(recording, layout.channels.size()));
    const auto same = std::find(frames.begin(), frames.end(), frames.back()) - frames.begin();
    const auto first = static_cast<std::size_t>(same);
    layout.channels.push_back(
        {channel.name, channel.unit, channel.frame_shape(), channel.element_names,
         first + 1 < frames.size() ? layout.channels[first].name : channel.name});
    layout.rates.push_back(rates_of(recording, layout.rates.size()));
    std::size_t total = 0;
    for (const std::size_t count : frames.back()) total += count;
    layout.frames = std::max(layout.frames, total);
  }
  return layout;
}

}  // namespace somato
