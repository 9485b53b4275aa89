#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/file/ros_messages.h"
#include "recordings/mcap/exploration_notes.h"
#include "recordings/mcap/mcap_records.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

// The layout of a recording in an MCAP file, as described in docs/formats/recording.md.

namespace somato {

/// A message of the topic /exploration.
struct ExplorationMessage {
  enum class Event {
    kBegin,
    kContinue,  ///< Repeats the begin message at the start of a chunk, in case that is lost.
    kEnd,       ///< Contains only the index.
  };
  Event event = Event::kBegin;
  std::uint64_t index = 0;  ///< The number of the exploration in the file, from 0.
  std::vector<Label> labels;
  std::string source;
  std::vector<std::string> channels;  ///< Their names, in their order.
  std::int64_t zero = 0;              ///< The log time (ns) at 0 s on the exploration's clock.
};

McapSchema exploration_schema();
McapChannel exploration_channel();
bool is_exploration_schema(const McapSchema& schema);

std::string exploration_json(const ExplorationMessage& message);

/// Errors (kData, without a location): an invalid message, or one longer than
/// kLongestExplorationText.
Result<ExplorationMessage> parse_exploration_json(std::string_view json);

/// The topic of the channel of that name.
std::string topic_of(const std::string& name);

/// The schema and the channel, without ids, for the frames of a channel.
McapSchema schema_for(const ChannelDescription& description);
McapChannel channel_for(const ChannelDescription& description);

/// The channel described by the metadata of `channel`. Errors (kData, without a location): invalid
/// metadata.
Result<ChannelDescription> parse_description(const McapChannel& channel);

/// A frame as the message of its channel. Elements that are not valid are NaN.
std::string frame_message(const ChannelDescription& description, std::uint64_t log_time,
                          std::span<const float> values);

/// The values in the unit of the channel; those of a `joint_state` are in radians.
std::vector<float> frame_values(const ChannelDescription& description, bool joint_state,
                                std::span<const double> values);

}  // namespace somato
