#include "views/exports/bag_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "base/text/text.h"
#include "recordings/explorations/nanoseconds.h"
#include "recordings/file/recording_layout.h"
#include "recordings/ros/cdr.h"
#include "somato/core/value.h"

namespace somato {
namespace {

constexpr const char* kJointStates = "sensor_msgs/msg/JointState";
constexpr std::int64_t kMillisecond = 1'000'000;

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

Result<std::int64_t> nanoseconds(double seconds) {
  const auto time = nanoseconds_of(seconds);
  if (time) return *time;
  return fail(ErrorKind::kData, fmt::format("a time is beyond {} s", kLatestSecond));
}

std::string toml(const std::string& text) {
  return to_toml(Value(text));
}

}  // namespace

Result<std::unique_ptr<RecordingExport>> BagExport::begin(const std::string& path) {
  SOMATO_TRY(auto writer, BagWriter::begin(path));
  return std::make_unique<BagExport>(std::move(writer));
}

Result<void> BagExport::open_topics(const ExplorationStart& first) {
  std::set<std::string> taken;
  SOMATO_TRY(events_, writer_->open_topic(free_name("/exploration", taken), text_schema()));
  for (const Label& label : first.labels) {
    const std::string topic = free_name("/labels/" + plain_name(label.name, "_"), taken);
    SOMATO_TRY(const std::size_t index, writer_->open_topic(topic, text_schema()));
    labels_.push_back(index);
    label_names_.push_back(label.name);
  }
  for (ChannelDescription description : first.channels) {
    description.rate = 0.0;  // A topic has one description, and its messages have times.
    description.times_known = true;
    const std::string topic = free_name(ros_topic(description.name), taken);
    SOMATO_TRY(const std::size_t index,
               writer_->open_topic(topic, schema_for(description), channel_for(description)));
    channels_.push_back(index);
    descriptions_.push_back(std::move(description));
  }
  return {};
}

// The labels and the event precede the frames, so that no reader confuses their order. Times of a
// calendar, which ascend, are unchanged.
Result<void> BagExport::begin_exploration(const ExplorationStart& start) {
  if (explorations_ == 0) SOMATO_TRY_VOID(open_topics(start));
  ++explorations_;
  open_.clear();
  double time = start.time;
  for (const ChannelDescription& channel : start.channels) {
    if (channel.rate > 0.0) time = std::min(time, 0.0);
    open_.push_back({channel.rate});
  }
  SOMATO_TRY(const std::int64_t begin, nanoseconds(time));
  zero_ = std::max<std::int64_t>(0, writer_->latest_time() + kNanosecondsASecond - begin);
  frame_time_ = zero_ + begin;
  const std::int64_t labelled = zero_ + begin - 2 * kMillisecond;
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    SOMATO_TRY_VOID(writer_->write(labels_[i], labelled, string_message(start.labels[i].value)));
  }
  return writer_->write(events_, labelled + kMillisecond,
                        string_message(std::to_string(explorations_)));
}

Result<void> BagExport::frame(std::size_t channel, std::span<const float> values, double time,
                              std::span<const std::uint8_t> valid) {
  ExportedChannel& of = open_[channel];
  if (of.rate > 0.0) time = static_cast<double>(of.frames) / of.rate;
  ++of.frames;
  SOMATO_TRY(const std::int64_t since, nanoseconds(time));
  frame_time_ = zero_ + since;
  values_.assign(values.begin(), values.end());
  for (std::size_t i = 0; i < valid.size(); ++i) {
    if (valid[i] == 0) values_[i] = std::numeric_limits<float>::quiet_NaN();
  }
  const auto stamp = static_cast<std::uint64_t>(frame_time_);
  return writer_->write(channels_[channel], frame_time_,
                        frame_message(descriptions_[channel], stamp, values_));
}

Result<void> BagExport::end_exploration() {
  return writer_->write(events_, writer_->latest_time() + kMillisecond, string_message(""));
}

std::string BagExport::description() const {
  std::string text = fmt::format(
      "# somato import bag BAG -o RECORDING --description BAG/import.toml\n\n[import]\n"
      "events = {}\n",
      toml(writer_->name_of(events_) + ":data"));
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const ChannelDescription& channel = descriptions_[i];
    const bool is_joints = writer_->type_of(channels_[i]) == kJointStates;
    text += fmt::format("\n[[channel]]\nname = {}\nunit = {}\ntopic = {}\nfields = [\"{}\"]\n",
                        toml(channel.name), toml(channel.unit), toml(topic_of_channel(i)),
                        field_of_channel(i));
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
                        toml(label_names_[i]), toml(writer_->name_of(labels_[i])));
  }
  return text;
}

std::string BagExport::field_of_channel(std::size_t channel) const {
  return writer_->type_of(channels_[channel]) == kJointStates ? "position" : "data";
}

Result<void> BagExport::finish() {
  SOMATO_TRY_VOID(writer_->save("import.toml", description()));
  return writer_->finish();
}

}  // namespace somato
