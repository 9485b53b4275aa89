#include "recordings/bags/topic_use.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

#include "recordings/explorations/nanoseconds.h"

namespace somato {
namespace {

// ROS 2 has the first, schemas of Foxglove have the second.
constexpr const char* kStamps[] = {"header.stamp", "timestamp"};

// The nanoseconds of a stamp must fit into 64 bits.
constexpr double kMostSeconds = 9e9;

class WordSink : public FieldSink {
 public:
  void take(const RosScalar& scalar, FieldPlace /*place*/) override {
    if (!words.empty()) words += ",";
    words += to_string(scalar);
  }
  std::string words;
};

class TimeSink : public FieldSink {
 public:
  void take(const RosScalar& scalar, FieldPlace /*place*/) override {
    numbers.push_back(scalar.number());
  }
  std::vector<double> numbers;
};

// A field of texts or of numbers.
Result<FieldReader> compile_words(const std::shared_ptr<const RosType>& type,
                                  const std::string& path) {
  const Result<FieldReader> texts = FieldReader::compile(type, path, FieldKind::kTexts);
  return texts ? texts : FieldReader::compile(type, path);
}

BagChannel channel_of_known_type(const std::string& topic, const TopicChannel& channel) {
  BagChannel description;
  description.name = topic.substr(topic.starts_with('/') ? 1 : 0) + channel.suffix;
  description.unit = channel.unit;
  description.topic = topic;
  return description;
}

std::string topic_of_events(const BagTrials& trials) {
  return trials.events.substr(0, trials.events.find(':'));
}

std::string field_of_events(const BagTrials& trials) {
  const std::size_t colon = trials.events.find(':');
  return colon == std::string::npos ? std::string() : trials.events.substr(colon + 1);
}

// Compiles the fields that the description mentions.
class UseCompiler {
 public:
  UseCompiler(const BagTopic& topic, const BagImport& description)
      : topic_(&topic), description_(&description) {}

  Result<TopicUse> run() {
    SOMATO_TRY_VOID(add_channels());
    SOMATO_TRY_VOID(add_labels());
    SOMATO_TRY_VOID(add_event());
    const bool has_stamp = description_->trials.clock == BagClock::kHeader;
    if (has_stamp && !use_.channels.empty()) SOMATO_TRY_VOID(add_stamp());
    use_.messages = messages_;
    const bool is_used = !use_.channels.empty() || !use_.labels.empty() || use_.is_event;
    if (!is_used && use_.reason.empty()) use_.reason = "no channel or label mentions it";
    return std::move(use_);
  }

 private:
  Result<std::shared_ptr<const RosType>> type() {
    if (!messages_.type) {
      SOMATO_TRY(messages_, compile_topic_messages(topic_->encoding));
    }
    return messages_.type;
  }

  Result<void> add_channels() {
    if (description_->channels.empty()) {
      add_known_channels();
      return {};
    }
    for (const BagChannel& channel : description_->channels) {
      if (channel.topic != topic_->name) continue;
      SOMATO_TRY(const auto type, this->type());
      SOMATO_TRY(ChannelReader reader, ChannelReader::compile(type, channel.fields, channel.names));
      use_.channels.push_back({channel, std::move(reader)});
    }
    return {};
  }

  void add_known_channels() {
    TopicType known = topic_type(topic_->encoding);
    messages_ = known.messages;
    use_.reason = known.reason;
    for (TopicChannel& channel : known.channels) {
      use_.channels.push_back(
          {channel_of_known_type(topic_->name, channel), std::move(channel.reader)});
    }
  }

  Result<void> add_labels() {
    for (std::size_t i = 0; i < description_->labels.size(); ++i) {
      const BagLabel& label = description_->labels[i];
      if (label.topic != topic_->name) continue;
      SOMATO_TRY(const auto type, this->type());
      SOMATO_TRY(FieldReader reader, compile_words(type, label.field));
      use_.labels.push_back({i, std::move(reader)});
    }
    return {};
  }

  Result<void> add_event() {
    if (topic_of_events(description_->trials) != topic_->name) return {};
    use_.is_event = true;
    const std::string field = field_of_events(description_->trials);
    if (field.empty()) return {};
    SOMATO_TRY(const auto type, this->type());
    SOMATO_TRY(use_.event, compile_words(type, field));
    return {};
  }

  Result<void> add_stamp() {
    SOMATO_TRY(const auto type, this->type());
    for (const char* path : kStamps) {
      Result<FieldReader> stamp = FieldReader::compile(type, path);
      if (!stamp) continue;
      use_.stamp = std::move(*stamp);
      return {};
    }
    return fail(ErrorKind::kUsage,
                fmt::format("messages of {} have no header with a stamp", topic_->encoding.type),
                {}, "use the receiver's clock");
  }

  const BagTopic* topic_;
  const BagImport* description_;
  TopicMessages messages_;
  TopicUse use_;
};

}  // namespace

Result<TopicUse> use_of_topic(const BagTopic& topic, const BagImport& description) {
  Result<TopicUse> use = UseCompiler(topic, description).run();
  if (use) return use;
  Error error = use.error();
  error.where =
      fmt::format("topic {}{}{}", topic.name, error.where.empty() ? "" : ", ", error.where);
  return fail(std::move(error));
}

Result<std::string> words_at(const FieldReader& reader, std::string_view message) {
  WordSink sink;
  SOMATO_TRY_VOID(reader.read(message, sink));
  return std::move(sink.words);
}

Result<std::int64_t> stamp_in(const FieldReader& reader, std::string_view message) {
  TimeSink sink;
  SOMATO_TRY_VOID(reader.read(message, sink));
  const bool is_time = sink.numbers.size() == 2 && std::abs(sink.numbers[0]) <= kMostSeconds &&
                       std::abs(sink.numbers[1]) <= kMostSeconds;
  if (!is_time) return fail(ErrorKind::kData, "the stamp is not a time, or is missing");
  return static_cast<std::int64_t>(sink.numbers[0]) * kNanosecondsASecond +
         static_cast<std::int64_t>(sink.numbers[1]);
}

}  // namespace somato
