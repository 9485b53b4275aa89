#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace somato::devices {

/// The samples of a microphone, 16 bits each, little-endian, in order of arrival. It holds at most
/// a given number and then discards the oldest; nothing allocates after construction.
class SampleQueue {
 public:
  explicit SampleQueue(std::size_t capacity) : samples_(capacity) {}

  void receive(std::span<const std::uint8_t> bytes);

  std::size_t size() const { return size_; }

  /// All samples that were ever received.
  std::size_t received() const { return received_; }

  /// Takes the oldest samples into `to`, in counts; throws InvalidArgument if there are fewer.
  void take(std::span<float> to);

  /// Discards the oldest so that at most `count` remain.
  void keep(std::size_t count);

  /// Discards the newest so that at most `count` remain.
  void keep_oldest(std::size_t count) { size_ = std::min(size_, count); }

 private:
  void add(std::int16_t sample);

  std::vector<std::int16_t> samples_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  std::size_t received_ = 0;
  int half_ = -1;  // The first byte of a sample whose second has not arrived.
};

}  // namespace somato::devices
