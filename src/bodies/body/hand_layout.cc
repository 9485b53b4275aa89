#include "bodies/body/hand_layout.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace somato {
namespace {

constexpr std::string_view kProximal = "_proximal";
constexpr std::string_view kDistal = "_distal";

Result<Segment> segment_of(const BodyDescription& body, const ChannelDescription& touch,
                           const std::string& name) {
  SOMATO_TRY(const auto servo, find_degree_of_freedom(body, name));
  Segment segment{servo, {}};
  for (std::size_t i = 0; i < touch.element_names.size(); ++i) {
    if (touch.element_names[i].starts_with(name + "_")) segment.taxels.push_back(i);
  }
  if (!segment.taxels.empty()) return segment;
  return fail(ErrorKind::kUsage, fmt::format("the segment '{}' has no taxels", name), body.name,
              fmt::format("name elements of the sensor 'touch' {}_1 and so on", name));
}

Result<Finger> finger_of(const BodyDescription& body, const ChannelDescription& touch,
                         std::string name) {
  SOMATO_TRY(auto proximal, segment_of(body, touch, name + std::string(kProximal)));
  SOMATO_TRY(auto distal, segment_of(body, touch, name + std::string(kDistal)));
  return Finger{std::move(name), std::move(proximal), std::move(distal)};
}

}  // namespace

Result<HandLayout> hand_layout(const BodyDescription& description) {
  SOMATO_TRY(const auto touch, find_sensor(description, "touch"));
  HandLayout layout{{}, touch};
  for (const DegreeOfFreedom& servo : description.degrees_of_freedom) {
    if (!servo.name.ends_with(kProximal)) continue;
    SOMATO_TRY(auto finger, finger_of(description, description.sensors[touch],
                                      servo.name.substr(0, servo.name.size() - kProximal.size())));
    layout.fingers.push_back(std::move(finger));
  }
  if (!layout.fingers.empty()) return layout;
  return fail(ErrorKind::kUsage, fmt::format("the body '{}' has no fingers", description.name),
              description.name, "a finger has servos such as finger1_proximal and finger1_distal");
}

}  // namespace somato
