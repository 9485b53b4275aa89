#include "exports/bag_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "files/text.h"
#include "recording/frame_writer.h"
#include "recording/nanoseconds.h"
#include "recording/recording_layout.h"
#include "ros/cdr.h"
#include "somato/core/value.h"

namespace somato {
namespace {

constexpr const char* kBagFile = "bag_0.mcap";
constexpr const char* kJointStates = "sensor_msgs/msg/JointState";
constexpr std::int64_t kMillisecond = 1'000'000;
constexpr std::size_t kChunkBytes = std::size_t{1} << 20;

McapSchema text_schema() {
  return {0, "std_msgs/msg/String", "ros2msg", "string data\n"};
}

std::string string_message(std::string_view text) {
  return CdrWriter().text(text).bytes();
}

// A topic whose name ROS 2 permits: letters, digits and underscores between slashes, no digit
// behind a slash.
std::string ros_topic(const std::string& name) {
  std::string topic;
  for (const std::string& part : split(plain_name(name, "_/"), '/')) {
    const bool needs_letter = part.empty() || (part.front() >= '0' && part.front() <= '9');
    topic += (needs_letter ? "/_" : "/") + part;
  }
  return topic;
}

std::string toml(const std::string& text) {
  return to_toml(Value(text));
}

}  // namespace

Result<std::unique_ptr<RecordingExport>> BagExport::begin(const std::string& path) {
  SOMATO_TRY(NewFolder folder, NewFolder::begin(path));
  SOMATO_TRY(FileWriter file, FileWriter::begin(folder.file(kBagFile)));
  auto bag = std::make_unique<BagExport>(std::move(folder), std::move(file));
  SOMATO_TRY_VOID(bag->writer_.begin({"ros2", "somato"}));
  return bag;
}

BagExport::BagExport(NewFolder folder, FileWriter file)
    : folder_(std::move(folder)),
      file_(std::move(file)),
      writer_([this](std::string_view bytes) { return file_.write(bytes); }, Compression::kZstd,
              kChunkBytes) {}

Result<std::size_t> BagExport::open_topic(const std::string& name, const McapSchema& schema,
                                          McapChannel channel) {
  channel.topic = name;
  channel.message_encoding = "cdr";
  channel.metadata["offered_qos_profiles"] = "";
  SOMATO_TRY(const std::uint16_t id, writer_.channel(&schema, std::move(channel)));
  topics_.push_back({name, schema.name, id});
  return topics_.size() - 1;
}

Result<void> BagExport::open_topics(const Exploration& first) {
  std::set<std::string> taken;
  SOMATO_TRY(events_, open_topic(free_name("/exploration", taken), text_schema(), {}));
  for (const Label& label : first.labels) {
    const std::string topic = free_name("/labels/" + plain_name(label.name, "_"), taken);
    SOMATO_TRY(const std::size_t index, open_topic(topic, text_schema(), {}));
    labels_.push_back(index);
    label_names_.push_back(label.name);
  }
  for (const Channel& channel : first.channels) {
    ChannelDescription description = description_of(channel);
    description.rate = 0.0;  // A topic has one description, and its messages have times.
    description.times_known = true;
    const std::string topic = free_name(ros_topic(channel.name), taken);
    SOMATO_TRY(const std::size_t index,
               open_topic(topic, schema_for(description), channel_for(description)));
    channels_.push_back(index);
    descriptions_.push_back(std::move(description));
  }
  return {};
}

Result<void> BagExport::write(std::size_t topic, std::int64_t time, std::string_view message) {
  if (!first_time_) first_time_ = time;
  latest_time_ = time;
  const auto log_time = static_cast<std::uint64_t>(time);
  Topic& to = topics_[topic];
  return writer_.add({to.id, to.messages++, log_time, log_time, message});
}

// The labels and the event precede the frames, so that no reader confuses their order.
Result<void> BagExport::begin_exploration(const Exploration& exploration, std::int64_t start) {
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    SOMATO_TRY_VOID(
        write(labels_[i], start - 2 * kMillisecond, string_message(exploration.labels[i].value)));
  }
  return write(events_, start - kMillisecond, string_message(std::to_string(explorations_)));
}

