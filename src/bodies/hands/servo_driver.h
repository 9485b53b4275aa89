#pragma once

#include <span>
#include <vector>

#include "bodies/physics/physics.h"
#include "somato/core/random.h"

namespace somato::detail {

/// Drives the servos of a model as a servo controller does: towards their targets at a limited
/// pace, in steps of the pulse's resolution, off by the play of the gears. Positions are in the
/// model's units (rad, m). An actuator's user numbers are pace, resolution and play.
class ServoDriver {
 public:
  /// `play` multiplies the model's.
  ServoDriver(const mjModel& model, std::span<const double> positions, double play, Random random);

  void set_targets(std::span<const double> targets);

  /// Advances by a time step and writes the commands of all servos.
  void step(const mjModel& model, std::span<mjtNum> commands);

  const std::vector<double>& positions() const { return positions_; }

 private:
  void advance(const mjModel& model, std::size_t servo);

  std::vector<double> positions_;
  std::vector<double> targets_;
  std::vector<double> directions_;  // The directions of the last move: -1, 0, 1.
  std::vector<double> offsets_;     // Due to the backlash, drawn again whenever a servo reverses.
  double play_;
  Random random_;
};

}  // namespace somato::detail
