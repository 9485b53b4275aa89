#include "recordings/explorations/recording_json.h"

#include <utility>

namespace somato::detail {

using Json = nlohmann::ordered_json;

Json labels_json(const std::vector<Label>& labels) {
  Json json = Json::object();
  for (const Label& label : labels) json[label.name] = label.value;
  return json;
}

Json channel_json(const std::string& name, const std::string& unit,
                  const std::vector<std::string>& elements, const std::vector<std::size_t>& shape) {
  std::size_t count = 1;
  for (const std::size_t length : shape) count *= length;
  Json names = Json::array();
  for (std::size_t i = 0; i < count; ++i) {
    names.push_back(elements.size() == count ? elements[i] : std::to_string(i + 1));
  }
  return {{"name", name}, {"unit", unit}, {"elements", std::move(names)}, {"shape", shape}};
}

Json channel_json(const Channel& channel) {
  return channel_json(channel.name, channel.unit, channel.element_names, channel.frame_shape());
}

}  // namespace somato::detail
