#include "recordings/bags/bag_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/text/text.h"
#include "recordings/bags/bag_files.h"
#include "recordings/bags/bag_source.h"
#include "recordings/bags/span_table.h"
#include "recordings/bags/topic_use.h"
#include "recordings/explorations/checked_explorations.h"
#include "recordings/explorations/element_order.h"
#include "recordings/explorations/nanoseconds.h"
#include "recordings/file/spooled_frames.h"
#include "recordings/tables/name_pattern.h"
#include "somato/core/parameter.h"

namespace somato {
namespace {

using ElementOrders = std::map<std::string, ElementOrder>;

// A channel of the exploration that is open.
struct ImportedChannel {
  ChannelDescription description;
  std::size_t index = 0;     // In the order of channels.
  std::size_t elements = 0;  // 0 until there is a frame.
  std::int64_t latest = std::numeric_limits<std::int64_t>::min();
};

// Whether the value of an event only ends an exploration.
bool is_end(const std::string& value) {
  return value.empty() || value == "0";
}

// Reads one bag.
class BagReading {
 public:
  BagReading(const BagLocation& bag, std::vector<Label> labels, const BagImport& description,
             const std::vector<BagSpan>& spans, ElementOrders& orders, FrameSink& sink)
      : bag_(&bag),
        name_labels_(std::move(labels)),
        description_(&description),
        spans_(&spans),
        orders_(&orders),
        sink_(&sink),
        values_of_labels_(description.labels.size()) {
    for (const BagChannel& channel : description.channels) (void)channel_named(channel.name);
  }

  Result<void> run(BagImportReport& report, const std::function<bool()>& should_continue) {
    SOMATO_TRY(source_, open_bag(*bag_, description_->trials.definitions));
    for (;;) {
      if (!should_continue()) return fail(ErrorKind::kInterrupted, "the import was stopped");
      Result<std::optional<BagMessage>> message = source_->next();
      if (!message) return fail(std::move(message.error()));
      if (!*message) break;
      Result<void> taken = take(**message);
      if (!taken) return fail(std::move(taken.error()));
    }
    SOMATO_TRY_VOID(end());
    SOMATO_TRY_VOID(check_topics());
    add_left_out(report);
    add_remarks(report);
    return {};
  }

 private:
  Result<void> take(BagMessage message) {
    if (!zero_) zero_ = message.time;
    SOMATO_TRY_VOID(compile_uses());
    const TopicUse& use = uses_[message.topic];
    const bool is_read = !use.channels.empty() || !use.labels.empty() || use.event;
    if (use.messages.type && is_read) {
      SOMATO_TRY(message.data, located(use.messages.in_cdr(message.data, cdr_), message));
    }
    SOMATO_TRY_VOID(use.is_event ? end() : end_by(message.time));
    for (const TopicUse::Label& label : use.labels) {
      SOMATO_TRY(values_of_labels_[label.label],
                 located(words_at(label.reader, message.data), message));
    }
    if (use.is_event) SOMATO_TRY_VOID(take_event(use, message));
    if (!use.channels.empty()) SOMATO_TRY_VOID(take_frames(use, message));
    return {};
  }

  Result<void> compile_uses() {
    for (std::size_t i = uses_.size(); i < source_->topics().size(); ++i) {
      Result<TopicUse> use = use_of_topic(source_->topics()[i], *description_);
      if (!use) {
        use.error().where = fmt::format("{}: {}", bag_->path, use.error().where);
        return fail(std::move(use.error()));
      }
      for (const TopicUse::Channel& channel : use->channels) {
        orders_->try_emplace(channel.description.name, channel.reader.order());
      }
      uses_.push_back(std::move(*use));
    }
    return {};
  }

  Result<void> take_event(const TopicUse& use, const BagMessage& message) {
    std::string value = "1";
    if (use.event) {
      SOMATO_TRY(value, located(words_at(*use.event, message.data), message));
    }
    if (!is_end(value)) begin({});
    return {};
  }

  Result<void> take_frames(const TopicUse& use, const BagMessage& message) {
    begin_by(message.time);
    if (!is_open_) {
      frames_outside_ += use.channels.size();
      return {};
    }
    std::int64_t time = message.time;
    if (use.stamp) {
      SOMATO_TRY(time, located(stamp_in(*use.stamp, message.data), message));
      if (time == 0 && !zero_stamps_.insert(message.topic).second) {
        return bad("the stamp in the header is 0 again, which is no time", message,
                   "use the time at which messages were received: --clock receiver");
      }
    }
    for (const TopicUse::Channel& channel : use.channels) {
      SOMATO_TRY_VOID(take_frame(channel, message, time));
    }
    return {};
  }

