#pragma once

#include <functional>
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
  std::string message_encoding;     ///< "cdr", "json", "protobuf" or another.
  std::string definition_encoding;  ///< "ros2msg", "jsonschema", "protobuf" or another.
  std::string definition;
};

/// The messages of a topic, which are read in CDR of a type.
struct TopicMessages {
  std::shared_ptr<const RosType> type;  ///< nullptr if they cannot be decoded.
  std::function<Result<std::string>(std::string_view)> to_cdr;  ///< Empty if they are in CDR.

  /// A message in CDR of the type: itself, or one of another encoding written to `buffer`. Errors:
  /// as cdr_of_json() and cdr_of_protobuf().
  Result<std::string_view> in_cdr(std::string_view message, std::string& buffer) const;
};

/// A channel of a topic of a known type.
struct TopicChannel {
  std::string suffix;  ///< Follows the topic's name in the channel's, such as "/force".
  std::string unit;
  ChannelReader reader;
};

/// The channels of a topic that are known without a description.
struct TopicType {
  TopicMessages messages;
  std::vector<TopicChannel> channels;  ///< Empty unless the type is known.
  std::string reason;                  ///< Why there are no channels; empty if there are.
};

/// Errors (kData): messages that are not in CDR, JSON or protobuf; no definition; those of
/// compile_ros_definition(), compile_json_schema() and compile_protobuf_schema().
Result<TopicMessages> compile_topic_messages(const TopicEncoding& encoding);

/// The channels of a topic by the table of known types, or why there are none.
TopicType topic_type(const TopicEncoding& encoding);

}  // namespace somato
