#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "commands.h"
#include "result_output.h"
#include "somato/core/value.h"
#include "somato/recording/inspect_recording.h"
#include "wording.h"

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

std::string times_of(const ChannelDescription& description) {
  if (description.rate > 0.0) return fmt::format("{:.6g} Hz", description.rate);
  return description.times_known ? "with times" : "without times";
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
                     times_of(description),
                     range_of(channel.least_frames, channel.most_frames) +
                         (channel.most_frames == 1 ? " frame" : " frames"),
                     channel.explorations == explorations
                         ? ""
                         : ", in " + counted(channel.explorations, "exploration"));
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
  table.entries.push_back(entry("whole", !summary.damage));
  return table;
}

Result<void> inspect(const Arguments& arguments) {
  SOMATO_TRY(auto summary, inspect_recording(arguments.text("FILE")));
  print_result(arguments, text_of(summary), table_of(summary));
  if (summary.damage) return fail(std::move(*summary.damage));
  return {};
}

}  // namespace

Command inspect_command() {
  return {"inspect",
          "Summarize a recording and check its integrity",
          {{"FILE", "A recording (MCAP)", true}},
          {json_flag()},
          {},
          inspect};
}

}  // namespace somato::program
