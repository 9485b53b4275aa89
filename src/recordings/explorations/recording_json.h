#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "somato/recording/recording.h"

namespace somato::detail {

// The parts of a recording that both pages show.

/// An object with the value of each label by its name.
nlohmann::ordered_json labels_json(const std::vector<Label>& labels);

/// A channel as ChannelData of web/schema/parts.json. Elements without names get their numbers,
/// from 1.
nlohmann::ordered_json channel_json(const std::string& name, const std::string& unit,
                                    const std::vector<std::string>& elements,
                                    const std::vector<std::size_t>& shape);

/// The same for a channel of a recording.
nlohmann::ordered_json channel_json(const Channel& channel);

}  // namespace somato::detail
