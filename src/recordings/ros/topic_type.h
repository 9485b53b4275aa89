#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/ros/channel_reader.h"
#include "recordings/ros/message_type.h"
#include "somato/core/result.h"

namespace somato {

/// The encoding of the messages of a topic.
struct TopicEncoding {
  std::string type;                 ///< Such as "sensor_msgs/msg/JointState".
  std::string message_encoding;     ///< "cdr", "json" or another.
  std::string definition_encoding;  ///< "ros2msg", "jsonschema" or another.
  std::string definition;
};

/// A channel of a topic of a known type.
struct TopicChannel {
  std::string suffix;  ///< Follows the topic's name in the channel's, such as "/force".
  std::string unit;
  ChannelReader reader;
};

/// The channels of a topic that are known without a description.
struct TopicType {
  std::shared_ptr<const RosType> type;  ///< nullptr if its messages cannot be decoded.
  std::vector<TopicChannel> channels;   ///< Empty unless the type is known.
  std::string reason;                   ///< Why there are no channels; empty if there are.
};

/// Errors (kData): messages that are neither in CDR nor in JSON; no definition; those of
/// compile_ros_definition() and compile_json_schema().
Result<std::shared_ptr<const RosType>> compile_topic_type(const TopicEncoding& encoding);

/// A message of a topic in CDR of its type: itself, or one in JSON written to `buffer`. Errors: as
/// cdr_of_json().
Result<std::string_view> message_in_cdr(const TopicEncoding& encoding, const RosType& type,
                                        std::string_view message, std::string& buffer);

/// The channels of a topic by the table of known types, or why there are none.
TopicType topic_type(const TopicEncoding& encoding);

}  // namespace somato
