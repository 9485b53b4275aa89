#pragma once

#include <span>
#include <string_view>

namespace somato {

/// A channel that is read from messages of a known type.
struct KnownChannel {
  std::string_view suffix;      ///< Follows the topic's name in the channel's, such as "/force".
  std::string_view path;        ///< See FieldReader.
  std::string_view unit;        ///< Empty: none, or not known.
  std::string_view names = {};  ///< The paths of the elements' names; see MessageNames.
};

/// A message type whose channels are known, with units.
struct KnownType {
  std::string_view name;  ///< Such as "sensor_msgs/JointState".
  std::span<const KnownChannel> channels;
};

/// The known types: common ones of ROS 2 and those of makers of tactile sensors.
std::span<const KnownType> known_types();

/// The known type of that name, with or without "/msg", or nullptr.
const KnownType* known_type(std::string_view name);

}  // namespace somato
