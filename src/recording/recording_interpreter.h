#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "recording/mcap_reader.h"
#include "recording/recording_layout.h"
#include "somato/core/result.h"

namespace somato {

/// A channel of the exploration that is being read.
struct InterpretedChannel {
  ChannelDescription description;
  std::optional<std::uint16_t> id;  ///< In the file, once there is a frame.
  std::size_t frames = 0;
  std::size_t elements = 0;  ///< The number of elements of every frame.
  std::int64_t latest = std::numeric_limits<std::int64_t>::min();
};

/// Interprets the messages of an MCAP file: explorations with frames of channels, or, in files
/// without explorations, all frames as one exploration.
class RecordingInterpreter {
 public:
  enum class Meaning { kNothing, kBegin, kContinue, kFrame, kEnd };

  struct Frame {
    std::size_t channel = 0;          ///< In channels().
    std::int64_t time = 0;            ///< Nanoseconds on the exploration's clock.
    std::vector<float> values;        ///< 0 where not valid.
    std::vector<std::uint8_t> valid;  ///< Empty when all is valid.
  };

  explicit RecordingInterpreter(const McapReader& file) : file_(&file) {}

  /// The interpretation of the latest message. A frame of a file without explorations may come
  /// without kBegin. Errors (kData, with file and position): invalid messages.
  Result<Meaning> interpret(const McapMessage& message);

  /// Whether an exploration is open at the end of the file that ought to have an end. Errors
  /// (kData): so.
  Result<void> finish() const;

  /// Data are missing from here: the exploration ends, unless the next message about explorations
  /// continues it.
  void after_gap() { gap_ = true; }

  bool is_open() const { return open_; }
  bool is_foreign() const { return foreign_; }

  /// The begin message of the exploration that is open, or was open last.
  const ExplorationMessage& exploration() const { return exploration_; }
  const std::vector<InterpretedChannel>& channels() const { return channels_; }

  /// The frame, after kFrame.
  const Frame& frame() const { return frame_; }

 private:
  // The properties of a channel of the file.
  struct Stream {
    bool explorations = false;
    std::optional<RosKind> frames;
    ChannelDescription description;
    std::size_t channel = 0;  // In channels_, once one has that id.
  };

  Result<Stream*> stream_of(std::uint16_t id);
  Result<ChannelDescription> describe(const McapChannel& channel, RosKind kind);
  Result<Meaning> interpret_exploration(std::string_view json);
  Result<Meaning> begin(ExplorationMessage message, Meaning meaning);
  Result<void> open_channels();
  Result<Meaning> interpret_frame(Stream& stream, const McapMessage& message);
  Result<InterpretedChannel*> channel_for(Stream& stream, const McapMessage& message,
                                          const RosFrame& frame);
  Result<void> take_frame(InterpretedChannel& channel, RosKind kind, const McapMessage& message,
                          const RosFrame& frame);

  const McapReader* file_;
  std::map<std::uint16_t, Stream> streams_;
  std::map<std::string, std::size_t> channel_by_name_;
  std::vector<InterpretedChannel> channels_;
  ExplorationMessage exploration_;
  Frame frame_;
  std::size_t described_ = 0;  // Bytes of metadata.
  bool open_ = false;
  bool foreign_ = false;
  bool decided_ = false;  // Whether the file contains explorations.
  bool gap_ = false;
};

}  // namespace somato
