#include "recordings/explorations/recording_outline.h"

#include <algorithm>
#include <utility>

namespace somato {
namespace {

constexpr std::size_t kMostSteps = std::size_t{1} << 16;  // Half a megabyte.

}  // namespace

std::vector<ExplorationOutline> outlines_of(const Recording& recording) {
  std::vector<ExplorationOutline> outlines;
  outlines.reserve(recording.explorations.size());
  for (const Exploration& exploration : recording.explorations) {
    ExplorationOutline& outline = outlines.emplace_back();
    outline.labels = exploration.labels;
    for (const Channel& channel : exploration.channels) {
      outline.channels.push_back({channel.frames.rows(), channel.frame_rate()});
    }
  }
  return outlines;
}

Result<void> RecordingOutline::begin_exploration(const ExplorationStart& start) {
  ExplorationOutline& outline = explorations_.emplace_back();
  outline.labels = start.labels;
  times_.assign(start.channels.size(), {});
  for (std::size_t i = 0; i < start.channels.size(); ++i) {
    const double rate = start.channels[i].rate;
    outline.channels.push_back({0, rate});
    times_[i].are_known = rate == 0.0 && start.channels[i].times_known;
  }
  return {};
}

Result<void> RecordingOutline::frame(std::size_t channel, std::span<const float> /*values*/,
                                     double time, std::span<const std::uint8_t> /*valid*/) {
  ChannelTimes& times = times_[channel];
  const bool has_step = explorations_.back().channels[channel].frames++ > 0;
  if (has_step && times.are_known && times.steps.size() < kMostSteps) {
    times.steps.push_back(time - times.latest);
  }
  times.latest = time;
  return {};
}

Result<void> RecordingOutline::end_exploration() {
  for (std::size_t i = 0; i < times_.size(); ++i) {
    if (!times_[i].are_known) continue;
    explorations_.back().channels[i].rate = detail::rate_of_steps(std::move(times_[i].steps));
  }
  return {};
}

namespace detail {

double rate_of_steps(std::vector<double> steps) {
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle > 0.0 ? 1.0 / *middle : 0.0;
}

}  // namespace detail

}  // namespace somato