  // Before a label changes: a message behind the end of an exploration is not about it.
  Result<void> end_by(std::int64_t time) {
    const double gap = description_->trials.gap;
    const bool is_behind_gap = gap > 0.0 && static_cast<double>(time - latest_frame_) / 1e9 > gap;
    const bool is_behind_span = next_span_ > 0 && time - *zero_ >= (*spans_)[next_span_ - 1].end;
    return is_open_ && (is_behind_gap || is_behind_span) ? end() : Result<void>();
  }

  // Begins the exploration of a frame, unless an event has to.
  void begin_by(std::int64_t time) {
    latest_frame_ = time;
    if (is_open_ || !description_->trials.events.empty()) return;
    if (spans_->empty()) return begin({});
    const std::int64_t since = time - *zero_;
    for (; !is_open_ && next_span_ < spans_->size() && (*spans_)[next_span_].begin <= since;
         ++next_span_) {
      if (since < (*spans_)[next_span_].end) begin((*spans_)[next_span_].labels);
    }
  }

  void begin(const std::vector<Label>& labels) {
    is_open_ = true;
    start_.reset();
    labels_ = name_labels_;
    labels_.insert(labels_.end(), labels.begin(), labels.end());
  }

  Result<void> take_frame(const TopicUse::Channel& source, const BagMessage& message,
                          std::int64_t time) {
    const std::string& name = source.description.name;
    SOMATO_TRY(const bool has_all,
               located(source.reader.read(message.data, orders_->at(name), values_), message));
    if (values_.empty()) {
      ++(has_all ? without_values_ : without_elements_)[{message.topic, name}];
      return {};
    }
    SOMATO_TRY(ImportedChannel * channel, channel_for(source, message));
    if (values_.size() != channel->elements) {
      return bad(fmt::format("the frame of {} has {} elements, the first one {}", shown(name),
                             values_.size(), channel->elements),
                 message,
                 "select elements that every message has, such as sensors[0..3], or a number of "
                 "elements of which some may be missing, such as sensors[*:4]");
    }
    if (is_jump(*channel, time)) return take_jump(source, *channel, message, time);
    channel->latest = time;
    if (!start_) start_ = time;
    return add_frame(*channel, source.description.factor, time);
  }

  bool is_jump(const ImportedChannel& channel, std::int64_t time) const {
    return time < channel.latest || (start_ && is_of_epoch(time) != is_of_epoch(*start_));
  }

  // The exploration ends at a jump of the clock.
  Result<void> take_jump(const TopicUse::Channel& source, const ImportedChannel& channel,
                         const BagMessage& message, std::int64_t time) {
    if (description_->trials.jumps == ClockJumps::kRefuse) {
      const std::string name = shown(source.description.name);
      if (time < channel.latest && is_of_epoch(time) == is_of_epoch(channel.latest)) {
        return bad(fmt::format("the clock of {} is set back by {:.6g} s", name,
                               static_cast<double>(channel.latest - time) / 1e9),
                   message, "cut the explorations there with --jumps cut");
      }
      return bad(fmt::format("a frame of {} has the time {}, and the exploration begins at {}: one "
                             "of the two is no time of the calendar",
                             name, words_of_time(time), words_of_time(*start_)),
                 message,
                 "use the other clock (--clock header or receiver), leave out topics with the "
                 "other kind of times, or cut the explorations there with --jumps cut");
    }
    const std::vector<Label> labels = labels_;
    SOMATO_TRY_VOID(end());
    begin({});
    labels_ = labels;
    return take_frame(source, message, time);
  }

  ImportedChannel& channel_named(const std::string& name) {
    const auto [known, is_new] = channels_.try_emplace(name);
    if (is_new) {
      known->second.description.name = name;
      known->second.index = order_.size();
      order_.push_back(name);
    }
    return known->second;
  }

  Result<ImportedChannel*> channel_for(const TopicUse::Channel& source, const BagMessage& message) {
    const std::string& name = source.description.name;
    ImportedChannel& channel = channel_named(name);
    if (channel.elements != 0) return &channel;
    channel.elements = values_.size();
    channel.description.unit = source.description.unit;
    channel.description.element_names = orders_->at(name).names();
    if (channel.description.element_names.size() != channel.elements) {
      channel.description.element_names.clear();
    }
    SOMATO_TRY(channel.description.shape, located(source.reader.shape(message.data), message));
    if (source.description.shape.empty()) return &channel;
    std::size_t elements = 1;
    for (const std::size_t length : source.description.shape) elements *= length;
    if (elements != channel.elements) {
      return bad(fmt::format("the frame of {} has {} elements, which do not fill its shape",
                             shown(name), channel.elements),
                 message, "correct the shape");
    }
    channel.description.shape = source.description.shape;
    return &channel;
  }

