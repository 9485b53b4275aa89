#include "views/skins/channel_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "somato/core/parameter.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

Result<std::size_t> place_of(const std::string& name, const Names& names,
                             const std::string& where) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return fail(unknown_name("element", name, where, names));
  return static_cast<std::size_t>(found - names.begin());
}

// "a..b" from the first to the second, unless an element has this name.
Result<std::pair<std::size_t, std::size_t>> range_of(const std::string& text, const Names& names,
                                                     const std::string& where) {
  const std::size_t dots = text.find("..");
  const bool is_name = std::find(names.begin(), names.end(), text) != names.end();
  if (is_name || dots == std::string::npos) {
    SOMATO_TRY(const auto place, place_of(text, names, where));
    return std::pair(place, place);
  }
  SOMATO_TRY(const auto first, place_of(text.substr(0, dots), names, where));
  SOMATO_TRY(const auto last, place_of(text.substr(dots + 2), names, where));
  if (first <= last) return std::pair(first, last);
  return fail(ErrorKind::kUsage, fmt::format("'{}' is descending", text), where,
              "begin with the element that comes first");
}

Result<SkinGroup> group_for(const ChannelPlaces::Group& group, const Names& names) {
  SkinGroup of_elements{group.name, {}};
  for (const std::string& text : group.elements) {
    SOMATO_TRY(const auto range, range_of(text, names, group.where));
    for (std::size_t i = range.first; i <= range.second; ++i) {
      const auto& known = of_elements.elements;
      if (std::find(known.begin(), known.end(), i) != known.end()) {
        return fail(ErrorKind::kUsage,
                    fmt::format("the group '{}' has the element '{}' twice", group.name, names[i]),
                    group.where, "name it once");
      }
      of_elements.elements.push_back(i);
    }
  }
  return of_elements;
}

Result<std::vector<Point>> ordered(const ChannelPlaces& channel, const Names& names) {
  if (channel.elements.empty()) return channel.places;
  std::vector<Point> places;
  places.reserve(names.size());
  for (const std::string& name : names) {
    const auto found = std::find(channel.elements.begin(), channel.elements.end(), name);
    if (found == channel.elements.end()) {
      return fail(ErrorKind::kUsage, fmt::format("the element '{}' has no place", name),
                  channel.where, name_advice(name, channel.elements));
    }
    places.push_back(channel.places[static_cast<std::size_t>(found - channel.elements.begin())]);
  }
  return places;
}

Json background_json(const SkinBackground& background) {
  return {{"image", background.image},
          {"x", background.corner.x},
          {"y", background.corner.y},
          {"width", background.width},
          {"height", background.height}};
}

}  // namespace

Result<SkinPlaces> places_for(const ChannelPlaces& channel, const Names& names) {
  if (channel.places.size() != names.size()) {
    return fail(ErrorKind::kUsage,
                fmt::format("{} places, but '{}' has {} elements", channel.places.size(),
                            channel.channel, names.size()),
                channel.where, "give one place for each element");
  }
  SOMATO_TRY(auto places, ordered(channel, names));
  SkinPlaces skin{std::move(places), {}, channel.background};
  for (const ChannelPlaces::Group& group : channel.groups) {
    SOMATO_TRY(auto of_elements, group_for(group, names));
    skin.groups.push_back(std::move(of_elements));
  }
  return skin;
}

Result<void> check_channels(const std::vector<ChannelPlaces>& layout, const Names& channels) {
  for (const ChannelPlaces& one : layout) {
    if (std::find(channels.begin(), channels.end(), one.channel) != channels.end()) continue;
    return fail(unknown_name("channel", one.channel, one.where, channels));
  }
  return {};
}

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
