#include "recordings/explorations/collected_channel.h"

#include <utility>

namespace somato {

void CollectedChannel::add(std::span<const float> values, std::span<const std::uint8_t> valid,
                           double time) {
  if (!valid.empty() && valid_.empty()) valid_.resize(values_.size(), 1);
  values_.insert(values_.end(), values.begin(), values.end());
  times_.push_back(time);
  if (!valid.empty()) {
    valid_.insert(valid_.end(), valid.begin(), valid.end());
  } else if (!valid_.empty()) {
    valid_.resize(values_.size(), 1);
  }
}

Channel CollectedChannel::take(const ChannelDescription& description, std::size_t elements) {
  const std::size_t count = times_.size();
  Channel channel =
      channel_of(description, Matrix<float>(count, elements, std::exchange(values_, {})));
  std::vector<double> times = std::exchange(times_, {});
  if (description.times_known) channel.times = std::move(times);
  std::vector<std::uint8_t> valid = std::exchange(valid_, {});
  if (!valid.empty()) {
    channel.valid = Matrix<std::uint8_t>(count, elements, std::move(valid));
  }
  return channel;
}

}  // namespace somato
