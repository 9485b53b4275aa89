#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/recording/frame_sink.h"

namespace somato {

class FileSystem;
class OpenFile;

/// Compression of the chunks of a recording file.
enum class Compression {
  kNone,
  kLz4,
  kZstd,
};

template <>
struct Choices<Compression> {
  static const std::vector<std::pair<Compression, std::string>>& all();
};

/// Options for writing a recording file.
struct RecordingFileParameters {
  Compression compression = Compression::kZstd;
  std::size_t chunk_size = std::size_t{1} << 20;
  double flush_after = 0.5;

  static const Declarations<RecordingFileParameters>& declarations();
};

/// Writes a recording live: an MCAP file as described in docs/formats/recording.md, in chunks that
/// are written when they are full or their oldest message is `flush_after` old, independent of
/// further calls. If the program is killed, no more than that is lost; of a power failure, what was
/// written since synchronize(). recover_recording() reads the incomplete file.
///
/// Can be used by several threads. After a system error every call returns that error, and nothing
/// more is written.
class RecordingWriter final : public FrameSink {
 public:
  /// Creates the file at `path`. Errors: kSystem with the system's reason, for example if the file
  /// exists.
  static Result<RecordingWriter> create(const std::string& path,
                                        const RecordingFileParameters& parameters = {});

  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter(RecordingWriter&& other) noexcept;
  RecordingWriter& operator=(const RecordingWriter&) = delete;
  RecordingWriter& operator=(RecordingWriter&& other) noexcept;

  /// Writes the remaining data, without the marks of a complete file unless it was closed.
  ~RecordingWriter() override;

  /// Throws InvalidArgument if an exploration is open. Errors: kData for texts that are not UTF-8
  /// or longer than 256 KiB in total, channels with duplicate or missing names and times beyond
  /// +-9e9 s; kSystem with the system's reason.
  Result<void> begin_exploration(const ExplorationStart& start) override;

  /// Adds a frame of the channel with that index in ExplorationStart::channels. Channels may be in
  /// any order, the frames of a channel are in the order of their times (s), which are not stored
  /// for a channel with a rate or without known times. All frames of a channel have the same number
  /// of values. An element with a 0 in `valid` (which may be empty), or that is NaN, is invalid.
  ///
  /// Throws InvalidArgument unless an exploration with that channel is open, and for wrong sizes.
  /// Errors: kData for a time that decreases or exceeds the above limit, and for more than 16 MiB;
  /// kSystem with the system's reason.
  Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                     std::span<const std::uint8_t> valid = {}) override;

  /// Throws InvalidArgument if none is open. Errors: kSystem with the system's reason.
  Result<void> end_exploration() override;

  /// Whether an exploration is open.
  bool is_open() const;

  /// The number of explorations that have begun.
  std::uint64_t explorations() const;

  /// Gives an exploration, counting from 0 as they began, a label in place of one of the same name;
  /// it may have ended. The last one counts. Throws InvalidArgument if it has not begun. Errors:
  /// kData for a text that is not UTF-8 or too long; kSystem with the system's reason.
  Result<void> label(std::uint64_t exploration, const Label& label);

  /// Readers leave the exploration out, which may have ended. Throws and errors: as label().
  Result<void> leave_out(std::uint64_t exploration);

  /// Returns when all that was added is on the disk. Errors: kSystem with the system's reason.
  Result<void> synchronize();

  /// Completes the file and flushes it to the disk; throws InvalidArgument if an exploration is
  /// open or the file is already closed. Errors: kSystem with the system's reason.
  Result<void> close();

  /// The same on the given file system, for tests.
  static Result<RecordingWriter> create(FileSystem& files, const std::string& path,
                                        const RecordingFileParameters& parameters);

  /// Writes into an open file, which is empty or holds only the begin of a recording; `path` is for
  /// messages.
  static Result<RecordingWriter> write_into(OpenFile file, const std::string& path,
                                            const RecordingFileParameters& parameters);

 private:
  class Impl;
  explicit RecordingWriter(std::unique_ptr<Impl> state);
  std::unique_ptr<Impl> impl_;
};

}  // namespace somato
