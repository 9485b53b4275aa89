#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recordings/explorations/element_order.h"
#include "recordings/file/recording_layout.h"
#include "recordings/mcap/mcap_reader.h"
#include "recordings/ros/channel_reader.h"
#include "recordings/ros/topic_type.h"
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
  enum class Meaning { kNothing, kBegin, kContinue, kFrame, kEnd, kLeftOut };

  struct Frame {
    std::size_t channel = 0;          ///< In channels().
    std::int64_t time = 0;            ///< Nanoseconds on the exploration's clock.
    std::vector<float> values;        ///< 0 where not valid.
    std::vector<std::uint8_t> valid;  ///< Empty when all is valid.
  };

  explicit RecordingInterpreter(const McapReader& file) : file_(&file) {}

  /// The interpretation of the latest message; kLeftOut within an exploration that does not belong
  /// to the recording. A frame of a file without explorations may come
  /// without kBegin. Errors (kData, with file and position): invalid messages.
  Result<Meaning> interpret(const McapMessage& message);

  /// Whether an exploration is open at the end of the file that ought to have an end. Errors
  /// (kData): so.
  Result<void> finish() const;

  /// Data are missing from here: the exploration ends, unless the next message about explorations
  /// continues it.
  void after_gap() { gap_ = true; }

  bool is_open() const { return open_ && !is_left_out(); }
  bool is_foreign() const { return foreign_; }

  /// Whether the latest error is no damage, but a property of the messages of another program that
  /// frames of a channel do not have: their elements or the order of their times.
  bool is_unfit() const { return unfit_; }

  /// The begin message of the exploration that is open, or was open last, with the labels that it
  /// was given later.
  const ExplorationMessage& exploration() const { return exploration_; }
  const std::vector<InterpretedChannel>& channels() const { return channels_; }

  /// The frames of the message, at least one, after kFrame.
  const std::vector<Frame>& frames() const { return frames_; }

 private:
  // A channel in the messages of a topic.
  struct Source {
    ChannelReader reader;
    ChannelDescription description;
    bool is_in_radians = false;  // Positions of a JointState.
    std::size_t channel = 0;     // In channels_, once one has that id.
  };

  // The properties of a channel of the file.
  struct Stream {
    bool explorations = false;
    TopicMessages messages;
    std::vector<Source> sources;
  };

  bool is_left_out() const { return !foreign_ && file_->notes().is_left_out(exploration_.index); }
  Result<Meaning> interpret_any(const McapMessage& message);
  Result<Stream*> stream_of(std::uint16_t id);
  Result<std::vector<Source>> sources_of(const McapSchema& schema, const McapChannel& channel,
                                         const TopicType& topic);
  const TopicType& topic_of_schema(const McapSchema& schema, const std::string& message_encoding);
  Result<ChannelDescription> describe(const McapChannel& channel, const TopicChannel& source);
  Result<Meaning> interpret_exploration(std::string_view json);
  Meaning go_on(ExplorationMessage::Event event);
  Result<Meaning> begin(ExplorationMessage message, Meaning meaning);
  Result<void> open_channels();
  Result<Meaning> interpret_frames(Stream& stream, const McapMessage& message);
  Result<void> take_frame(Source& source, const McapMessage& message);
  Result<void> take_foreign_frame(Source& source, const McapMessage& message);
  Result<InterpretedChannel*> channel_for(Source& source, const McapMessage& message);
  Result<void> open_foreign_channel(const Source& source, const McapMessage& message,
                                    const ElementOrder& order);
  Result<void> add_frame(const Source& source, InterpretedChannel& channel,
                         const McapMessage& message);

  tl::unexpected<Error> bad_frame(const Source& source, const Error& error);
  tl::unexpected<Error> unfit(const std::string& what);

  const McapReader* file_;
  std::map<std::uint16_t, Stream> streams_;
  std::map<std::pair<std::uint16_t, std::string>, TopicType> topics_;
  std::map<std::string, std::size_t> channel_by_name_;
  std::vector<InterpretedChannel> channels_;
  std::map<std::string, ElementOrder>
      orders_;  // The orders of channels of other programs, by name.
  ExplorationMessage exploration_;
  std::string continue_json_;  // The messages that continue or end it, as they are written here.
  std::string end_json_;
  std::vector<Frame> frames_;
  std::string cdr_;             // The message that is being taken, unless the file has it in CDR.
  std::vector<double> values_;  // The frame that is being taken.
  std::size_t described_ = 0;   // Bytes of metadata.
  bool open_ = false;
  bool foreign_ = false;
  bool decided_ = false;  // Whether the file contains explorations.
  bool gap_ = false;
  bool unfit_ = false;
};

}  // namespace somato
