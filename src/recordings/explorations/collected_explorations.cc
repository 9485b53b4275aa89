#include "recordings/explorations/collected_explorations.h"

namespace somato {

Result<void> CollectedExplorations::begin_exploration(const ExplorationStart& start) {
  start_ = start;
  channels_.assign(start.channels.size(), {});
  return {};
}

Result<void> CollectedExplorations::frame(std::size_t channel, std::span<const float> values,
                                          double time, std::span<const std::uint8_t> valid) {
  channels_[channel].frames.add(values, valid, time);
  channels_[channel].elements = values.size();
  return {};
}

Result<void> CollectedExplorations::end_exploration() {
  Exploration exploration{std::move(start_.labels), std::move(start_.source), {}};
  exploration.channels.reserve(channels_.size());
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    ChannelDescription description = start_.channels[i];
    description.times_known = description.times_known && description.rate == 0.0;
    exploration.channels.push_back(channels_[i].frames.take(description, channels_[i].elements));
  }
  return take_(std::move(exploration));
}

}  // namespace somato
