#include "hardware/devices/sample_queue.h"

#include "somato/core/check.h"

namespace somato::devices {

void SampleQueue::receive(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    if (half_ < 0) {
      half_ = byte;
      continue;
    }
    add(static_cast<std::int16_t>(static_cast<std::uint16_t>(half_ | (byte << 8))));
    half_ = -1;
  }
}

void SampleQueue::add(std::int16_t sample) {
  ++received_;
  if (size_ == samples_.size()) keep(size_ - 1);
  samples_[(first_ + size_++) % samples_.size()] = sample;
}

void SampleQueue::take(std::span<float> to) {
  require(to.size() <= size_, "SampleQueue::take: fewer samples have arrived");
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i] = static_cast<float>(samples_[(first_ + i) % samples_.size()]);
  }
  keep(size_ - to.size());
}

void SampleQueue::keep(std::size_t count) {
  if (count >= size_) return;
  first_ = (first_ + size_ - count) % samples_.size();
  size_ = count;
}

}  // namespace somato::devices
