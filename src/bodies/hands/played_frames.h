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

/// The value of an element at a row. Where it is missing, the last known one before it, else the
/// first known one after it, so that a pose does not jump to 0; 0 if none is known.
float played_value(const Channel& channel, std::size_t row, std::size_t element);

}  // namespace somato::detail
