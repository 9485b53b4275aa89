#include "bodies/sensors/touch_sensors.h"

#include <algorithm>
#include <cmath>

#include "base/core/elementary.h"

namespace somato::detail {
namespace {

// A factor around 1 whose logarithm has this standard deviation.
double factor(double spread, double normal) {
  return spread == 0.0 ? 1.0 : exponential(spread * normal);
}

}  // namespace

TouchSensors::TouchSensors(const SimulationParameters& parameters, PiezoConverter converter,
                           std::size_t count, Random& hand)
    : gains_(count),
      rests_(count),
      deviation_(parameters.sensor_noise),
      threshold_(parameters.touch_threshold),
      converter_(converter) {
  for (std::size_t i = 0; i < count; ++i) {
    gains_[i] = factor(parameters.touch_gain_spread, hand.normal());
    rests_[i] = parameters.touch_rest * factor(parameters.touch_rest_spread, hand.normal());
  }
  if (!parameters.touch_bits) return;
  const bool unipolar = converter == PiezoConverter::kUnipolar;
  const auto codes = static_cast<double>(std::size_t{1} << *parameters.touch_bits);
  step_ = parameters.touch_range / (unipolar ? codes - 1.0 : codes / 2.0);
  least_ = unipolar ? 0.0 : -parameters.touch_range;
  most_ = unipolar ? parameters.touch_range : parameters.touch_range - step_;
}

void TouchSensors::read(std::span<const double> sensed, Random& noise,
                        std::span<float> readings) const {
  for (std::size_t i = 0; i < sensed.size(); ++i) {
    const double value = gains_[i] * sensed[i] + rests_[i] + deviation_ * noise.normal();
    readings[i] = static_cast<float>(reported(converted(value)));
  }
}

double TouchSensors::converted(double value) const {
  if (converter_ == PiezoConverter::kUnipolar) value = std::max(0.0, value);
  if (step_ == 0.0) return value;
  return std::clamp(std::round(value / step_) * step_, least_, most_);
}

double TouchSensors::reported(double value) const {
  return std::abs(value) < threshold_ ? 0.0 : value;
}

}  // namespace somato::detail
