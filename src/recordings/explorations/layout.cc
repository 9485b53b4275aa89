#include "somato/recording/layout.h"

#include <algorithm>

#include "recordings/explorations/recording_outline.h"

namespace somato {
namespace {

std::vector<std::size_t> frames_of(const std::vector<ExplorationOutline>& explorations,
                                   std::size_t channel) {
  std::vector<std::size_t> frames;
  frames.reserve(explorations.size());
  for (const ExplorationOutline& exploration : explorations) {
    frames.push_back(exploration.channels[channel].frames);
  }
  return frames;
}

FrameRates rates_of(const std::vector<ExplorationOutline>& explorations, std::size_t channel) {
  FrameRates rates;
  rates.first = explorations.front().channels[channel].rate;
  for (const ExplorationOutline& exploration : explorations) {
    const double rate = exploration.channels[channel].rate;
    if (rate <= 0.0) continue;
    rates.least = rates.least > 0.0 ? std::min(rates.least, rate) : rate;
    rates.most = std::max(rates.most, rate);
  }
  return rates;
}

}  // namespace

RecordingLayout layout_of(const Exploration& first,
                          const std::vector<ExplorationOutline>& explorations) {
  RecordingLayout layout;
  layout.explorations = explorations.size();
  std::vector<std::vector<std::size_t>> frames;
  for (const Channel& channel : first.channels) {
    frames.push_back(frames_of(explorations, layout.channels.size()));
    const auto same = std::find(frames.begin(), frames.end(), frames.back()) - frames.begin();
    const auto clock = static_cast<std::size_t>(same);
    layout.channels.push_back(
        {channel.name, channel.unit, channel.frame_shape(), channel.element_names,
         clock + 1 < frames.size() ? layout.channels[clock].name : channel.name});
    layout.rates.push_back(rates_of(explorations, layout.rates.size()));
    std::size_t total = 0;
    for (const std::size_t count : frames.back()) total += count;
    layout.frames = std::max(layout.frames, total);
  }
  return layout;
}

RecordingLayout layout_of(const Recording& recording) {
  if (recording.explorations.empty()) return {};
  return layout_of(recording.explorations.front(), outlines_of(recording));
}

}  // namespace somato
