#include "bodies/sensors/potentiometer.h"

#include <algorithm>
#include <cmath>

namespace somato::detail {
namespace {

double most_counts(const HardnessProbeParameters& parameters) {
  return static_cast<double>((std::size_t{1} << parameters.potentiometer_bits) - 1);
}

double path_of(const HardnessProbeParameters& parameters) {
  return parameters.potentiometer_path.value_or(parameters.stroke);
}

double draw_difference(double spread, std::uint64_t seed) {
  return spread == 0.0 ? 0.0 : spread * Random(seed, Stream::kNoise).normal();
}

}  // namespace

Potentiometer::Potentiometer(const HardnessProbeParameters& parameters, std::uint64_t seed)
    : most_(most_counts(parameters)),
      counts_per_mm_(most_ / path_of(parameters)),
      offset_(parameters.potentiometer_offset * most_),
      press_(draw_difference(parameters.press_spread, seed)),
      noise_(parameters.potentiometer_noise) {}

float Potentiometer::read(double position, double deviation) const {
  const double measured = position + press_ + noise_ * deviation;
  return static_cast<float>(
      std::clamp(std::round(measured * counts_per_mm_ + offset_), 0.0, most_));
}

std::optional<double> stick_position(double counts, const HardnessProbeParameters& parameters) {
  const double share = counts / most_counts(parameters);
  const double position = (share - parameters.potentiometer_offset) * path_of(parameters);
  if (share >= 0.0 && share <= 1.0) return std::clamp(position, 0.0, parameters.stroke);
  return {};
}

double draw_press(Random& random) {
  return random.normal();
}

}  // namespace somato::detail
