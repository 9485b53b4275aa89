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
#include "somato/recording/channel_description.h"
#include "somato/recording/recording.h"

namespace somato {

class FileSystem;

/// How the chunks of a recording file are packed.
enum class Compression {
  kNone,
  kLz4,
  kZstd,
};

template <>
struct Choices<Compression> {
  static const std::vector<std::pair<Compression, std::string>>& all();
};

/// How a recording file is written.
struct RecordingFileParameters {
  Compression compression = Compression::kZstd;
  std::size_t chunk_size = std::size_t{1} << 20;
  double flush_after = 0.5;

  static const Declarations<RecordingFileParameters>& declarations();
};

/// What is known about an exploration when it begins.
struct ExplorationStart {
  std::vector<Label> labels;
  std::string source;
  std::vector<ChannelDescription> channels;
  double time = 0.0;  ///< Seconds, on the clock of its frames.
};

/// Writes a recording as it happens: an MCAP file as docs/formats/recording.md says, in chunks that
/// are written out when they are full or their oldest message is `flush_after` old, whether anybody
/// calls or not. A program that is killed loses no more (a power cut may); what is on the disk then
/// can be saved by recover_recording().
///
/// May be used by several threads. After a failure of the system every call returns that failure,
/// and nothing more is written.
class RecordingWriter {
 public:
  /// Creates the file at `path`. Errors: kSystem with the system's reason, such as that there is a
  /// file of that name.
  static Result<RecordingWriter> create(const std::string& path,
                                        const RecordingFileParameters& parameters = {});

  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter(RecordingWriter&& other) noexcept;
  RecordingWriter& operator=(const RecordingWriter&) = delete;
  RecordingWriter& operator=(RecordingWriter&& other) noexcept;

  /// Writes out what there is, without the marks of a whole file unless it was closed.
  ~RecordingWriter();

  /// Throws InvalidArgument when an exploration is open. Errors: kData for texts that are not UTF-8
  /// or longer than 256 KiB together, channels of the same or no name and times beyond +-9e9 s;
  /// kSystem with the system's reason.
  Result<void> begin_exploration(const ExplorationStart& start);

  /// Adds a frame of the channel of that index in ExplorationStart::channels. Channels may come in
  /// any order, the frames of one in the order of their times (s); a channel with a rate or without
  /// known times forgets them again. All frames of a channel have as many values. An element with a
  /// 0 in `valid` (which may be empty), or that is NaN, is not valid.
  ///
  /// Throws InvalidArgument unless an exploration with that channel is open, and for sizes that do
  /// not fit. Errors: kData for a time that runs backwards or beyond the above, and for more than
  /// 16 MiB; kSystem with the system's reason.
  Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                     std::span<const std::uint8_t> valid = {});

  /// Throws InvalidArgument when none is open. Errors: kSystem with the system's reason.
  Result<void> end_exploration();

  /// Writes what makes the file whole and flushes it to the disk; throws InvalidArgument when an
  /// exploration is open or it is closed already. Errors: kSystem with the system's reason.
  Result<void> close();

  /// The same on the given file system, for tests.
  static Result<RecordingWriter> create(FileSystem& files, const std::string& path,
                                        const RecordingFileParameters& parameters);

 private:
  class State;
  explicit RecordingWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace somato
