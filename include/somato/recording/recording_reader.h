#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// Reads the explorations of an MCAP file one after the other; memory is bounded by one chunk (24
/// MiB) and one exploration. A file that knows no explorations, written by somebody else, is one
/// exploration without labels: its topics with messages of sensor_msgs/JointState and
/// std_msgs/Float32MultiArray or Float64MultiArray are the channels, with times from its first
/// message on; others are left out. See docs/formats/recording.md.
///
/// A channel whose marks of validity are all 1 has none.
class RecordingReader {
 public:
  /// Explorations whose frames take more than `most_memory` bytes in all are refused by next().
  /// Errors: kSystem with the system's reason; kUsage for what is no regular file; kData for what
  /// is no MCAP file.
  static Result<RecordingReader> open(
      const std::string& path, std::size_t most_memory = std::numeric_limits<std::size_t>::max());

  RecordingReader(const RecordingReader&) = delete;
  RecordingReader(RecordingReader&& other) noexcept;
  RecordingReader& operator=(const RecordingReader&) = delete;
  RecordingReader& operator=(RecordingReader&& other) noexcept;
  ~RecordingReader();

  /// The next exploration; nothing after the last one of a whole file. Errors: kSystem with the
  /// system's reason and for too much memory; kData with file and byte for damage, for what no
  /// recording may hold (frames outside explorations, of channels they do not have, with another
  /// number of elements, or with times that run backwards) and for an end that is missing. Nothing
  /// comes after an error.
  Result<std::optional<Exploration>> next();

 private:
  class State;
  explicit RecordingReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace somato
