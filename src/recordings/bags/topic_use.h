#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/bags/bag_description.h"
#include "recordings/bags/bag_source.h"
#include "recordings/ros/channel_reader.h"
#include "recordings/ros/field_reader.h"
#include "somato/core/result.h"

namespace somato {

/// The fields that an import reads from the messages of a topic.
struct TopicUse {
  struct Channel {
    BagChannel description;
    ChannelReader reader;
  };
  struct Label {
    std::size_t label = 0;  ///< Index in BagImport::labels.
    FieldReader reader;
  };

  TopicMessages messages;  ///< Without a type if nothing is read.
  std::vector<Channel> channels;
  std::vector<Label> labels;
  bool is_event = false;
  std::optional<FieldReader> event;  ///< The field that decides whether an exploration begins.
  std::optional<FieldReader> stamp;  ///< The header's, if frames have its time.
  std::string reason;                ///< Why nothing is used; empty if something is.
};

/// Errors (kUsage, kData): fields that the type of the topic does not have; a type that cannot be
/// decoded, if it is used; no header for BagClock::kHeader.
Result<TopicUse> use_of_topic(const BagTopic& topic, const BagImport& description);

/// The value at a field in words: a text, or a number; several with commas between. Errors: as
/// FieldReader::read().
Result<std::string> words_at(const FieldReader& reader, std::string_view message);

/// The time (ns) in the header of a message. Errors: as FieldReader::read().
Result<std::int64_t> stamp_in(const FieldReader& reader, std::string_view message);

}  // namespace somato
