#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "views/skins/skin_places.h"

namespace somato {

/// The places of the elements of one channel: the table [layout.CHANNEL] of a layout file.
struct ChannelPlaces {
  struct Group {
    std::string name;
    std::string where;                  ///< `FILE:LINE` of its key.
    std::vector<std::string> elements;  ///< Names, or ranges "t00..t03" by place.
  };

  std::string channel;
  std::string where;                  ///< `FILE:LINE` of the table.
  std::vector<std::string> elements;  ///< In the order of the places; empty: that of the channel.
  std::vector<Point> places;          ///< mm, at least one, all different.
  std::vector<Group> groups;
  std::optional<SkinBackground> background;
};

/// The places of a channel's elements with these names, in their order. Errors (kUsage): another
/// number of places, names without a place or places without an element, groups with unknown or
/// repeated elements.
Result<SkinPlaces> places_for(const ChannelPlaces& channel, const std::vector<std::string>& names);

/// Checks that each channel of the layout is one of those. Errors (kUsage) name the nearest.
Result<void> check_channels(const std::vector<ChannelPlaces>& layout,
                            const std::vector<std::string>& channels);

/// As LayoutData of web/schema/parts.json.
nlohmann::ordered_json layout_json(const SkinPlaces& skin);

/// Adds the places of its elements to a channel, ChannelData of web/schema/parts.json, if the
/// layout has a table for it. Errors: those of places_for().
Result<void> add_places(const std::vector<ChannelPlaces>& layout, nlohmann::ordered_json& channel);

}  // namespace somato
