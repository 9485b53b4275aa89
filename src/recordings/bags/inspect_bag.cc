#include "recordings/bags/inspect_bag.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "recordings/explorations/nanoseconds.h"
#include "recordings/ros/topic_type.h"

namespace somato {
namespace {

// The channels that have values in the first message with values.
void describe_topic(TopicSummary& summary, const BagTopic& topic, const TopicType& type,
                    std::string_view message) {
  summary.reason = type.reason;
  const std::string base = topic.name.substr(topic.name.starts_with('/') ? 1 : 0);
  std::vector<double> values;
  std::string cdr;
  Result<std::string_view> decoded = message;
  if (type.messages.type) decoded = type.messages.in_cdr(message, cdr);
  for (const TopicChannel& channel : type.channels) {
    const Result<void> read = decoded.and_then(
        [&](std::string_view plain) { return channel.reader.read(plain, values); });
    if (!read) {
      summary.reason = read.error().what;
    } else if (!values.empty()) {
      summary.channels.push_back({base + channel.suffix, channel.unit, values.size()});
    }
  }
  if (!summary.channels.empty()) summary.reason.clear();
  if (summary.channels.empty() && summary.reason.empty()) {
    summary.reason = "its messages hold no values";
  }
}

void add_time(TopicSummary& summary, std::int64_t time) {
  if (summary.messages > 0 && time < summary.last) ++summary.set_back;
  if (summary.messages > 0) {
    summary.longest_gap = std::max(summary.longest_gap, time - summary.last);
    summary.passed += std::max(time - summary.last, std::int64_t{0});
  }
  if (!is_of_epoch(time)) ++summary.not_of_calendar;
  summary.last = time;
  ++summary.messages;
}

}  // namespace

double TopicSummary::rate() const {
  if (passed == 0) return 0.0;
  return static_cast<double>(messages - 1 - set_back) / (static_cast<double>(passed) / 1e9);
}

Result<BagSummary> inspect_bag(const BagLocation& bag, const std::string& definitions) {
  SOMATO_TRY(const std::unique_ptr<SortedBag> source, open_bag(bag, definitions));
  BagSummary summary{bag.name, bag.files.size(), {}, 0, bag.remarks, std::nullopt};
  std::vector<TopicType> types;
  for (;;) {
    Result<std::optional<BagMessage>> message = source->next();
    if (!message) summary.damage = std::move(message.error());
    if (!message || !*message) break;
    for (std::size_t i = summary.topics.size(); i < source->topics().size(); ++i) {
      const BagTopic& topic = source->topics()[i];
      summary.topics.push_back({topic.name, topic.encoding.type, {}, "it has no messages"});
      types.push_back(topic_type(topic.encoding));
    }
    const std::size_t index = (*message)->topic;
    TopicSummary& topic = summary.topics[index];
    const bool may_have_values = !types[index].channels.empty() && topic.channels.empty();
    if (topic.messages == 0 || may_have_values) {
      describe_topic(topic, source->topics()[index], types[index], (*message)->data);
    }
    add_time(topic, (*message)->time);
  }
  summary.displaced = source->displaced();
  if (!summary.damage) summary.remarks = remarks_on(bag, *source);
  return summary;
}

}  // namespace somato
