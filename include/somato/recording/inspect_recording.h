#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/element_ranges.h"
#include "somato/recording/recording.h"

namespace somato {

/// Numbers of explorations for each value of a label, in order of appearance.
struct LabelSummary {
  /// The number of explorations with a value of the label.
  struct Count {
    std::string value;
    std::uint64_t explorations = 0;
  };
  std::string name;
  std::vector<Count> values;
  std::uint64_t others = 0;  ///< Explorations with values that are not listed.
};

/// The lengths of a channel in the explorations that contain it.
struct ChannelSummary {
  ChannelDescription description;  ///< Position of its first appearance.
  std::size_t elements = 0;
  std::uint64_t explorations = 0;  ///< Number of explorations with this channel.
  std::uint64_t least_frames = 0;  ///< In these explorations.
  std::uint64_t most_frames = 0;
  double least_rate = 0.0;  ///< Frames per second in these explorations; 0 if one has no rate.
  double most_rate = 0.0;
  std::vector<ElementRange> ranges;  ///< One for each element, unless there are more than 65536.
};

/// Summary of a recording file.
struct RecordingSummary {
  std::uint64_t explorations = 0;
  bool knows_explorations =
      true;  ///< If false, the file is treated as one exploration; see RecordingReader.
  std::vector<LabelSummary> labels;
  std::vector<ChannelSummary> channels;
  double duration = 0.0;  ///< Seconds from first to last frame, summed over explorations.
  std::string compression;
  std::uint64_t size = 0;       ///< Bytes.
  std::optional<Error> damage;  ///< The first damaged position; data after it are not counted.

  /// Why a file of another program, although it is not damaged, cannot be read as a recording as it
  /// is; frames after that are not counted. It can be imported.
  std::optional<Error> unfit;
};

/// Scans the MCAP file at `path` with bounded memory: the first values of labels are listed, up to
/// 4 MiB. Errors: kSystem with the system's reason; kUsage for a file that is not regular; kData
/// for a file that is not MCAP.
Result<RecordingSummary> inspect_recording(const std::string& path);

}  // namespace somato
