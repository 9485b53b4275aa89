#include "hardware/buses/frame_queue.h"

#include <algorithm>
#include <limits>

namespace somato::devices {
namespace {

// The part of the time that passes by which a board's clock may be slow. The resonators of cheap
// boards differ by half a hundredth.
constexpr double kSlowest = 0.01;

Matrix<float> rows_of(const Matrix<float>& all, std::size_t first, std::size_t end) {
  const auto values = all.values().subspan(first * all.columns(), (end - first) * all.columns());
  return {end - first, all.columns(), {values.begin(), values.end()}};
}

}  // namespace

void FrameQueue::begin(double now) {
  is_open_ = true;
  begun_ = now;
  latest_ = now;
  values_ = Matrix<float>(0, values_.columns());
  times_.clear();
}

void FrameQueue::add(std::span<const float> values, double now, std::optional<double> device_time) {
  const double time = time_of(now, device_time);
  if (!is_open_ || time < begun_) return;
  latest_ = std::max(latest_, time);
  std::copy(values.begin(), values.end(), values_.add_row().begin());
  times_.push_back(latest_);
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
  const auto after = std::upper_bound(times_.begin(), times_.end(), end);
  const auto count = static_cast<std::size_t>(after - times_.begin());
  values = rows_of(values_, 0, count);
  times.assign(times_.begin(), after);
  values_ = rows_of(values_, count, times_.size());
  times_.erase(times_.begin(), after);
}

}  // namespace somato::devices
