#include "bodies/body/frame_log.h"

#include <fmt/format.h>

#include <utility>

#include "bodies/body/driving.h"
#include "recordings/explorations/growing_channel.h"
#include "somato/core/check.h"

namespace somato {

FrameTimes::FrameTimes(const BodyState& state, std::size_t sensor, double rate)
    : frames_(state.readings[sensor].rows()), rate_(rate), end_(state.time) {
  if (sensor < state.times.size()) own_ = state.times[sensor];
}

bool FrameTimes::are_complete() const {
  return own_.empty() ? frames_ <= 1 || rate_ > 0.0 : own_.size() == frames_;
}

double FrameTimes::operator[](std::size_t frame) const {
  if (!own_.empty()) return own_[frame];
  const auto later = static_cast<double>(frames_ - 1 - frame);
  return later == 0.0 ? end_ : end_ - later / rate_;
}

FrameLog::FrameLog(const BodyDescription& description, std::size_t most) : most_(most) {
  sensors_.reserve(description.sensors.size());
  for (const ChannelDescription& sensor : description.sensors) {
    Channel channel = detail::empty_channel(sensor);
    channel.rate = 0.0;
    sensors_.push_back({std::move(channel), sensor.rate, sensor.times_known || sensor.rate > 0.0});
  }
}

Result<void> FrameLog::append(const BodyState& state) {
  require(state.readings.size() == sensors_.size(),
          "FrameLog::append: the readings belong to another body");
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    SOMATO_TRY_VOID(append(sensors_[i], state.readings[i], {state, i, sensors_[i].rate}));
  }
  if (bytes_ > most_) drop_all();
  return {};
}

Result<void> FrameLog::append(Sensor& sensor, const Matrix<float>& frames,
                              const FrameTimes& times) {
  if (frames.rows() == 0) return {};
  Channel& channel = sensor.channel;
  if (channel.frames.columns() == 0) channel.frames = Matrix<float>(0, frames.columns());
  if (frames.columns() != channel.frames.columns() || frames.columns() == 0) {
    return fail(ErrorKind::kData,
                fmt::format("the sensor '{}' gave {} elements, not {}", channel.name,
                            frames.columns(), channel.frames.columns()),
                channel.name, "check the body's description");
  }
  if (!times.are_complete()) {
    return fail(ErrorKind::kData,
                fmt::format("the sensor '{}' gave {} frames in one step, with neither a rate nor a "
                            "time for each",
                            channel.name, frames.rows()),
                channel.name, "check the body's description");
  }
  bytes_ += frames.values().size_bytes() + frames.rows() * sizeof(double);
  if (bytes_ > most_) return {};
  append_readings(channel, frames);
  for (std::size_t i = 0; sensor.times_known && i < frames.rows(); ++i) {
    channel.times.push_back(times[i]);
  }
  return {};
}

// The number of elements of each channel remains.
void FrameLog::drop_all() {
  for (Sensor& sensor : sensors_) {
    sensor.channel.frames = Matrix<float>(0, sensor.channel.frames.columns());
    sensor.channel.times = {};
    sensor.channel.valid = {};
  }
}

std::vector<Channel> FrameLog::channels() && {
  std::vector<Channel> channels;
  channels.reserve(sensors_.size());
  for (Sensor& sensor : sensors_) channels.push_back(std::move(sensor.channel));
  return channels;
}

}  // namespace somato