  Result<void> add_frame(ImportedChannel& channel, double factor, std::int64_t time) {
    frame_.clear();
    valid_.clear();
    for (const double value : values_) {
      const bool is_valid = !std::isnan(value);
      if (!is_valid) valid_.resize(values_.size(), 1);
      if (!is_valid) valid_[frame_.size()] = 0;
      frame_.push_back(is_valid ? static_cast<float>(factor * value) : 0.0F);
    }
    return frames_.add(channel.index, frame_, seconds_of(time - *start_), valid_);
  }

  Result<void> end() {
    if (!is_open_) return {};
    is_open_ = false;
    ExplorationStart start{labels_, bag_->path, {}};
    SOMATO_TRY_VOID(add_labels(start.labels));
    SOMATO_TRY_VOID(check_channels());
    for (const std::string& name : order_) {
      ImportedChannel& channel = channels_[name];
      start.channels.push_back(channel.description);
      channel.latest = std::numeric_limits<std::int64_t>::min();
      channel.elements = 0;
    }
    Result<void> handed = frames_.hand_over(std::move(start), *sink_);
    if (!handed && handed.error().kind == ErrorKind::kData) {
      handed.error().where = place_of_exploration();
    }
    return handed;
  }

  Result<void> add_labels(std::vector<Label>& labels) const {
    for (std::size_t i = 0; i < description_->labels.size(); ++i) {
      const BagLabel& label = description_->labels[i];
      if (!label.topic.empty() && !values_of_labels_[i]) {
        return fail(ErrorKind::kData,
                    fmt::format("no message of {} comes before the end of the exploration, so that "
                                "the label {} is not known",
                                label.topic, shown(label.name)),
                    place_of_exploration());
      }
      labels.push_back({label.name, label.topic.empty() ? label.value : *values_of_labels_[i]});
    }
    return {};
  }

  Result<void> check_channels() const {
    for (const BagChannel& channel : description_->channels) {
      if (channels_.at(channel.name).elements != 0) continue;
      SOMATO_TRY_VOID(check_elements_found(channel));
      return fail(
          ErrorKind::kData,
          fmt::format("the channel {} has no frames in the exploration", shown(channel.name)),
          place_of_exploration(), "check its topic, and where explorations are cut");
    }
    if (start_) return {};
    return fail(ErrorKind::kData, "the exploration has no frames", place_of_exploration(),
                "describe its channels with --channels");
  }

  // A name that no message has is rather a mistake than a joint that rests.
  Result<void> check_elements_found(const BagChannel& channel) const {
    const auto found = orders_->find(channel.name);
    if (found == orders_->end()) return {};
    const std::vector<std::string> known = found->second.known_names();
    const std::vector<std::string>& selected = found->second.names();
    const auto missing = std::find_if(selected.begin(), selected.end(), [&](const auto& name) {
      return std::find(known.begin(), known.end(), name) == known.end();
    });
    if (known.empty() || missing == selected.end()) return {};
    Error error = unknown_name("element", *missing, place_of_exploration(), known);
    error.what = fmt::format("no message has all elements of channel {}: {}", shown(channel.name),
                             error.what);
    error.kind = ErrorKind::kData;
    return fail(std::move(error));
  }

  Result<void> check_topics() const {
    std::vector<std::string> names;
    for (const BagTopic& topic : source_->topics()) names.push_back(topic.name);
    const std::string& events = description_->trials.events;
    SOMATO_TRY_VOID(check_topic(events.substr(0, events.find(':')), names));
    for (const BagLabel& label : description_->labels) {
      SOMATO_TRY_VOID(check_topic(label.topic, names));
    }
    for (const BagChannel& channel : description_->channels) {
      SOMATO_TRY_VOID(check_topic(channel.topic, names));
    }
    return {};
  }

  Result<void> check_topic(const std::string& topic, const std::vector<std::string>& names) const {
    if (topic.empty() || std::find(names.begin(), names.end(), topic) != names.end()) return {};
    return fail(unknown_name("topic", topic, bag_->path, names));
  }

  void add_remarks(BagImportReport& report) const {
    for (const std::string& remark : remarks_on(*bag_, *source_)) {
      report.remarks.push_back(fmt::format("{}: {}", bag_->path, remark));
    }
  }

  void add_left_out(BagImportReport& report) const {
    report.frames_outside += frames_outside_;
    for (std::size_t i = 0; i < uses_.size(); ++i) {
      if (!uses_[i].reason.empty())
        add_left_out(report, i, source_->messages_of_topic(i), uses_[i].reason);
    }
    for (const auto& [of, messages] : without_elements_) {
      add_left_out(report, of.first, messages,
                   fmt::format("without all elements of channel {}", shown(of.second)));
    }
    // Fields that no message of the topic uses, such as efforts, are no channel.
    for (const auto& [of, messages] : without_values_) {
      if (!channels_.contains(of.second)) continue;
      add_left_out(report, of.first, messages,
                   fmt::format("without values of channel {}", shown(of.second)));
    }
  }

