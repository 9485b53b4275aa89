#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "maps/pictures/channel_places.h"

namespace somato {

/// As LayoutData of web/schema/parts.json.
nlohmann::ordered_json layout_json(const SkinPlaces& skin);

/// Adds the places of its elements to a channel, ChannelData of web/schema/parts.json, if the
/// layout has a table for it. Errors: those of places_for().
Result<void> add_places(const std::vector<ChannelPlaces>& layout, nlohmann::ordered_json& channel);

}  // namespace somato
