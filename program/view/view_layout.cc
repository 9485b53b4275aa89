#include "view/view_layout.h"

#include <string>
#include <vector>

#include "recordings/explorations/recording_json.h"
#include "recordings/layout_flag.h"
#include "views/skins/channel_places.h"

namespace somato::program {
namespace {

// As a page will show them.
Result<void> check_places(const std::vector<ChannelPlaces>& places,
                          const Exploration& exploration) {
  std::vector<std::string> names;
  names.reserve(exploration.channels.size());
  for (const Channel& channel : exploration.channels) names.push_back(channel.name);
  SOMATO_TRY_VOID(check_channels(places, names));
  for (const Channel& channel : exploration.channels) {
    auto json = detail::channel_json(channel);
    SOMATO_TRY_VOID(add_places(places, json));
  }
  return {};
}

}  // namespace

Result<void> add_layout(const Arguments& arguments, ViewSource& source) {
  SOMATO_TRY(source.places, read_layout_flag(arguments));
  if (source.recording.explorations.empty()) return {};
  return check_places(source.places, source.recording.explorations.front());
}

}  // namespace somato::program
