#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "somato/core/result.h"
#include "somato/recording/frame_sink.h"
#include "somato/recording/recording.h"
#include "somato/recording/recording_writer.h"

namespace somato {

/// Whether the first bytes of a file (8 suffice) are those of MCAP.
bool is_mcap(std::string_view bytes);

/// Whether the file at `path` can be read and begins with these bytes.
bool is_mcap_file(const std::string& path);

/// Writes `recording` to the file at `path`, atomically like save_whole(), in the layout of
/// docs/formats/recording.md. Reading gives the same recording if its times are whole nanoseconds,
/// except that validity marks that are all 1 are omitted.
///
/// Errors: kData for recordings that validate() or RecordingWriter refuses; kSystem with the
/// system's reason.
Result<void> write_recording(const std::string& path, const Recording& recording,
                             const RecordingFileParameters& parameters = {});

/// Writes a recording frame by frame, or exploration by exploration, like write_recording(): the
/// complete file replaces the previous one when it is finished; before, or without finishing,
/// nothing changes at the path. Memory grows neither with the recording nor with an exploration.
class RecordingFile final : public FrameSink {
 public:
  /// Errors: kSystem with the system's reason.
  static Result<RecordingFile> begin(const std::string& path,
                                     const RecordingFileParameters& parameters = {});

  RecordingFile(const RecordingFile&) = delete;
  RecordingFile(RecordingFile&& other) noexcept;
  RecordingFile& operator=(const RecordingFile&) = delete;
  RecordingFile& operator=(RecordingFile&& other) noexcept;
  ~RecordingFile() override;

  /// Errors and exceptions as RecordingWriter.
  Result<void> begin_exploration(const ExplorationStart& start) override;
  Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                     std::span<const std::uint8_t> valid = {}) override;
  Result<void> end_exploration() override;

  /// Writes a complete exploration. Errors: kData for a single exploration that validate() or
  /// RecordingWriter refuses; kSystem with the system's reason.
  Result<void> add(Exploration exploration);

  /// Completes the file; no exploration is open. Errors: kSystem with the system's reason.
  Result<void> finish();

  /// The same as begin() on the given file system, for tests.
  static Result<RecordingFile> begin(FileSystem& files, const std::string& path,
                                     const RecordingFileParameters& parameters = {});

  class Impl;

 private:
  explicit RecordingFile(std::unique_ptr<Impl> state);
  std::unique_ptr<Impl> impl_;
};

/// Reads the explorations of an MCAP file one after the other; memory is bounded by one chunk (24
/// MiB) and what next() returns. A file of another program, without explorations, is read as one
/// exploration without labels: its topics with messages of sensor_msgs/JointState and
/// std_msgs/Float32MultiArray or Float64MultiArray are the channels, with times relative to its
/// first message; others are left out. See docs/formats/recording.md.
///
/// A channel whose validity marks are all 1 has none.
class RecordingReader {
 public:
  /// Explorations whose frames require more than `most_memory` bytes in total are refused by
  /// next(). Errors: kSystem with the system's reason; kUsage for a file that is not regular; kData
  /// for a file that is not MCAP.
  static Result<RecordingReader> open(
      const std::string& path, std::size_t most_memory = std::numeric_limits<std::size_t>::max());

  RecordingReader(const RecordingReader&) = delete;
  RecordingReader(RecordingReader&& other) noexcept;
  RecordingReader& operator=(const RecordingReader&) = delete;
  RecordingReader& operator=(RecordingReader&& other) noexcept;
  ~RecordingReader();

  /// The same on the given file system, for tests.
  static Result<RecordingReader> open(FileSystem& files, const std::string& path);

  /// The next exploration; nothing after the last one of a complete file. Errors: kSystem with the
  /// system's reason and for too much memory; kData with file and byte for damage, for invalid
  /// content (frames outside explorations, of channels that the exploration does not have, with the
  /// wrong number of elements, or with decreasing times) and for a missing end. No exploration
  /// follows an error.
  Result<std::optional<Exploration>> next();

  /// Hands the next exploration to `to` as soon as all its frames are read; false after the last
  /// one. Frames beyond 16 MiB wait in a temporary file, so that memory does not grow with the
  /// exploration. Errors: as next(), and those of `to`; kSystem for the temporary file.
  Result<bool> next(FrameSink& to);

 private:
  class Impl;
  explicit RecordingReader(std::unique_ptr<Impl> state);
  std::unique_ptr<Impl> impl_;
};

/// Reads the complete recording in the MCAP file at `path`; errors as RecordingReader. The content
/// is not validated.
Result<Recording> read_recording(const std::string& path);

namespace detail {

/// The same on the given file system, for tests.
Result<void> write_recording(FileSystem& files, const std::string& path, const Recording& recording,
                             const RecordingFileParameters& parameters);

}  // namespace detail

}  // namespace somato
