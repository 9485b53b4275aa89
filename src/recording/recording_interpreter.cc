#include "recording/recording_interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "files/text.h"

namespace somato {
namespace {

constexpr std::size_t kMostDescribed = std::size_t{2} << 20;
constexpr auto kLatest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());

std::size_t size_of(const std::map<std::string, std::string>& metadata) {
  std::size_t size = 0;
  for (const auto& [name, text] : metadata) size += name.size() + text.size();
  return size;
}

// Whether the number `elements` fits the description.
bool fits(const ChannelDescription& description, std::size_t elements) {
  const std::size_t names = description.element_names.size();
  std::size_t filled = elements;
  if (!description.shape.empty()) {
    filled = 1;
    for (const std::size_t length : description.shape) {
      filled = length > elements ? 0 : filled * length;
      if (filled > elements) break;
    }
  }
  return filled == elements && (names == 0 || names == elements);
}

}  // namespace

Result<RecordingInterpreter::Meaning> RecordingInterpreter::interpret(const McapMessage& message) {
  SOMATO_TRY(Stream * stream, stream_of(message.channel_id));
  if (stream->explorations) return interpret_exploration(message.data);
  if (stream->frames) return interpret_frame(*stream, message);
  return Meaning::kNothing;
}

Result<void> RecordingInterpreter::finish() const {
  if (!open_ || foreign_) return {};
  return file_->bad(fmt::format("exploration {} has no end", exploration_.index + 1));
}

Result<RecordingInterpreter::Stream*> RecordingInterpreter::stream_of(std::uint16_t id) {
  const auto known = streams_.find(id);
  if (known != streams_.end()) return &known->second;
  const McapSchema& schema = file_->schema_of(id);
  Stream stream;
  stream.explorations = is_exploration_schema(schema);
  stream.frames = ros_kind(schema, file_->channel(id));
  if (stream.frames && !decided_) {
    decided_ = true;
    foreign_ = file_->header().profile != kRecordingProfile;
  }
  if (stream.frames) {
    SOMATO_TRY(auto description, describe(file_->channel(id), *stream.frames));
    stream.description = std::move(description);
  }
  return &streams_.emplace(id, std::move(stream)).first->second;
}

// Metadata of other programs are ignored.
Result<ChannelDescription> RecordingInterpreter::describe(const McapChannel& channel,
                                                          RosKind kind) {
  described_ += size_of(channel.metadata);
  if (described_ > kMostDescribed) {
    return file_->bad(fmt::format("the metadata of channels exceed {} MiB", kMostDescribed >> 20));
  }
  Result<ChannelDescription> description = parse_description(channel);
  if (foreign_ && !description) {
    McapChannel plain = channel;
    plain.metadata.clear();
    description = parse_description(plain);
  }
  if (!description) return file_->bad(description.error().what);
  const bool has_unit = channel.metadata.contains("unit");
  if (foreign_ && !has_unit && kind == RosKind::kJointState) description->unit = "rad";
  return description;
}

Result<RecordingInterpreter::Meaning> RecordingInterpreter::interpret_exploration(
    std::string_view json) {
  using Event = ExplorationMessage::Event;
  if (foreign_) return file_->bad("an exploration begins after frames");
  decided_ = true;
  Result<ExplorationMessage> message = parse_exploration_json(json);
  if (!message) return file_->bad(message.error().what, message.error().advice);
  const bool same = open_ && message->index == exploration_.index;
  if (message->event == Event::kContinue && same) {
    gap_ = false;
    return Meaning::kContinue;
  }
  if (message->event == Event::kEnd && same) {
    open_ = false;
    gap_ = false;
    return Meaning::kEnd;
  }
  if (message->event == Event::kEnd || (message->event == Event::kContinue && !gap_)) {
    return file_->bad(
        fmt::format("exploration {} ends or continues, but has not begun", message->index + 1));
  }
  if (open_ && !gap_) {
    return file_->bad(fmt::format("exploration {} begins before exploration {} ends",
                                  message->index + 1, exploration_.index + 1));
  }
  return begin(std::move(*message), Meaning::kBegin);
}

Result<RecordingInterpreter::Meaning> RecordingInterpreter::begin(ExplorationMessage message,
                                                                  Meaning meaning) {
  open_ = false;
  exploration_ = std::move(message);
  gap_ = false;
  SOMATO_TRY_VOID(open_channels());
  open_ = true;
  return meaning;
}

