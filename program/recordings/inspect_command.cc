#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "flags/commands.h"
#include "flags/left_out.h"
#include "flags/result_output.h"
#include "recordings/bags/bag_files.h"
#include "recordings/bags/inspect_bag.h"
#include "somato/core/value.h"
#include "somato/recording/inspect_recording.h"
#include "somato/recording/recording_file.h"
#include "terminal/still_elements.h"
#include "terminal/wording.h"
#include "version.h"

namespace somato::program {
namespace {

constexpr std::size_t kMostValues = 20;  // Maximum number of printed values of a label.

std::string quoted(const std::string& text) {
  return to_toml(Value(text));
}

std::string text_of(const LabelSummary& label) {
  std::string text = fmt::format("label {}: ", quoted(label.name));
  const std::size_t shown = std::min(label.values.size(), kMostValues);
  for (std::size_t i = 0; i < shown; ++i) {
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", quoted(label.values[i].value),
                        label.values[i].explorations);
  }
  std::uint64_t others = label.others;
  for (std::size_t i = shown; i < label.values.size(); ++i) others += label.values[i].explorations;
  return text + (others > 0 ? fmt::format(", and {} others\n", others) : "\n");
}

Table table_of(const LabelSummary& label) {
  const auto of_value = [](const LabelSummary::Count& count) {
    return Table{{}, {entry("value", count.value), entry("explorations", count.explorations)}};
  };
  return {{},
          {entry("label", label.name), entry("values", label.values, of_value),
           entry("others", label.others)}};
}

std::string times_of(const ChannelSummary& channel) {
  if (channel.least_rate < channel.most_rate) {
    return fmt::format("{:.6g} to {:.6g} Hz", channel.least_rate, channel.most_rate);
  }
  if (channel.most_rate > 0.0) return fmt::format("{:.6g} Hz", channel.most_rate);
  return channel.description.times_known ? "with times" : "without times";
}

std::string range_of(std::uint64_t least, std::uint64_t most) {
  return least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
}

std::string text_of(const ChannelSummary& channel, std::uint64_t explorations) {
  const ChannelDescription& description = channel.description;
  const std::string shape = description.shape.empty()
                                ? fmt::format("{}", channel.elements)
                                : fmt::format("{}", fmt::join(description.shape, " x "));
  return fmt::format("channel {}: {}{}, {}, {} an exploration{}\n", quoted(description.name), shape,
                     description.unit.empty() ? "" : " " + quoted(description.unit),
                     times_of(channel),
                     range_of(channel.least_frames, channel.most_frames) +
                         (channel.most_frames == 1 ? " frame" : " frames"),
                     channel.explorations == explorations
                         ? ""
                         : ", in " + counted(channel.explorations, "exploration")) +
         text_of(still_elements(channel.ranges), description.element_names, "  ");
}

Table table_of(const ChannelSummary& channel) {
  const ChannelDescription& description = channel.description;
  Table table{
      {},
      {entry("channel", description.name), entry("unit", description.unit),
       entry("elements", channel.elements), entry("shape", description.shape),
       entry("element_names", description.element_names),
       entry("times_known", description.times_known), entry("explorations", channel.explorations),
       entry("least_frames", channel.least_frames), entry("most_frames", channel.most_frames)}};
  if (description.rate > 0.0) table.entries.push_back(entry("rate", description.rate));
  if (channel.least_rate < channel.most_rate) {
    table.entries.push_back(entry("least_rate", channel.least_rate));
    table.entries.push_back(entry("most_rate", channel.most_rate));
  }
  const StillElements still = still_elements(channel.ranges);
  table.entries.push_back(
      entry("always_zero", element_names_of(still.zero, description.element_names)));
  table.entries.push_back(
      entry("unchanged", element_names_of(still.unchanged, description.element_names)));
  table.entries.push_back(entry("missing_values", still.missing_values));
  return table;
}

// Frames without times and without a rate have no duration.
bool is_duration_known(const RecordingSummary& summary) {
  return std::any_of(summary.channels.begin(), summary.channels.end(),
                     [](const ChannelSummary& channel) {
                       return channel.description.times_known || channel.description.rate > 0.0;
                     });
}

std::string text_of(const RecordingSummary& summary) {
  std::string text =
      fmt::format("size: {} bytes\ncompression: {}\n", summary.size, summary.compression);
  text +=
      fmt::format("explorations: {}{}\n", summary.explorations,
                  summary.knows_explorations ? "" : " (the file does not separate explorations)");
  text += is_duration_known(summary) ? fmt::format("duration: {:.6g} s\n", summary.duration)
                                     : "duration: unknown\n";
  for (const LabelSummary& label : summary.labels) text += text_of(label);
  for (const ChannelSummary& channel : summary.channels) {
    text += text_of(channel, summary.explorations);
  }
  if (summary.unfit) {
    text +=
        fmt::format("as a recording: no, because {}; import it, such as with somato import bag\n",
                    summary.unfit->what);
  }
  return text + fmt::format("whole: {}\n", summary.damage ? "no" : "yes");
}

Table table_of(const RecordingSummary& summary) {
  const auto of_label = [](const LabelSummary& label) { return table_of(label); };
  const auto of_channel = [](const ChannelSummary& channel) { return table_of(channel); };
  Table table{{},
              {entry("size", summary.size), entry("compression", summary.compression),
               entry("explorations", summary.explorations),
               entry("knows_explorations", summary.knows_explorations)}};
  if (is_duration_known(summary)) table.entries.push_back(entry("duration", summary.duration));
  table.entries.push_back(entry("labels", summary.labels, of_label));
  table.entries.push_back(entry("channels", summary.channels, of_channel));
  table.entries.push_back(entry("unfit", summary.unfit ? summary.unfit->what : std::string()));
  table.entries.push_back(entry("whole", !summary.damage));
  return table;
}

std::string channels_of(const TopicSummary& topic) {
  std::vector<std::string> channels;
  channels.reserve(topic.channels.size());
  for (const TopicSummary::Channel& channel : topic.channels) {
    channels.push_back(fmt::format("{} ({}{}{})", quoted(channel.name), channel.elements,
                                   channel.unit.empty() ? "" : " x ", channel.unit));
  }
  return fmt::format("{} {}", channels.size() == 1 ? "channel" : "channels",
                     fmt::join(channels, ", "));
}

// Irregular times of a topic, with a comma in front; empty for regular ones.
std::string irregular_times_of(const TopicSummary& topic) {
  constexpr double kPeriods = 10.0;  // A gap of more of them is mentioned.
  std::string text;
  const double gap = static_cast<double>(topic.longest_gap) / 1e9;
  if (gap * topic.rate() > kPeriods) text += fmt::format(", longest gap {:.3g} s", gap);
  if (topic.set_back > 0)
    text += fmt::format(", clock set back {}", counted(topic.set_back, "time"));
  if (topic.not_of_calendar > 0 && topic.not_of_calendar < topic.messages) {
    text += fmt::format(", {} before the year 2000", counted(topic.not_of_calendar, "time"));
  }
  return text;
}

std::string text_of(const TopicSummary& topic) {
  return fmt::format(
      "topic {}: {}, {}, {:.4g} Hz{}: {}\n", quoted(topic.name), topic.type,
      counted(topic.messages, "message"), topic.rate(), irregular_times_of(topic),
      topic.channels.empty() ? "no channel, because " + topic.reason : channels_of(topic));
}

Table table_of(const TopicSummary& topic) {
  const auto of_channel = [](const TopicSummary::Channel& channel) {
    return Table{{},
                 {entry("channel", channel.name), entry("unit", channel.unit),
                  entry("elements", channel.elements)}};
  };
  return {{},
          {entry("topic", topic.name), entry("type", topic.type), entry("messages", topic.messages),
           entry("rate", topic.rate()),
           entry("longest_gap", static_cast<double>(topic.longest_gap) / 1e9),
           entry("set_back", topic.set_back), entry("not_of_calendar", topic.not_of_calendar),
           entry("channels", topic.channels, of_channel), entry("reason", topic.reason)}};
}

// Whether some topics have times of the calendar and others do not.
bool has_two_calendars(const BagSummary& bag) {
  const auto is_of_calendar = [](const TopicSummary& topic) { return topic.not_of_calendar == 0; };
  const auto is_of_none = [](const TopicSummary& topic) {
    return topic.messages > 0 && topic.not_of_calendar == topic.messages;
  };
  return std::any_of(bag.topics.begin(), bag.topics.end(), is_of_calendar) &&
         std::any_of(bag.topics.begin(), bag.topics.end(), is_of_none);
}

// The topics, and what is unusual about the bag.
std::string content_of(const BagSummary& bag) {
  std::string text;
  for (const TopicSummary& topic : bag.topics) text += text_of(topic);
  if (bag.displaced > 0) {
    text +=
        fmt::format("order: {} displaced, and sorted by time\n", counted(bag.displaced, "message"));
  }
  if (has_two_calendars(bag)) {
    text += "times: some topics have times of the calendar, others times before the year 2000\n";
  }
  for (const std::string& remark : bag.remarks) text += fmt::format("note: {}\n", remark);
  return text;
}

std::string text_of(const BagSummary& bag) {
  std::string text = fmt::format("bag {}: {}\n", quoted(bag.name), counted(bag.files, "file"));
  text += content_of(bag);
  return text + fmt::format("whole: {}\n", bag.damage ? "no" : "yes");
}

Table table_of(const BagSummary& bag) {
  const auto of_topic = [](const TopicSummary& topic) { return table_of(topic); };
  return {{},
          {entry("bag", bag.name), entry("files", bag.files), entry("topics", bag.topics, of_topic),
           entry("displaced", bag.displaced), entry("remarks", bag.remarks),
           entry("whole", !bag.damage)}};
}

Result<std::vector<BagSummary>> inspect_bags(const Arguments& arguments) {
  std::vector<BagSummary> bags;
  if constexpr (kHasImporters) {
    SOMATO_TRY(const std::vector<BagLocation> found, find_bags(arguments.text("FILE")));
    bags.reserve(found.size());
    for (const BagLocation& location : found) {
      SOMATO_TRY(BagSummary bag, inspect_bag(location, arguments.text("definitions")));
      bags.push_back(std::move(bag));
    }
    return bags;
  }
  return fail(without_importers(arguments.text("FILE")));
}

Result<void> inspect_only_bags(const Arguments& arguments) {
  SOMATO_TRY(const std::vector<BagSummary> bags, inspect_bags(arguments));
  const auto of_bag = [](const BagSummary& bag) { return table_of(bag); };
  std::string text;
  for (const BagSummary& bag : bags) text += text_of(bag);
  print_result(arguments, text, Table{{}, {entry("bags", bags, of_bag)}});
  for (const BagSummary& bag : bags) {
    if (bag.damage) return fail(*bag.damage);
  }
  return {};
}

// The topics of a recording of another program are listed as well.
Result<void> inspect(const Arguments& arguments) {
  const std::string& path = arguments.text("FILE");
  std::error_code failure;
  const bool is_bag = std::filesystem::is_directory(path, failure) ||
                      (std::filesystem::is_regular_file(path, failure) &&
                       std::filesystem::path(path).extension() == ".db3");
  if (is_bag) return inspect_only_bags(arguments);
  SOMATO_TRY(auto summary, inspect_recording(path));
  std::string text = text_of(summary);
  Table table = table_of(summary);
  if (!summary.knows_explorations || summary.explorations == 0) {
    SOMATO_TRY(const std::vector<BagSummary> bags, inspect_bags(arguments));
    text += content_of(bags.front());
    const auto of_topic = [](const TopicSummary& topic) { return table_of(topic); };
    table.entries.push_back(entry("topics", bags.front().topics, of_topic));
  }
  print_result(arguments, text, table);
  if (summary.damage) return fail(std::move(*summary.damage));
  return {};
}

}  // namespace

Command inspect_command() {
  return {"inspect",
          "Summarize a recording or bags of ROS 2, and check their integrity",
          {{"FILE", "A recording (MCAP), or a bag of ROS 2: a file or a folder", true}},
          {json_flag(),
           input_flag("--definitions",
                      "Folder with .msg files, for bags without definitions (before ROS 2 Iron)")},
          {},
          inspect};
}

}  // namespace somato::program
