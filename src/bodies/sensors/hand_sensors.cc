#include "bodies/sensors/hand_sensors.h"

#include <cmath>

namespace somato::detail {
namespace {

std::vector<double> draw_offsets(double spread, std::size_t count, std::uint64_t seed) {
  Random random(seed, Stream::kNoise);
  std::vector<double> offsets(count, 0.0);
  if (spread == 0.0) return offsets;
  for (double& offset : offsets) offset = spread * random.normal();
  return offsets;
}

}  // namespace

HandSensors::HandSensors(const SimulationParameters& parameters, HandSensorCounts counts,
                         std::uint64_t seed, std::uint64_t hand_seed)
    : counts_(counts),
      joint_noise_(parameters.joint_noise),
      hand_(hand_seed, Stream::kHandSensors),
      touch_(parameters, PiezoConverter::kUnipolar, counts.taxels, hand_),  // no contact pulls
      change_(parameters, parameters.piezo_converter, counts.taxels, hand_),
      piezo_(counts.taxels, parameters.piezo_time),
      joint_offsets_(draw_offsets(parameters.joint_spread, counts.joints, seed)),
      noise_(seed, Stream::kHandSensors) {
  if (!parameters.joint_bits) return;
  joint_step_ =
      parameters.joint_range / static_cast<double>(std::size_t{1} << *parameters.joint_bits);
}

std::vector<Matrix<float>> HandSensors::read(const std::vector<double>& joints) {
  std::vector<Matrix<float>> readings;
  if (counts_.joints > 0) readings.push_back(read_joints(joints));
  if (counts_.taxels == 0) return readings;
  readings.push_back(read_touch(touch_, piezo_.forces()));
  readings.push_back(read_touch(change_, piezo_.signals()));
  return readings;
}

void HandSensors::skip(std::uint64_t readings) {
  const std::uint64_t normals = readings * (counts_.joints + 2 * counts_.taxels);
  for (std::uint64_t i = 0; i < normals; ++i) static_cast<void>(noise_.normal());
}

Matrix<float> HandSensors::read_joints(const std::vector<double>& joints) {
  Matrix<float> readings(1, counts_.joints);
  for (std::size_t i = 0; i < counts_.joints; ++i) {
    double value = joints[i] + joint_offsets_[i] + joint_noise_ * noise_.normal();
    if (joint_step_ > 0.0) value = std::round(value / joint_step_) * joint_step_;
    readings(0, i) = static_cast<float>(value);
  }
  return readings;
}

Matrix<float> HandSensors::read_touch(const TouchSensors& sensors,
                                      const std::vector<double>& sensed) {
  Matrix<float> readings(1, counts_.taxels);
  sensors.read(sensed, noise_, readings.row(0));
  return readings;
}

}  // namespace somato::detail
