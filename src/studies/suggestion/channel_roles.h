#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "somato/recording/recording.h"
#include "studies/suggestion/suggestion.h"

namespace somato {

/// The role of each channel before any comparison: constant, setting or sense. A channel that does
/// not change during any exploration of several frames is a setting, and so is the speed. If no
/// channel is a sense, the settings are.
std::vector<ChannelRole> roles_of(const Recording& recording);

/// The channel with the speed of a stroke: the first one of a single element with the unit mm/s
/// that is not constant.
std::optional<std::size_t> find_speed(const Recording& recording);

}  // namespace somato
