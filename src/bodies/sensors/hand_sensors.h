#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bodies/sensors/piezo_elements.h"
#include "bodies/sensors/touch_sensors.h"
#include "somato/core/matrix.h"
#include "somato/core/random.h"
#include "somato/simulation/simulation_parameters.h"

namespace somato::detail {

/// The numbers of sensors of a hand.
struct HandSensorCounts {
  std::size_t joints = 0;  ///< Potentiometers.
  std::size_t taxels = 0;
};

/// The sensors of a hand that have noise: its potentiometers and its taxels.
class HandSensors {
 public:
  /// `seed` is that of the exploration, `hand_seed` that of the hand, whose sensors remain the same
  /// in all explorations.
  HandSensors(const SimulationParameters& parameters, HandSensorCounts counts, std::uint64_t seed,
              std::uint64_t hand_seed);

  PiezoElements& piezo() { return piezo_; }

  /// The next readings, each a row: of the potentiometers (deg) if there are any, for the true
  /// `joints`; of the taxels (N), if there are any, and their piezo elements, for piezo().
  std::vector<Matrix<float>> read(const std::vector<double>& joints);

  /// Leaves out the next `readings`, which are not recorded.
  void skip(std::uint64_t readings);

 private:
  Matrix<float> read_joints(const std::vector<double>& joints);
  Matrix<float> read_touch(const TouchSensors& sensors, const std::vector<double>& sensed);

  HandSensorCounts counts_;
  double joint_noise_;
  double joint_step_ = 0.0;  // deg; 0: without steps
  Random hand_;              // draws the properties of the sensors
  TouchSensors touch_;
  TouchSensors change_;
  PiezoElements piezo_;
  std::vector<double> joint_offsets_;  // deg
  Random noise_;
};

}  // namespace somato::detail
