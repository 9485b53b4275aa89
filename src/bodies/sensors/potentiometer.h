#pragma once

#include <cstdint>
#include <optional>

#include "somato/core/random.h"
#include "somato/simulation/simulation_parameters.h"

namespace somato::detail {

/// The potentiometer of a stick and its converter: counts for a position in mm.
class Potentiometer {
 public:
  /// `seed` is that of the exploration: the potentiometer differs from the stick in each by another
  /// distance.
  Potentiometer(const HardnessProbeParameters& parameters, std::uint64_t seed);

  /// The reading of a stick at `position` mm, with a deviation of as many times the noise.
  float read(double position, double deviation) const;

 private:
  double most_;
  double counts_per_mm_;
  double offset_;  // counts
  double press_;   // mm
  double noise_;   // mm
};

/// The position of the stick, in mm, if its potentiometer reads `counts`; empty outside its range.
std::optional<double> stick_position(double counts, const HardnessProbeParameters& parameters);

/// The deviation of the force of a press, normal, which it draws before its noise.
double draw_press(Random& random);

}  // namespace somato::detail
