#pragma once

#include <algorithm>
#include <string_view>

#include "somato/recording/recording.h"

namespace somato {

/// The channel that every exploration with true values of a simulation has (docs/exploring.md).
inline constexpr std::string_view kTrueDraws = "true_draws";

/// Whether a recording contains true values of a simulation, which no robot has.
inline bool has_true_values(const Recording& recording) {
  return std::ranges::any_of(recording.explorations, [](const Exploration& exploration) {
    return std::ranges::any_of(exploration.channels,
                               [](const Channel& channel) { return channel.name == kTrueDraws; });
  });
}

}  // namespace somato
