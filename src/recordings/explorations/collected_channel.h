#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "somato/recording/recording.h"

namespace somato {

/// The frames of a channel as they come.
class CollectedChannel {
 public:
  /// Adds a frame. `valid` is empty if all is valid.
  void add(std::span<const float> values, std::span<const std::uint8_t> valid, double time);

  std::size_t frames() const { return times_.size(); }

  /// The channel with `elements` elements, and nothing collected afterwards.
  Channel take(const ChannelDescription& description, std::size_t elements);

 private:
  std::vector<float> values_;
  std::vector<double> times_;
  std::vector<std::uint8_t> valid_;  // Empty until something is not.
};

}  // namespace somato
