#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace somato::wire {

/// Bytes received and not yet decoded, in order of arrival, in memory of a fixed size: a decoder
/// never allocates. When it is full, the oldest bytes are discarded.
template <std::size_t Capacity>
class ReceiveBuffer {
 public:
  /// Appends `bytes`; returns the number of bytes that had to be discarded.
  std::size_t put(std::span<const std::uint8_t> bytes) {
    std::size_t lost = 0;
    if (bytes.size() > Capacity) {
      lost = bytes.size() - Capacity;
      bytes = bytes.last(Capacity);
    }
    const std::size_t excess =
        size_ + bytes.size() > Capacity ? size_ + bytes.size() - Capacity : 0;
    drop(excess);
    std::copy(bytes.begin(), bytes.end(), bytes_.begin() + size_);
    size_ += bytes.size();
    return lost + excess;
  }

  /// Removes the oldest `count` bytes, at most all.
  void drop(std::size_t count) {
    count = std::min(count, size_);
    std::memmove(bytes_.data(), bytes_.data() + count, size_ - count);
    size_ -= count;
  }

  void clear() { size_ = 0; }

  /// Valid until the buffer changes.
  std::span<const std::uint8_t> bytes() const { return {bytes_.data(), size_}; }

 private:
  std::array<std::uint8_t, Capacity> bytes_{};
  std::size_t size_ = 0;
};

}  // namespace somato::wire
