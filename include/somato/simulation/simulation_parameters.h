#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"

namespace somato {

/// What the converter behind a piezo element reads, whose voltage is negative while a load falls.
enum class PiezoConverter {
  kBipolar,   ///< Rising and falling loads.
  kUnipolar,  ///< Rising loads; 0 while a load falls.
};

template <>
struct Choices<PiezoConverter> {
  static const std::vector<std::pair<PiezoConverter, std::string>>& all();
};

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
  double touch_threshold = 0.1;
  double piezo_time = 0.1;
  PiezoConverter piezo_converter = PiezoConverter::kUnipolar;
  std::optional<double> friction;

  static const Declarations<SimulationParameters>& declarations();
};

}  // namespace somato
