#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/random.h"
#include "somato/simulation/simulation_parameters.h"

namespace somato::detail {

/// The touch sensors of a hand with their converter: each has a sensitivity and a resting level of
/// its own, and noise.
class TouchSensors {
 public:
  /// `hand` draws the properties of the sensors, two normal numbers for each.
  TouchSensors(const SimulationParameters& parameters, PiezoConverter converter, std::size_t count,
               Random& hand);

  std::size_t count() const { return gains_.size(); }

  /// The readings for what the sensors measure (N), with one normal number of `noise` for each.
  void read(std::span<const double> sensed, Random& noise, std::span<float> readings) const;

 private:
  double converted(double value) const;
  double reported(double value) const;

  std::vector<double> gains_;
  std::vector<double> rests_;
  double deviation_;
  double threshold_;
  PiezoConverter converter_;
  double step_ = 0.0;  // N; 0: without steps and limits
  double least_ = 0.0;
  double most_ = 0.0;
};

}  // namespace somato::detail
