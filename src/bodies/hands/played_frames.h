#pragma once

#include <cstddef>
#include <string_view>

#include "somato/recording/recording.h"

namespace somato::detail {

/// The channel of that name when it has as many elements and any frames, else nullptr.
const Channel* played_channel(const Exploration& exploration, std::string_view name,
                              std::size_t elements);

/// The frames of the channel with most.
std::size_t most_frames(const Exploration& exploration);

/// The row of a channel, which has any, at a frame among most_frames(): slower channels are spread
/// over the same time. Later frames have the last row.
std::size_t played_row(const Exploration& exploration, const Channel& channel, std::size_t frame);

}  // namespace somato::detail
