#include "recordings/ros/topic_type.h"

#include <fmt/format.h>

#include <utility>

#include "base/text/flag_hint.h"
#include "base/text/text.h"
#include "recordings/ros/definition.h"
#include "recordings/ros/field_reader.h"
#include "recordings/ros/json_messages.h"
#include "recordings/ros/known_types.h"
#include "recordings/ros/protobuf_messages.h"

namespace somato {
namespace {

constexpr std::size_t kMostPathsShown = 6;
constexpr const char* kProtobuf = "protobuf";  // An encoding of messages and of definitions.
constexpr const char* kTypeWithoutFields = "std_msgs/Empty";

std::string reason_without_channels(const TopicEncoding& encoding, const RosType& type) {
  std::vector<std::string> paths = field_paths(type, FieldKind::kNumbers, kMostPathsShown + 1);
  if (paths.empty()) return "its messages hold no numbers";
  const bool has_more = paths.size() > kMostPathsShown;
  if (has_more) paths.back() = "...";
  return fmt::format("{} {}; its numbers: {}", encoding.type,
                     known_type(encoding.type) ? "has other fields than the known type of that name"
                                               : "is not a known type",
                     fmt::join(paths, ", "));
}

Result<TopicMessages> cdr_messages(const TopicEncoding& encoding) {
  if (encoding.definition.empty() && ros_type_name(encoding.type) != kTypeWithoutFields) {
    return fail(ErrorKind::kData, fmt::format("the file holds no definition of {}", encoding.type),
                {}, "give its .msg files as definitions" + flag_hint("definitions"));
  }
  SOMATO_TRY(RosType type, compile_ros_definition(encoding.type, encoding.definition_encoding,
                                                  encoding.definition));
  return TopicMessages{std::make_shared<const RosType>(std::move(type)), {}};
}

Result<TopicMessages> json_messages(const TopicEncoding& encoding) {
  if (encoding.definition.empty()) {
    return fail(ErrorKind::kData, "its messages in JSON have no JSON Schema");
  }
  SOMATO_TRY(RosType compiled, compile_json_schema(encoding.type, encoding.definition));
  const auto type = std::make_shared<const RosType>(std::move(compiled));
  return TopicMessages{type,
                       [type](std::string_view message) { return cdr_of_json(*type, message); }};
}

Result<TopicMessages> protobuf_messages(const TopicEncoding& encoding) {
  if (encoding.definition_encoding != kProtobuf) {
    return fail(ErrorKind::kData,
                fmt::format("its messages are in protobuf, their definition is in the encoding {}",
                            shown(encoding.definition_encoding)));
  }
  SOMATO_TRY(ProtobufType compiled, compile_protobuf_schema(encoding.type, encoding.definition));
  const auto type = std::make_shared<const ProtobufType>(std::move(compiled));
  return TopicMessages{{type, &type->type}, [type](std::string_view message) {
                         return cdr_of_protobuf(*type, message);
                       }};
}

}  // namespace

Result<std::string_view> TopicMessages::in_cdr(std::string_view message,
                                               std::string& buffer) const {
  if (!to_cdr) return message;
  SOMATO_TRY(buffer, to_cdr(message));
  return std::string_view(buffer);
}

Result<TopicMessages> compile_topic_messages(const TopicEncoding& encoding) {
  if (encoding.message_encoding == "cdr") return cdr_messages(encoding);
  if (encoding.message_encoding == "json") return json_messages(encoding);
  if (encoding.message_encoding == kProtobuf) return protobuf_messages(encoding);
  return fail(ErrorKind::kData,
              fmt::format("its messages are in the encoding {}, not in CDR, JSON or protobuf",
                          shown(encoding.message_encoding)));
}

TopicType topic_type(const TopicEncoding& encoding) {
  TopicType topic;
  Result<TopicMessages> messages = compile_topic_messages(encoding);
  if (!messages) {
    topic.reason = to_string(messages.error());
    return topic;
  }
  topic.messages = std::move(*messages);
  if (const KnownType* known = known_type(encoding.type)) {
    for (const KnownChannel& channel : known->channels) {
      Result<ChannelReader> reader = ChannelReader::compile(
          topic.messages.type, {std::string(channel.path)}, std::string(channel.names));
      if (!reader) continue;
      topic.channels.push_back(
          {std::string(channel.suffix), std::string(channel.unit), std::move(*reader)});
    }
  }
  if (topic.channels.empty())
    topic.reason = reason_without_channels(encoding, *topic.messages.type);
  return topic;
}

}  // namespace somato