Result<void> BagExport::add(const Exploration& exploration) {
  if (explorations_ == 0) SOMATO_TRY_VOID(open_topics(exploration));
  ++explorations_;
  const std::vector<PlacedFrame> frames = frames_in_time(exploration);
  const auto start = nanoseconds_of(frames.front().time);
  const auto end = nanoseconds_of(frames.back().time);
  if (!start || !end) {
    return fail(ErrorKind::kData,
                fmt::format("exploration {} has times beyond {} s", explorations_, kLatestSecond));
  }
  // Times of a calendar, which ascend, are unchanged.
  const std::int64_t zero = std::max<std::int64_t>(0, latest_time_ + kNanosecondsASecond - *start);
  SOMATO_TRY_VOID(begin_exploration(exploration, zero + *start));
  for (const PlacedFrame& placed : frames) {
    const std::int64_t time = zero + nanoseconds_of(placed.time).value_or(*end);
    SOMATO_TRY_VOID(add_frame(exploration, placed.channel, placed.frame, time));
  }
  return write(events_, zero + *end + kMillisecond, string_message(""));
}

Result<void> BagExport::add_frame(const Exploration& exploration, std::size_t channel,
                                  std::size_t frame, std::int64_t time) {
  const Channel& of = exploration.channels[channel];
  const auto row = of.frames.row(frame);
  values_.assign(row.begin(), row.end());
  for (std::size_t i = 0; !of.valid.empty() && i < values_.size(); ++i) {
    if (of.valid(frame, i) == 0) values_[i] = std::numeric_limits<float>::quiet_NaN();
  }
  return write(channels_[channel], time,
               frame_message(descriptions_[channel], static_cast<std::uint64_t>(time), values_));
}

std::string BagExport::metadata() const {
  std::uint64_t messages = 0;
  for (const Topic& topic : topics_) messages += topic.messages;
  const std::int64_t start = first_time_.value_or(0);
  const std::int64_t duration = latest_time_ - start;
  std::string text = fmt::format(
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: mcap\n  duration:\n"
      "    nanoseconds: {}\n  starting_time:\n    nanoseconds_since_epoch: {}\n"
      "  message_count: {}\n  topics_with_message_count:\n",
      duration, start, messages);
  for (const Topic& topic : topics_) {
    text += fmt::format(
        "    - topic_metadata:\n        name: {}\n        type: {}\n"
        "        serialization_format: cdr\n        offered_qos_profiles: \"\"\n"
        "      message_count: {}\n",
        topic.name, topic.type, topic.messages);
  }
  return text + fmt::format(
                    "  compression_format: \"\"\n  compression_mode: \"\"\n"
                    "  relative_file_paths:\n    - {0}\n  files:\n    - path: {0}\n"
                    "      starting_time:\n        nanoseconds_since_epoch: {1}\n"
                    "      duration:\n        nanoseconds: {2}\n      message_count: {3}\n",
                    kBagFile, start, duration, messages);
}

std::string BagExport::description() const {
  std::string text = fmt::format(
      "# somato import bag BAG -o RECORDING --description BAG/import.toml\n\n[import]\n"
      "events = {}\n",
      toml(topics_[events_].name + ":data"));
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const ChannelDescription& channel = descriptions_[i];
    const Topic& topic = topics_[channels_[i]];
    const bool is_joints = topic.type == kJointStates;
    text += fmt::format("\n[[channel]]\nname = {}\nunit = {}\ntopic = {}\nfields = [\"{}\"]\n",
                        toml(channel.name), toml(channel.unit), toml(topic.name),
                        is_joints ? "position" : "data");
    if (is_joints && !channel.element_names.empty()) text += "names = \"name\"\n";
    if (is_joints && channel.unit == "deg") {
      text += fmt::format("factor = {}\n", to_toml(Value(180.0 / std::numbers::pi)));
    }
    if (!channel.shape.empty()) {
      text += fmt::format("shape = [{}]\n", fmt::join(channel.shape, ", "));
    }
  }
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    text += fmt::format("\n[[label]]\nname = {}\ntopic = {}\nfield = \"data\"\n",
                        toml(label_names_[i]), toml(topics_[labels_[i]].name));
  }
  return text;
}

Result<void> BagExport::save(const std::string& name, const std::string& text) const {
  SOMATO_TRY(FileWriter file, FileWriter::begin(folder_.file(name)));
  return file.write(text).and_then([&] { return file.commit(); });
}

Result<void> BagExport::finish() {
  SOMATO_TRY_VOID(writer_.finish());
  SOMATO_TRY_VOID(file_.commit());
  SOMATO_TRY_VOID(save("metadata.yaml", metadata()));
  SOMATO_TRY_VOID(save("import.toml", description()));
  return folder_.commit();
}

}  // namespace somato
