#include "maps/pictures/layout_json.h"

#include <string>
#include <utility>

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

Json background_json(const SkinBackground& background) {
  return {{"image", background.image},
          {"x", background.corner.x},
          {"y", background.corner.y},
          {"width", background.width},
          {"height", background.height}};
}

}  // namespace

Json layout_json(const SkinPlaces& skin) {
  Json places = Json::array();
  for (const Point& place : skin.places) places.push_back({place.x, place.y});
  Json groups = Json::array();
  for (const SkinGroup& group : skin.groups) {
    groups.push_back({{"name", group.name}, {"elements", group.elements}});
  }
  Json json{{"spacing", spacing_of(skin.places)},
            {"places", std::move(places)},
            {"groups", std::move(groups)},
            {"background", nullptr}};
  if (skin.background) json["background"] = background_json(*skin.background);
  return json;
}

Result<void> add_places(const std::vector<ChannelPlaces>& layout, Json& channel) {
  for (const ChannelPlaces& one : layout) {
    if (channel["name"].get<std::string>() != one.channel) continue;
    SOMATO_TRY(const auto skin,
               places_for(one, channel["elements"].get<std::vector<std::string>>()));
    channel["layout"] = layout_json(skin);
  }
  return {};
}

}  // namespace somato
