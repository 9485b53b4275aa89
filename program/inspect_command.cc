#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "commands.h"
#include "somato/core/value.h"
#include "somato/recording/inspect_recording.h"
#include "wording.h"

namespace somato::program {
namespace {

constexpr std::size_t kMostValues = 20;  // Of a label, that are printed.

std::string quoted(const std::string& text) {
  return to_toml(Value(text));
}

void print_label(const LabelSummary& label) {
  fmt::print("label {}: ", quoted(label.name));
  const std::size_t shown = std::min(label.values.size(), kMostValues);
  for (std::size_t i = 0; i < shown; ++i) {
    fmt::print("{}{} {}", i == 0 ? "" : ", ", quoted(label.values[i].value),
               label.values[i].explorations);
  }
  std::uint64_t others = label.others;
  for (std::size_t i = shown; i < label.values.size(); ++i) others += label.values[i].explorations;
  fmt::print("{}\n", others > 0 ? fmt::format(", and {} others", others) : "");
}

std::string times_of(const ChannelDescription& description) {
  if (description.rate > 0.0) return fmt::format("{:.6g} Hz", description.rate);
  return description.times_known ? "with times" : "times not known";
}

std::string range_of(std::uint64_t least, std::uint64_t most) {
  return least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
}

void print_channel(const ChannelSummary& channel, std::uint64_t explorations) {
  const ChannelDescription& description = channel.description;
  const std::string shape = description.shape.empty()
                                ? fmt::format("{}", channel.elements)
                                : fmt::format("{}", fmt::join(description.shape, " x "));
  fmt::print("channel {}: {}{}, {}, {} an exploration{}\n", quoted(description.name), shape,
             description.unit.empty() ? "" : " " + quoted(description.unit), times_of(description),
             range_of(channel.least_frames, channel.most_frames) +
                 (channel.most_frames == 1 ? " frame" : " frames"),
             channel.explorations == explorations
                 ? ""
                 : ", in " + counted(channel.explorations, "exploration"));
}

Result<void> inspect(const Arguments& arguments) {
  Result<RecordingSummary> summary = inspect_recording(arguments.text("FILE"));
  if (!summary) return fail(std::move(summary.error()));
  fmt::print("size: {} bytes\ncompression: {}\n", summary->size, summary->compression);
  fmt::print("explorations: {}{}\n", summary->explorations,
             summary->knows_explorations ? "" : " (the file does not tell them apart)");
  fmt::print("duration: {:.6g} s\n", summary->duration);
  for (const LabelSummary& label : summary->labels) print_label(label);
  for (const ChannelSummary& channel : summary->channels) {
    print_channel(channel, summary->explorations);
  }
  fmt::print("whole: {}\n", summary->damage ? "no" : "yes");
  if (summary->damage) return fail(std::move(*summary->damage));
  return {};
}

}  // namespace

Command inspect_command() {
  return {"inspect",
          "Tell what is in a recording, and whether it is whole",
          {{"FILE", "A recording (MCAP)", true}},
          {},
          {},
          inspect};
}

}  // namespace somato::program