// A channel's description is the one announced last before the exploration begins, until there is a
// frame: other writers announce a channel only then.
Result<void> RecordingInterpreter::open_channels() {
  channels_.clear();
  channel_by_name_.clear();
  for (auto& [id, stream] : streams_) stream.channel = 0;
  for (const std::string& name : exploration_.channels) {
    if (name.empty() || !channel_by_name_.emplace(name, channels_.size()).second) {
      return file_->bad(fmt::format("exploration {} has two channels {}, or one without a name",
                                    exploration_.index + 1, shown(name)));
    }
    InterpretedChannel channel;
    channel.description.name = name;
    if (const McapChannel* announced = file_->latest(topic_of(name))) {
      SOMATO_TRY(Stream * stream, stream_of(announced->id));
      if (stream->frames) channel.description = stream->description;
    }
    channels_.push_back(std::move(channel));
  }
  return {};
}

Result<RecordingInterpreter::Meaning> RecordingInterpreter::interpret_frame(
    Stream& stream, const McapMessage& message) {
  const std::string& name = stream.description.name;
  if (!foreign_ && (!open_ || gap_)) {
    return file_->bad(fmt::format("a frame of {} is outside all explorations", shown(name)));
  }
  if (message.log_time > kLatest) {
    return file_->bad(
        fmt::format("a frame of {} has the time {} ns", shown(name), message.log_time));
  }
  const std::optional<RosFrame> frame = parse_ros_message(*stream.frames, message.data);
  if (!frame) {
    return file_->bad(fmt::format("a frame of {} does not fill its message", shown(name)));
  }
  if (foreign_ && !open_) {
    exploration_ = {};
    exploration_.source = file_->path();
    exploration_.zero = static_cast<std::int64_t>(message.log_time);
    open_ = true;
  }
  SOMATO_TRY(const auto channel, channel_for(stream, message, *frame));
  return take_frame(*channel, *stream.frames, message, *frame).map([&] {
    frame_.channel = stream.channel;
    return Meaning::kFrame;
  });
}

Result<InterpretedChannel*> RecordingInterpreter::channel_for(Stream& stream,
                                                              const McapMessage& message,
                                                              const RosFrame& frame) {
  const std::string& name = stream.description.name;
  if (foreign_ && channel_by_name_.emplace(name, channels_.size()).second) {
    InterpretedChannel channel;
    channel.description = stream.description;
    if (!channel.description.shape.empty() || !fits(channel.description, frame.values.size())) {
      channel.description.shape.clear();
      channel.description.element_names.clear();
    }
    if (channel.description.shape.empty()) channel.description.shape = frame.shape;
    if (channel.description.element_names.empty() && frame.names.size() == frame.values.size()) {
      channel.description.element_names.assign(frame.names.begin(), frame.names.end());
    }
    channels_.push_back(std::move(channel));
  }
  const auto found = channel_by_name_.find(name);
  if (found == channel_by_name_.end()) {
    return file_->bad(
        fmt::format("exploration {} has no channel {}", exploration_.index + 1, shown(name)));
  }
  stream.channel = found->second;
  InterpretedChannel& channel = channels_[found->second];
  if (!channel.id && !foreign_) channel.description = stream.description;
  if (!channel.id) channel.id = message.channel_id;
  if (*channel.id == message.channel_id) return &channel;
  return file_->bad(fmt::format("channel {} comes from two channels of the file", shown(name)));
}

Result<void> RecordingInterpreter::take_frame(InterpretedChannel& channel, RosKind kind,
                                              const McapMessage& message, const RosFrame& frame) {
  const std::size_t elements = frame.values.size();
  if (elements == 0 || !fits(channel.description, elements) ||
      (channel.frames > 0 && elements != channel.elements)) {
    return file_->bad(fmt::format("a frame of {} has {} elements, which is the wrong number",
                                  shown(channel.description.name), elements));
  }
  const std::int64_t time = static_cast<std::int64_t>(message.log_time) - exploration_.zero;
  if (time < channel.latest) {
    return file_->bad(fmt::format("the times of {} decrease", shown(channel.description.name)));
  }
  channel.elements = elements;
  channel.latest = time;
  ++channel.frames;
  frame_.time = time;
  frame_.values = frame_values(channel.description, kind, frame.values);
  frame_.valid.clear();
  for (std::size_t i = 0; i < elements; ++i) {
    if (!std::isnan(frame_.values[i])) continue;
    frame_.valid.resize(elements, 1);
    frame_.valid[i] = 0;
    frame_.values[i] = 0.0F;
  }
  return {};
}

}  // namespace somato
