#include "recordings/explorations/collected_explorations.h"

#include "recordings/explorations/growing_channel.h"

namespace somato {

Result<void> CollectedExplorations::begin_exploration(const ExplorationStart& start) {
  start_ = start;
  channels_.assign(start.channels.size(), {});
  return {};
}

Result<void> CollectedExplorations::frame(std::size_t channel, std::span<const float> values,
                                          double time, std::span<const std::uint8_t> valid) {
  add_frame(channels_[channel], values, time, valid);
  return {};
}

Result<void> CollectedExplorations::end_exploration() {
  Exploration exploration{std::move(start_.labels), std::move(start_.source), {}};
  exploration.channels.reserve(channels_.size());
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    ChannelDescription description = start_.channels[i];
    description.times_known = description.times_known && description.rate == 0.0;
    exploration.channels.push_back(described(std::move(channels_[i]), description, 0));
  }
  return take_(std::move(exploration));
}

}  // namespace somato
