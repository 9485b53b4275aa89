#include "recordings/file/recording_interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text/text.h"
#include "recordings/ros/known_types.h"

namespace somato {
namespace {

constexpr std::string_view kRosDefinitions = "ros2msg";
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

// The message that is written when an exploration that has begun continues or ends.
std::string later_json(ExplorationMessage begun, ExplorationMessage::Event event) {
  begun.event = event;
  return exploration_json(begun);
}

}  // namespace

Result<RecordingInterpreter::Meaning> RecordingInterpreter::interpret(const McapMessage& message) {
  unfit_ = false;
  Result<Meaning> meaning = interpret_any(message);
  const bool is_left_out = meaning && *meaning != Meaning::kNothing && this->is_left_out();
  if (is_left_out) *meaning = Meaning::kLeftOut;
  return meaning;
}

Result<RecordingInterpreter::Meaning> RecordingInterpreter::interpret_any(
    const McapMessage& message) {
  SOMATO_TRY(Stream * stream, stream_of(message.channel_id));
  if (stream->explorations) return interpret_exploration(message.data);
  if (!stream->sources.empty()) return interpret_frames(*stream, message);
  return Meaning::kNothing;
}

Result<void> RecordingInterpreter::finish() const {
  if (!is_open() || foreign_) return {};
  return file_->bad(fmt::format("exploration {} has no end", exploration_.index + 1));
}

Result<RecordingInterpreter::Stream*> RecordingInterpreter::stream_of(std::uint16_t id) {
  const auto known = streams_.find(id);
  if (known != streams_.end()) return &known->second;
  const McapSchema& schema = file_->schema_of(id);
  Stream stream;
  stream.explorations = is_exploration_schema(schema);
  if (!stream.explorations) {
    const McapChannel& channel = file_->channel(id);
    const TopicType& topic = topic_of_schema(schema, channel.message_encoding);
    stream.messages = topic.messages;
    SOMATO_TRY(stream.sources, sources_of(schema, channel, topic));
  }
  return &streams_.emplace(id, std::move(stream)).first->second;
}

// Recordings of explorations have frames in messages of few types.
Result<std::vector<RecordingInterpreter::Source>> RecordingInterpreter::sources_of(
    const McapSchema& schema, const McapChannel& channel, const TopicType& topic) {
  std::vector<Source> sources;
  if (topic.channels.empty()) return sources;
  if (!decided_) {
    decided_ = true;
    foreign_ = file_->header().profile != kRecordingProfile;
  }
  for (const TopicChannel& source : topic.channels) {
    const bool is_own = source.suffix.empty() && standard_definition(schema.name);
    if (!foreign_ && !is_own) continue;
    SOMATO_TRY(ChannelDescription description, describe(channel, source));
    const bool is_in_radians = is_own && schema.name == joint_state_schema().name;
    sources.push_back({source.reader, std::move(description), is_in_radians});
  }
  return sources;
}

// Many channels of a file may have one schema with a long definition.
const TopicType& RecordingInterpreter::topic_of_schema(const McapSchema& schema,
                                                       const std::string& message_encoding) {
  const auto [known, is_new] = topics_.try_emplace({schema.id, message_encoding});
  if (is_new && known_type(schema.name)) {
    const bool is_cdr = message_encoding == "cdr";
    const auto standard = is_cdr ? standard_definition(schema.name) : std::nullopt;
    known->second = topic_type({schema.name, message_encoding,
                                standard ? std::string(kRosDefinitions) : schema.encoding,
                                standard.value_or(schema.data)});
  }
  return known->second;
}

// Metadata of other programs are ignored.
Result<ChannelDescription> RecordingInterpreter::describe(const McapChannel& channel,
                                                          const TopicChannel& source) {
  described_ += size_of(channel.metadata);
  if (described_ > kMostDescribed) {
    return file_->bad(fmt::format("the metadata of channels exceed {} MiB", kMostDescribed >> 20));
  }
  McapChannel plain = channel;
  if (!source.suffix.empty()) plain.metadata.clear();
  Result<ChannelDescription> description = parse_description(plain);
  if (foreign_ && !description) {
    plain.metadata.clear();
    description = parse_description(plain);
  }
  if (!description) return file_->bad(description.error().what);
  description->name += source.suffix;
  if (foreign_ && !plain.metadata.contains("unit")) description->unit = source.unit;
  return description;
}

Result<RecordingInterpreter::Meaning> RecordingInterpreter::interpret_exploration(
    std::string_view json) {
  using Event = ExplorationMessage::Event;
  if (foreign_) return file_->bad("an exploration begins after frames");
  decided_ = true;
  if (open_ && json == continue_json_) return go_on(Event::kContinue);
  if (open_ && json == end_json_) return go_on(Event::kEnd);
  Result<ExplorationMessage> message = parse_exploration_json(json);
  if (!message) return file_->bad(message.error().what, message.error().advice);
  const bool same = open_ && message->index == exploration_.index;
  if (same && message->event != Event::kBegin) return go_on(message->event);
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

// The open exploration continues or ends.
RecordingInterpreter::Meaning RecordingInterpreter::go_on(ExplorationMessage::Event event) {
  gap_ = false;
  open_ = event != ExplorationMessage::Event::kEnd;
  return open_ ? Meaning::kContinue : Meaning::kEnd;
}

Result<RecordingInterpreter::Meaning> RecordingInterpreter::begin(ExplorationMessage message,
                                                                  Meaning meaning) {
  open_ = false;
  exploration_ = std::move(message);
  continue_json_ = later_json(exploration_, ExplorationMessage::Event::kContinue);
  end_json_ = later_json(exploration_, ExplorationMessage::Event::kEnd);
  exploration_.labels = file_->notes().labels(exploration_.index, std::move(exploration_.labels));
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
  for (auto& [id, stream] : streams_) {
    for (Source& source : stream.sources) source.channel = 0;
  }
  for (const std::string& name : exploration_.channels) {
    if (name.empty() || !channel_by_name_.emplace(name, channels_.size()).second) {
      return file_->bad(fmt::format("exploration {} has two channels {}, or one without a name",
                                    exploration_.index + 1, shown(name)));
    }
    InterpretedChannel channel;
    channel.description.name = name;
    if (const McapChannel* announced = file_->latest(topic_of(name))) {
      SOMATO_TRY(Stream * stream, stream_of(announced->id));
      if (!stream->sources.empty()) channel.description = stream->sources.front().description;
    }
    channels_.push_back(std::move(channel));
  }
  return {};
}

Result<RecordingInterpreter::Meaning> RecordingInterpreter::interpret_frames(
    Stream& stream, const McapMessage& message) {
  const std::string& name = stream.sources.front().description.name;
  if (!foreign_ && (!open_ || gap_)) {
    return file_->bad(fmt::format("a frame of {} is outside all explorations", shown(name)));
  }
  if (message.log_time > kLatest) {
    return file_->bad(
        fmt::format("a frame of {} has the time {} ns", shown(name), message.log_time));
  }
  frames_.clear();
  McapMessage decoded = message;
  const auto cdr = stream.messages.in_cdr(message.data, cdr_);
  if (!cdr) return bad_frame(stream.sources.front(), cdr.error());
  decoded.data = *cdr;
  for (Source& source : stream.sources) SOMATO_TRY_VOID(take_frame(source, decoded));
  return frames_.empty() ? Meaning::kNothing : Meaning::kFrame;
}

Result<void> RecordingInterpreter::take_frame(Source& source, const McapMessage& message) {
  if (foreign_) return take_foreign_frame(source, message);
  Result<void> read = source.reader.read(message.data, values_);
  if (!read) return bad_frame(source, read.error());
  SOMATO_TRY(InterpretedChannel * channel, channel_for(source, message));
  return add_frame(source, *channel, message);
}

// Messages of other programs may lack values, such as the efforts of joints.
Result<void> RecordingInterpreter::take_foreign_frame(Source& source, const McapMessage& message) {
  const std::string& name = source.description.name;
  ElementOrder& order = orders_.try_emplace(name, source.reader.order()).first->second;
  const Result<bool> read = source.reader.read(message.data, order, values_);
  if (!read) {
    const Result<void> decoded = source.reader.read(message.data, values_);
    return decoded
               ? unfit(fmt::format("the elements of {} differ: {}", shown(name), read.error().what))
               : bad_frame(source, decoded.error());
  }
  if (values_.empty()) return {};
  if (!open_) {
    exploration_ = {};
    exploration_.source = file_->path();
    exploration_.zero = static_cast<std::int64_t>(message.log_time);
    open_ = true;
  }
  const auto [known, is_new] = channel_by_name_.emplace(name, channels_.size());
  if (is_new) SOMATO_TRY_VOID(open_foreign_channel(source, message, order));
  source.channel = known->second;
  return add_frame(source, channels_[known->second], message);
}

tl::unexpected<Error> RecordingInterpreter::bad_frame(const Source& source, const Error& error) {
  return file_->bad(fmt::format("a frame of {}: {}", shown(source.description.name), error.what),
                    error.advice);
}

tl::unexpected<Error> RecordingInterpreter::unfit(const std::string& what) {
  unfit_ = foreign_;
  return foreign_ ? file_->bad(what,
                               fmt::format("import it: somato import bag {} -o OUT", file_->path()))
                  : file_->bad(what);
}

Result<void> RecordingInterpreter::open_foreign_channel(const Source& source,
                                                        const McapMessage& message,
                                                        const ElementOrder& order) {
  SOMATO_TRY(std::vector<std::size_t> shape, source.reader.shape(message.data));
  InterpretedChannel channel;
  channel.description = source.description;
  if (!channel.description.shape.empty() || !fits(channel.description, values_.size())) {
    channel.description.shape.clear();
    channel.description.element_names.clear();
  }
  if (channel.description.shape.empty()) channel.description.shape = std::move(shape);
  if (channel.description.element_names.empty()) {
    channel.description.element_names = order.names();
  }
  channels_.push_back(std::move(channel));
  return {};
}

Result<InterpretedChannel*> RecordingInterpreter::channel_for(Source& source,
                                                              const McapMessage& message) {
  const std::string& name = source.description.name;
  const auto found = channel_by_name_.find(name);
  if (found == channel_by_name_.end()) {
    return file_->bad(
        fmt::format("exploration {} has no channel {}", exploration_.index + 1, shown(name)));
  }
  source.channel = found->second;
  InterpretedChannel& channel = channels_[found->second];
  if (!channel.id) {
    channel.description = source.description;
    channel.id = message.channel_id;
  }
  if (*channel.id == message.channel_id) return &channel;
  return file_->bad(fmt::format("channel {} comes from two channels of the file", shown(name)));
}

Result<void> RecordingInterpreter::add_frame(const Source& source, InterpretedChannel& channel,
                                             const McapMessage& message) {
  const std::size_t elements = values_.size();
  if (elements == 0 || !fits(channel.description, elements) ||
      (channel.frames > 0 && elements != channel.elements)) {
    return unfit(fmt::format("a frame of {} has {} elements, which is the wrong number",
                             shown(channel.description.name), elements));
  }
  const std::int64_t time = static_cast<std::int64_t>(message.log_time) - exploration_.zero;
  if (time < channel.latest) {
    return unfit(fmt::format("the times of {} decrease", shown(channel.description.name)));
  }
  channel.elements = elements;
  channel.latest = time;
  ++channel.frames;
  Frame frame{
      source.channel, time, frame_values(channel.description, source.is_in_radians, values_), {}};
  for (std::size_t i = 0; i < elements; ++i) {
    if (!std::isnan(frame.values[i])) continue;
    frame.valid.resize(elements, 1);
    frame.valid[i] = 0;
    frame.values[i] = 0.0F;
  }
  frames_.push_back(std::move(frame));
  return {};
}

}  // namespace somato
