#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/channel_description.h"

namespace somato {

/// How many explorations have which value of a label, in the order of their appearance.
struct LabelSummary {
  struct Count {
    std::string value;
    std::uint64_t explorations = 0;
  };
  std::string name;
  std::vector<Count> values;
  std::uint64_t others = 0;  ///< Explorations with values beyond those that are kept.
};

struct ChannelSummary {
  ChannelDescription description;  ///< Where it first appears.
  std::size_t elements = 0;
  std::uint64_t explorations = 0;  ///< That have it.
  std::uint64_t least_frames = 0;  ///< Of these.
  std::uint64_t most_frames = 0;
};

/// What is in a recording file.
struct RecordingSummary {
  std::uint64_t explorations = 0;
  bool knows_explorations = true;  ///< Else all is one; see RecordingReader.
  std::vector<LabelSummary> labels;
  std::vector<ChannelSummary> channels;
  double duration = 0.0;  ///< Seconds from first to last frame, summed over explorations.
  std::string compression;
  std::uint64_t size = 0;       ///< Bytes.
  std::optional<Error> damage;  ///< The first place where it is not whole; nothing behind counts.
};

/// Looks through the MCAP file at `path`, with memory that does not grow with it: of labels the
/// first values are kept, up to 4 MiB. Errors: kSystem with the system's reason; kUsage for what is
/// no regular file; kData for what is no MCAP file.
Result<RecordingSummary> inspect_recording(const std::string& path);

}  // namespace somato
