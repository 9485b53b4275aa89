#pragma once

#include <optional>

#include "somato/core/parameter.h"

namespace somato {

/// How a hand and the object before it are simulated.
struct SimulationParameters {
  double time_step = 0.001;
  bool free = false;
  bool taxels = false;
  double placement_noise = 1.0;
  std::optional<double> placement_turn;
  double sensor_noise = 0.02;
  double joint_noise = 0.2;
  double servo_play = 1.0;
  double piezo_time = 0.1;
  std::optional<double> friction;

  static const Declarations<SimulationParameters>& declarations();
};

}  // namespace somato
