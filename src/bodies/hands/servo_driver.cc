#include "bodies/hands/servo_driver.h"

#include <algorithm>
#include <cmath>

namespace somato::detail {
namespace {

enum UserNumber { kPace, kResolution, kPlay };

double user_number(const mjModel& model, std::size_t servo, UserNumber which) {
  return model.actuator_user[servo * static_cast<std::size_t>(model.nuser_actuator) + which];
}

double sign(double value) {
  return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0;
}

}  // namespace

ServoDriver::ServoDriver(const mjModel& model, std::span<const double> positions, double play,
                         Random random)
    : positions_(positions.begin(), positions.end()),
      targets_(positions_),
      directions_(static_cast<std::size_t>(model.nu), 0.0),
      offsets_(static_cast<std::size_t>(model.nu), 0.0),
      play_(play),
      random_(random) {}

void ServoDriver::set_targets(std::span<const double> targets) {
  targets_.assign(targets.begin(), targets.end());
}

void ServoDriver::advance(const mjModel& model, std::size_t servo) {
  const double way = targets_[servo] - positions_[servo];
  if (way == 0.0) return;
  if (sign(way) != directions_[servo]) {
    directions_[servo] = sign(way);
    offsets_[servo] = play_ * user_number(model, servo, kPlay) * random_.normal();
  }
  const double most = user_number(model, servo, kPace) * model.opt.timestep;
  positions_[servo] =
      std::abs(way) <= most ? targets_[servo] : positions_[servo] + sign(way) * most;
}

void ServoDriver::step(const mjModel& model, std::span<mjtNum> commands) {
  for (std::size_t servo = 0; servo < positions_.size(); ++servo) {
    advance(model, servo);
    const double resolution = user_number(model, servo, kResolution);
    const double pulse = std::round(positions_[servo] / resolution) * resolution;
    const mjtNum* range = model.actuator_ctrlrange + 2 * servo;
    commands[servo] = std::clamp(pulse + offsets_[servo], range[0], range[1]);
  }
}

}  // namespace somato::detail
