#include "recordings/file/frame_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "base/text/text.h"
#include "recordings/explorations/nanoseconds.h"
#include "recordings/file/recording_layout.h"
#include "recordings/mcap/exploration_notes.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr std::size_t kMostAnnounced = std::size_t{1} << 20;

tl::unexpected<Error> bad(std::string what, const std::string& path, std::string advice = {}) {
  return fail(ErrorKind::kData, std::move(what), path, std::move(advice));
}

Result<void> check_text(std::string_view text, const char* what, const std::string& path) {
  if (is_utf8(text)) return {};
  return bad(fmt::format("{} {} is not UTF-8", what, shown(text)), path, "convert it");
}

Result<void> check_channels(const std::vector<ChannelDescription>& channels,
                            const std::string& path) {
  std::set<std::string> names;
  Result<void> checked;
  for (const ChannelDescription& channel : channels) {
    if (channel.name.empty()) return bad("a channel has no name", path);
    if (!names.insert(channel.name).second) {
      return bad(fmt::format("there are two channels {}", shown(channel.name)), path,
                 "rename one of them");
    }
    checked = check_text(channel.name, "the channel", path).and_then([&] {
      return check_text(channel.unit, "the unit", path);
    });
    for (const std::string& name : channel.element_names) {
      if (checked) checked = check_text(name, "the element", path);
    }
    if (!checked) return checked;
  }
  return {};
}

Result<void> check_texts(const ExplorationStart& start, const std::string& path) {
  Result<void> checked = check_text(start.source, "the source", path);
  for (const Label& label : start.labels) {
    if (checked) checked = check_text(label.name, "the label", path);
    if (checked) checked = check_text(label.value, "the label's value", path);
  }
  return checked.and_then([&] { return check_channels(start.channels, path); });
}

// Texts that readers would not believe are not written.
Result<void> check_lengths(const ExplorationStart& start, const ExplorationMessage& message,
                           const std::string& path) {
  std::size_t announced = 0;
  std::size_t longest = exploration_json(message).size();
  for (const ChannelDescription& channel : start.channels) {
    const McapChannel record = channel_for(channel);
    for (const auto& [name, text] : record.metadata) longest = std::max(longest, text.size());
    announced += mcap_record(record).size();
  }
  if (longest <= kLongestExplorationText && announced <= kMostAnnounced) return {};
  return bad("the labels, or the names of channels and elements, are too long", path,
             fmt::format("keep each below {} KiB and all below {} KiB",
                         kLongestExplorationText >> 10, kMostAnnounced >> 10));
}

std::size_t expected_elements(const ChannelDescription& description) {
  if (description.shape.empty()) return description.element_names.size();
  std::size_t elements = 1;
  for (const std::size_t length : description.shape) elements *= length;
  return elements;
}

}  // namespace

Result<void> FrameWriter::begin_file() {
  return file_.begin({std::string(kRecordingProfile), "somato"});
}

// The position of an exploration's 0 s on the file's clock, so that times are ascending in the
// file. Times that are already ascending, such as those of a calendar, are unchanged.
std::int64_t FrameWriter::zero_for(std::int64_t start) const {
  return std::max<std::int64_t>(0, static_cast<std::int64_t>(file_.latest_time()) - start);
}

Result<void> FrameWriter::begin_exploration(const ExplorationStart& start) {
  const std::optional<std::int64_t> time = nanoseconds_of(start.time);
  if (!time) return bad(fmt::format("an exploration begins at {} s", start.time), path_);
  ExplorationMessage message{ExplorationMessage::Event::kBegin,
                             explorations_,
                             start.labels,
                             start.source,
                             {},
                             zero_for(*time)};
  message.channels.reserve(start.channels.size());
  for (const ChannelDescription& channel : start.channels) message.channels.push_back(channel.name);
  return check_texts(start, path_)
      .and_then([&] { return check_lengths(start, message, path_); })
      .and_then([&] { return open_channels(start.channels); })
      .and_then([&](const std::vector<std::uint16_t>& ids) {
        ++explorations_;
        zero_ = message.zero;
        return log_.begin(message, ids, static_cast<std::uint64_t>(zero_ + *time));
      });
}

Result<std::vector<std::uint16_t>> FrameWriter::open_channels(
    const std::vector<ChannelDescription>& descriptions) {
  std::vector<std::uint16_t> ids;
  ids.reserve(descriptions.size());
  channels_.clear();
  channels_.reserve(descriptions.size());
  for (const ChannelDescription& description : descriptions) {
    const McapSchema schema = schema_for(description);
    SOMATO_TRY(const std::uint16_t id, file_.channel(&schema, channel_for(description)));
    ids.push_back(id);
    channels_.push_back({description, id, expected_elements(description)});
  }
  return ids;
}

Result<void> FrameWriter::frame(std::size_t index, std::span<const float> values, double time,
                                std::span<const std::uint8_t> valid) {
  require(index < channels_.size(), "the exploration has no such channel");
  OpenChannel& channel = channels_[index];
  require(!values.empty() && (channel.elements == 0 || channel.elements == values.size()),
          "a channel's frames have as many values as it has elements");
  require(valid.empty() || valid.size() == values.size(),
          "there must be one validity mark per value");
  channel.elements = values.size();
  SOMATO_TRY(const std::uint64_t log_time, this->log_time(channel, time));
  const std::string message =
      frame_message(channel.description, log_time, with_gaps(values, valid));
  return log_.add({channel.id, channel.frames++, log_time, log_time, message});
}

Result<std::uint64_t> FrameWriter::log_time(OpenChannel& channel, double time) const {
  const std::optional<std::int64_t> nanoseconds = nanoseconds_of(time);
  if (!nanoseconds || *nanoseconds < -zero_ ||
      *nanoseconds > std::numeric_limits<std::int64_t>::max() - zero_) {
    return bad(fmt::format("channel {}: the time {} s is out of range",
                           shown(channel.description.name), time),
               path_, "use times relative to the beginning of the exploration");
  }
  if (*nanoseconds < channel.latest) {
    return bad(fmt::format("channel {}: the time {} s precedes that of the preceding frame",
                           shown(channel.description.name), time),
               path_);
  }
  channel.latest = *nanoseconds;
  return static_cast<std::uint64_t>(*nanoseconds + zero_);
}

Result<void> FrameWriter::label(std::uint64_t exploration, const Label& label) {
  require(exploration < explorations_, "the file has no such exploration");
  SOMATO_TRY_VOID(check_text(label.name, "the label", path_));
  SOMATO_TRY_VOID(check_text(label.value, "the label's value", path_));
  const McapMetadata note = ExplorationNotes::label(exploration, label);
  if (mcap_record(note).size() <= kLongestExplorationText) return file_.add(note);
  return bad("the label is too long", path_,
             fmt::format("keep it below {} KiB", kLongestExplorationText >> 10));
}

Result<void> FrameWriter::leave_out(std::uint64_t exploration) {
  require(exploration < explorations_, "the file has no such exploration");
  return file_.add(ExplorationNotes::left_out(exploration));
}

std::span<const float> FrameWriter::with_gaps(std::span<const float> values,
                                              std::span<const std::uint8_t> valid) {
  if (valid.empty()) return values;
  gaps_.assign(values.begin(), values.end());
  for (std::size_t i = 0; i < valid.size(); ++i) {
    if (valid[i] == 0) gaps_[i] = std::numeric_limits<float>::quiet_NaN();
  }
  return gaps_;
}

}  // namespace somato
