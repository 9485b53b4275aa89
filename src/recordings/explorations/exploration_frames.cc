#include "recordings/explorations/exploration_frames.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "somato/recording/recording_file.h"

namespace somato {
namespace {

constexpr double kFramesASecond =
    100.0;  // Used if the rate is unknown: viewers show the frames in order.

double time_of(const Channel& channel, std::size_t frame, double earliest) {
  if (!channel.times.empty()) return channel.times[frame];
  if (channel.rate > 0.0) return static_cast<double>(frame) / channel.rate;
  return earliest + static_cast<double>(frame) / kFramesASecond;
}

// The first known time, or 0 s.
double earliest_time(const Exploration& exploration) {
  std::optional<double> earliest;
  for (const Channel& channel : exploration.channels) {
    if (channel.times.empty() && channel.rate == 0.0) continue;
    const double first = channel.times.empty() ? 0.0 : channel.times.front();
    earliest = std::min(earliest.value_or(first), first);
  }
  return earliest.value_or(0.0);
}

struct PlacedFrame {
  double time = 0.0;
  std::size_t channel = 0;
  std::size_t frame = 0;
};

std::vector<PlacedFrame> frames_in_time(const Exploration& exploration) {
  const double earliest = earliest_time(exploration);
  std::vector<PlacedFrame> frames;
  for (std::size_t channel = 0; channel < exploration.channels.size(); ++channel) {
    const std::size_t count = exploration.channels[channel].frames.rows();
    for (std::size_t frame = 0; frame < count; ++frame) {
      frames.push_back({time_of(exploration.channels[channel], frame, earliest), channel, frame});
    }
  }
  std::sort(frames.begin(), frames.end(), [](const PlacedFrame& a, const PlacedFrame& b) {
    return std::tie(a.time, a.channel, a.frame) < std::tie(b.time, b.channel, b.frame);
  });
  return frames;
}

ExplorationStart start_of(const Exploration& exploration, double time) {
  ExplorationStart start{exploration.labels, exploration.source, {}, time};
  start.channels.reserve(exploration.channels.size());
  for (const Channel& channel : exploration.channels) {
    start.channels.push_back(description_of(channel));
  }
  return start;
}

}  // namespace

Result<void> hand_frames(const Exploration& exploration, FrameSink& to) {
  const std::vector<PlacedFrame> frames = frames_in_time(exploration);
  SOMATO_TRY_VOID(to.begin_exploration(start_of(exploration, frames.front().time)));
  for (const PlacedFrame& placed : frames) {
    const Channel& channel = exploration.channels[placed.channel];
    const auto valid =
        channel.valid.empty() ? std::span<const std::uint8_t>() : channel.valid.row(placed.frame);
    SOMATO_TRY_VOID(to.frame(placed.channel, channel.frames.row(placed.frame), placed.time, valid));
  }
  return to.end_exploration();
}

Result<void> hand_file(FileSystem& files, const std::string& path, FrameSink& to) {
  SOMATO_TRY(RecordingReader reader, RecordingReader::open(files, path));
  for (bool more = true; more;) {
    SOMATO_TRY(more, reader.next(to));
  }
  return {};
}

}  // namespace somato