  void add_left_out(BagImportReport& report, std::size_t topic, std::uint64_t messages,
                    const std::string& reason) const {
    const BagTopic& of = source_->topics()[topic];
    const auto same = std::find_if(report.left_out.begin(), report.left_out.end(),
                                   [&](const LeftOutTopic& other) {
                                     return other.topic == of.name && other.reason == reason;
                                   });
    if (same != report.left_out.end()) {
      same->messages += messages;
    } else {
      report.left_out.push_back({of.name, of.encoding.type, messages, reason});
    }
  }

  std::string place_of_exploration() const {
    const double start = start_ && zero_ ? static_cast<double>(*start_ - *zero_) / 1e9 : 0.0;
    return fmt::format("{}, exploration from {:.6g} s", bag_->path, start);
  }

  tl::unexpected<Error> bad(std::string what, const BagMessage& message,
                            std::string advice = {}) const {
    return fail(ErrorKind::kData, std::move(what), place_of(message), std::move(advice));
  }

  std::string place_of(const BagMessage& message) const {
    return fmt::format("{}, topic {} at {:.6f} s", bag_->path,
                       source_->topics()[message.topic].name,
                       static_cast<double>(message.time - *zero_) / 1e9);
  }

  template <typename T>
  Result<T> located(Result<T> result, const BagMessage& message) const {
    if (!result) result.error().where = place_of(message);
    return result;
  }

  const BagLocation* bag_;
  std::vector<Label> name_labels_;
  const BagImport* description_;
  const std::vector<BagSpan>* spans_;
  ElementOrders* orders_;  // By the names of channels, for all bags.
  FrameSink* sink_;
  std::vector<std::optional<std::string>> values_of_labels_;
  std::unique_ptr<SortedBag> source_;
  std::vector<TopicUse> uses_;
  using MessagesOfChannel = std::map<std::pair<std::size_t, std::string>, std::uint64_t>;
  MessagesOfChannel without_elements_;  // By topic and name of the channel.
  MessagesOfChannel without_values_;
  std::set<std::size_t> zero_stamps_;  // Topics with such a stamp; a simulation may begin at 0.
  std::map<std::string, ImportedChannel> channels_;
  std::vector<std::string> order_;
  SpooledFrames frames_;
  std::vector<Label> labels_;
  bool is_open_ = false;
  std::optional<std::int64_t> zero_;   // The time of the first message of the bag.
  std::optional<std::int64_t> start_;  // The time of the first frame of the exploration.
  std::int64_t latest_frame_ = 0;
  std::size_t next_span_ = 0;
  std::uint64_t frames_outside_ = 0;
  std::string cdr_;  // The latest message, if it is in JSON.
  std::vector<double> values_;
  std::vector<float> frame_;
  std::vector<std::uint8_t> valid_;
};

// The labels in the name of a bag, or nothing if the bag is to be passed over.
Result<std::optional<std::vector<Label>>> labels_of_name(const BagLocation& bag,
                                                         const BagTrials& trials) {
  if (trials.files.empty()) return std::vector<Label>();
  SOMATO_TRY(const NamePattern pattern, NamePattern::parse(trials.files));
  SOMATO_TRY(auto labels, pattern.match(bag.name));
  if (labels || trials.other_files == Unmentioned::kIgnore) return labels;
  return fail(
      ErrorKind::kData,
      fmt::format("the name {} does not match the pattern \"{}\"", shown(bag.name), trials.files),
      bag.path, "rename it, or use --other-files ignore");
}

}  // namespace

Result<BagImportReport> import_bags(const std::filesystem::path& path, const BagImport& description,
                                    FrameSink& to, const std::function<bool()>& should_continue) {
  SOMATO_TRY_VOID(check_bag_import(description));
  SOMATO_TRY(const std::vector<BagLocation> bags, find_bags(path));
  std::vector<BagSpan> spans;
  if (!description.trials.spans.empty()) {
    SOMATO_TRY(spans, read_span_table(description.trials.spans));
  }
  BagImportReport report;
  ElementOrders orders;
  CheckedExplorations checked(to);
  for (const BagLocation& bag : bags) {
    SOMATO_TRY(auto labels, labels_of_name(bag, description.trials));
    if (!labels) continue;
    BagReading reading(bag, std::move(*labels), description, spans, orders, checked);
    SOMATO_TRY_VOID(reading.run(report, should_continue));
  }
  report.explorations = checked.count();
  if (report.explorations > 0) {
    report.first = checked.first();
    return report;
  }
  return fail(
      ErrorKind::kData, "there are no explorations", path.string(),
      "check the topics, and where explorations are cut; `somato inspect` lists the topics");
}

}  // namespace somato
