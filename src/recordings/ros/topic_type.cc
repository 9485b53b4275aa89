#include "recordings/ros/topic_type.h"

#include <fmt/format.h>

#include <utility>

#include "base/text/text.h"
#include "recordings/ros/definition.h"
#include "recordings/ros/field_reader.h"
#include "recordings/ros/known_types.h"

namespace somato {
namespace {

constexpr std::size_t kMostPathsShown = 6;

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
  if (encoding.message_encoding != "cdr") {
    return fail(ErrorKind::kData, fmt::format("its messages are in the encoding {}, not in CDR",
                                              shown(encoding.message_encoding)));
  }
  if (encoding.definition.empty() && encoding.definition_encoding.empty()) {
    return fail(ErrorKind::kData, fmt::format("the file holds no definition of {}", encoding.type),
                {}, "give its .msg files with --definitions");
  }
  SOMATO_TRY(RosType type, compile_ros_definition(encoding.type, encoding.definition_encoding,
                                                  encoding.definition));
  return std::make_shared<const RosType>(std::move(type));
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
