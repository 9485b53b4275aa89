#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "somato/recording/recording.h"
#include "somato/suggestion/suggestion.h"

namespace somato {

/// The role of each channel before any comparison: constant, setting or sense. If no channel
/// changes during an exploration, those that differ between explorations are senses.
std::vector<ChannelRole> roles_of(const Recording& recording);

/// The channel with the speed of a stroke: the first one of a single element with the unit mm/s
/// that is not constant.
std::optional<std::size_t> find_speed(const Recording& recording,
                                      const std::vector<ChannelRole>& roles);

}  // namespace somato
