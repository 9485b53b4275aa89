#include "views/replay/growing_exploration.h"

#include <utility>

#include "bodies/body/driving.h"
#include "bodies/body/frame_log.h"
#include "recordings/explorations/growing_channel.h"

namespace somato::live {
namespace {

std::vector<double> rates_of(const BodyDescription& body) {
  std::vector<double> rates;
  rates.reserve(body.sensors.size());
  for (const ChannelDescription& sensor : body.sensors) rates.push_back(sensor.rate);
  return rates;
}

// The frames of a sensor that gives them without times are those of the end of the step.
void append_times(Channel& channel, const FrameTimes& times, double end) {
  const std::size_t before = channel.times.size();
  channel.times.resize(channel.frames.rows(), end);
  if (!times.are_complete()) return;
  for (std::size_t i = before; i < channel.times.size(); ++i) channel.times[i] = times[i - before];
}

}  // namespace

GrowingExploration::GrowingExploration(std::size_t index, const BodyDescription& body,
                                       std::shared_ptr<const Scene> scene)
    : index_(index),
      timeline_(std::make_shared<Timeline>(rates_of(body))),
      scene_(std::make_shared<KeptScene>(std::move(scene))),
      frames_(body.sensors.size(), 0) {
  for (const ChannelDescription& sensor : body.sensors) {
    Channel channel = detail::empty_channel(sensor);
    // A channel that declares nothing, such as a height, has one number until more is known.
    if (channel.frames.columns() == 0) channel.frames = Matrix<float>(0, 1);
    exploration_.channels.push_back(std::move(channel));
    has_times_.push_back(sensor.rate == 0.0 && sensor.times_known);
  }
  last_.state.readings.resize(body.sensors.size());
}

double GrowingExploration::seconds_to(const BodyStep& step) const {
  return begun_ ? step.state.time - *begun_ - last_.state.time : 0.0;
}

void GrowingExploration::append(BodyStep step) {
  if (!begun_) begun_ = step.state.time;
  if (step.readings == Readings::kRecorded) {
    append_frames(step.state);
    timeline_->append(step.state.time - *begun_, frames_);
    scene_->append(step.poses);
  }
  step.state.time -= *begun_;
  for (std::size_t i = 0; i < step.state.readings.size(); ++i) {
    Matrix<float>& taken = step.state.readings[i];
    if (taken.rows() == 0) taken = std::move(last_.state.readings[i]);
  }
  last_ = std::move(step);
}

void GrowingExploration::append_frames(const BodyState& state) {
  for (std::size_t i = 0; i < state.readings.size(); ++i) {
    const Matrix<float>& taken = state.readings[i];
    if (taken.empty()) continue;
    Channel& channel = exploration_.channels[i];
    if (frames_[i] == 0) channel.frames = Matrix<float>(0, taken.columns());
    append_readings(channel, taken);
    if (has_times_[i]) append_times(channel, {state, i, 0.0}, state.time);
    frames_[i] += taken.rows();
  }
}

std::size_t GrowingExploration::bytes() const {
  std::size_t bytes = scene_->bytes();
  for (const Channel& channel : exploration_.channels) bytes += bytes_of(channel);
  return bytes;
}

void GrowingExploration::drop_half() {
  const std::size_t dropped = (timeline_->moments() - timeline_->first()) / 2;
  const std::vector<std::size_t> before = timeline_->dropped();
  scene_->drop(dropped);
  timeline_->drop_before(timeline_->first() + dropped);
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    drop_frames(exploration_.channels[i], timeline_->dropped(i) - before[i]);
  }
}

}  // namespace somato::live
