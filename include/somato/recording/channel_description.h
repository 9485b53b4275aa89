#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/recording/recording.h"

namespace somato {

/// What is known about a channel before its frames come; see Channel.
struct ChannelDescription {
  std::string name;
  std::string unit;
  std::vector<std::string> element_names;
  std::vector<std::size_t> shape;
  double rate = 0.0;
  bool times_known = true;  ///< Whether the frames' times mean anything; with a rate they do not.

  bool operator==(const ChannelDescription&) const = default;
};

/// The description of `channel`.
inline ChannelDescription description_of(const Channel& channel) {
  return {channel.name,  channel.unit, channel.element_names,
          channel.shape, channel.rate, !channel.times.empty()};
}

}  // namespace somato
