#include "hardware/buses/frame_queue.h"

#include <algorithm>
#include <limits>
#include <span>

#include "somato/core/check.h"

namespace somato::devices {
namespace {

// The part of the time that passes by which a board's clock may be slow. The resonators of cheap
// boards differ by half a hundredth.
constexpr double kSlowest = 0.01;

}  // namespace

void FrameQueue::begin(double now) {
  is_open_ = true;
  begun_ = now;
  latest_ = now;
  waiting_ = WaitingFrames(values_);
}

void FrameQueue::add(std::span<const float> values, double now, std::optional<double> device_time) {
  require(values.size() == values_, "FrameQueue::add: another number of values");
  const double time = time_of(now, device_time);
  if (!is_open_ || time < begun_) return;
  latest_ = std::max(latest_, time);
  waiting_.add(values, latest_);
}

double FrameQueue::time_of(double now, std::optional<double> device_time) {
  if (!device_time) return now;
  const double passed = *device_time - device_time_;
  const bool restarted = passed < 0.0;
  ahead_ =
      restarted ? now - *device_time : std::min(now - *device_time, ahead_ + kSlowest * passed);
  device_time_ = *device_time;
  return *device_time + ahead_;
}

void FrameQueue::take(double end, Matrix<float>& values, std::vector<double>& times) {
  const std::span<const double> all = waiting_.times();
  times.assign(all.begin(), std::upper_bound(all.begin(), all.end(), end));
  values = waiting_.take(times.size());
}

}  // namespace somato::devices
