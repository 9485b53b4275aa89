#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "recordings/file/recording_layout.h"
#include "recordings/mcap/mcap_writer.h"

namespace somato {

/// Writes explorations and their frames to an MCAP file, so that every chunk identifies the
/// exploration of its frames.
class ExplorationLog {
 public:
  explicit ExplorationLog(McapWriter& file) : file_(&file) {}

  bool is_open() const { return open_.has_value(); }

  /// Begins number `index` of the file at `time` (ns); `channels` are the ids of message.channels.
  Result<void> begin(ExplorationMessage message, std::vector<std::uint16_t> channels,
                     std::uint64_t time);

  /// Adds a message, of the open exploration if there is one.
  Result<void> add(const McapMessage& message);

  /// Ends the open exploration at the latest time so far.
  Result<void> end();

 private:
  Result<void> say(ExplorationMessage::Event event, std::uint64_t time);

  McapWriter* file_;
  std::optional<ExplorationMessage> open_;
  std::vector<std::uint16_t> channels_;
};

}  // namespace somato
