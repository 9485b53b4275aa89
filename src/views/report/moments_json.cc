#include "views/report/moments_json.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "recordings/explorations/growing_channel.h"
#include "recordings/explorations/recording_json.h"
#include "studies/results/short_number.h"
#include "views/report/packed_json.h"
#include "views/report/samples_json.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostNumbers = 300000;  // of the samples of one system
constexpr std::size_t kFewestFrames = 40;     // with which an exploration can be followed
constexpr std::size_t kMostFrames = 200;
constexpr std::size_t kMostElements = 64;

double time_of(const Channel& channel, std::size_t frame) {
  if (!channel.times.empty()) return channel.times[frame];
  const double rate = channel.frame_rate();
  return static_cast<double>(frame) / (rate > 0.0 ? rate : 1.0);
}

bool has_times(const Channel& channel) {
  return !channel.times.empty() || channel.rate > 0.0;
}

std::size_t frame_of_most(const Channel& channel) {
  std::size_t most = 0;
  double greatest = -INFINITY;
  for (std::size_t frame = 0; frame < channel.frames.rows(); ++frame) {
    double sum = 0.0;
    for (const float value : channel.frames.row(frame)) sum += double{value};
    if (sum <= greatest) continue;
    greatest = sum;
    most = frame;
  }
  return most;
}

std::size_t nearest_frame(const Channel& channel, double time) {
  std::size_t nearest = 0;
  for (std::size_t frame = 1; frame < channel.frames.rows(); ++frame) {
    const double here = std::abs(time_of(channel, frame) - time);
    if (here < std::abs(time_of(channel, nearest) - time)) nearest = frame;
  }
  return nearest;
}

// The frame of a channel at the moment of most touch.
std::size_t frame_of(const Channel& channel, const Channel* touch) {
  const std::size_t last = channel.frames.rows() - 1;
  if (!touch) return last;
  const std::size_t most = frame_of_most(*touch);
  if (touch->frames.rows() == channel.frames.rows()) return most;
  if (!has_times(*touch) || !has_times(channel)) return last;
  return nearest_frame(channel, time_of(*touch, most));
}

// From the first to the last, the moment among them.
std::vector<std::size_t> evenly_chosen(std::size_t frames, std::size_t moment, std::size_t most) {
  const std::size_t count = std::min(frames, most);
  std::vector<std::size_t> chosen(count);
  for (std::size_t i = 0; i < count; ++i) {
    chosen[i] = count == 1 ? 0 : i * (frames - 1) / (count - 1);
  }
  if (count < 3 || moment == 0 || moment + 1 == frames) return chosen;
  const auto after = std::lower_bound(chosen.begin(), chosen.end(), moment);
  *std::min(after, chosen.end() - 2) = moment;
  return chosen;
}

Json moment_channel(const Channel& channel, const Channel* touch, std::size_t most) {
  const std::size_t moment = frame_of(channel, touch);
  const std::size_t columns = channel.frames.columns();
  std::vector<double> times;
  std::vector<double> series;
  for (const std::size_t frame : evenly_chosen(channel.frames.rows(), moment, most)) {
    times.push_back(time_of(channel, frame));
    if (columns > kMostElements) continue;
    const Matrix<float> values = readings_of(channel, frame, 1);
    series.insert(series.end(), values.values().begin(), values.values().end());
  }
  return {{"channel", channel_json(channel)},
          {"rate", short_number(channel.frame_rate())},
          {"frame", moment},
          {"time", short_number(time_of(channel, moment))},
          {"values", short_numbers(readings_of(channel, moment, 1).row(0))},
          {"times", packed_numbers(times, PackedBits::k16)},
          {"series", packed_rows(series, columns, PackedBits::k8)}};
}

const Channel* touch_of(const Exploration& exploration) {
  const auto found = find_channel(exploration, "touch");
  return found ? *found : nullptr;
}

Json moment_json(const Exploration& exploration, std::size_t frames) {
  const Channel* touch = touch_of(exploration);
  Json channels = Json::array();
  for (const Channel& channel : exploration.channels) {
    channels.push_back(moment_channel(channel, touch, frames));
  }
  return {{"labels", labels_json(exploration.labels)}, {"channels", std::move(channels)}};
}

// The frames of each exploration with which all of them have at most kMostNumbers numbers.
std::size_t frames_for_all(const Evidence& evidence) {
  std::size_t elements = 0;
  for (const std::size_t i : evidence.explorations) {
    for (const Channel& channel : evidence.recording->explorations[i].channels) {
      const std::size_t columns = channel.frames.columns();
      if (columns <= kMostElements) elements += columns;
    }
  }
  return std::min(kMostFrames, kMostNumbers / std::max<std::size_t>(elements, 1));
}

const std::string& hash_of(const Evidence& evidence) {
  return evidence.part->recordings[evidence.recording_number].hash;
}

}  // namespace

Json Moments::numbers(const Evidence& evidence, bool adds) {
  Json json = Json::array();
  if (!evidence.recording) return json;
  if (adds) add(evidence);
  for (const std::size_t i : evidence.explorations) {
    const auto found = numbers_.find({hash_of(evidence), i});
    json.push_back(found == numbers_.end() ? Json(nullptr) : Json(found->second));
  }
  return json;
}

void Moments::add(const Evidence& evidence) {
  const std::size_t frames = frames_for_all(evidence);
  if (frames < kFewestFrames) {
    for (const std::size_t i : first_of_each(evidence)) add(evidence, i, kMostFrames);
    return;
  }
  for (const std::size_t i : evidence.explorations) add(evidence, i, frames);
}

void Moments::add(const Evidence& evidence, std::size_t exploration, std::size_t frames) {
  const auto [place, is_new] = numbers_.emplace(Key{hash_of(evidence), exploration}, list_.size());
  if (is_new) list_.push_back(moment_json(evidence.recording->explorations[exploration], frames));
}

}  // namespace somato::detail
