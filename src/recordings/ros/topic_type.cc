#include "recordings/ros/topic_type.h"

#include <fmt/format.h>

#include <utility>

#include "base/text/text.h"
#include "recordings/ros/definition.h"
#include "recordings/ros/field_reader.h"
#include "recordings/ros/json_messages.h"
#include "recordings/ros/known_types.h"

namespace somato {
namespace {

constexpr std::size_t kMostPathsShown = 6;
constexpr const char* kJson = "json";
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

}  // namespace

Result<std::shared_ptr<const RosType>> compile_topic_type(const TopicEncoding& encoding) {
  const bool is_json = encoding.message_encoding == kJson;
  if (encoding.message_encoding != "cdr" && !is_json) {
    return fail(ErrorKind::kData,
                fmt::format("its messages are in the encoding {}, not in CDR or JSON",
                            shown(encoding.message_encoding)));
  }
  if (encoding.definition.empty() && is_json) {
    return fail(ErrorKind::kData, "its messages in JSON have no JSON Schema");
  }
  if (encoding.definition.empty() && ros_type_name(encoding.type) != kTypeWithoutFields) {
    return fail(ErrorKind::kData, fmt::format("the file holds no definition of {}", encoding.type),
                {}, "give its .msg files with --definitions");
  }
  Result<RosType> type = is_json
                             ? compile_json_schema(encoding.type, encoding.definition)
                             : compile_ros_definition(encoding.type, encoding.definition_encoding,
                                                      encoding.definition);
  if (!type) return fail(std::move(type.error()));
  return std::make_shared<const RosType>(std::move(*type));
}

Result<std::string_view> message_in_cdr(const TopicEncoding& encoding, const RosType& type,
                                        std::string_view message, std::string& buffer) {
  if (encoding.message_encoding != kJson) return message;
  SOMATO_TRY(buffer, cdr_of_json(type, message));
  return std::string_view(buffer);
}

TopicType topic_type(const TopicEncoding& encoding) {
  TopicType topic;
  Result<std::shared_ptr<const RosType>> type = compile_topic_type(encoding);
  if (!type) {
    topic.reason = to_string(type.error());
    return topic;
  }
  topic.type = std::move(*type);
  if (const KnownType* known = known_type(encoding.type)) {
    for (const KnownChannel& channel : known->channels) {
      Result<ChannelReader> reader = ChannelReader::compile(topic.type, {std::string(channel.path)},
                                                            std::string(channel.names));
      if (!reader) continue;
      topic.channels.push_back(
          {std::string(channel.suffix), std::string(channel.unit), std::move(*reader)});
    }
  }
  if (topic.channels.empty()) topic.reason = reason_without_channels(encoding, *topic.type);
  return topic;
}

}  // namespace somato
