#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "hardware/buses/servo_bus.h"

namespace somato::devices {

/// The last states and commands of a device, to be saved with a fault. Adding a state allocates
/// nothing.
class StateLog {
 public:
  static constexpr std::size_t kStates = 50;

  /// `servos` are the names of the servos.
  explicit StateLog(std::vector<std::string> servos);

  /// The state at `time`: for each servo its target, the position commanded, and what it reports;
  /// and the age of the last sensor frame, s. Throws InvalidArgument for a wrong number of servos.
  void add(double time, std::span<const double> targets, std::span<const double> positions,
           std::span<const ServoReport> reports, double frame_age);

  std::size_t size() const { return count_ < kStates ? count_ : kStates; }

  /// All states, oldest first, as CSV with a line of names; empty cells where a servo reports
  /// nothing.
  std::string to_csv() const;

 private:
  struct Servo {
    double target = 0.0;
    double position = 0.0;
    ServoReport report;
  };
  struct State {
    double time = 0.0;
    double frame_age = 0.0;
    std::vector<Servo> servos;
  };

  std::vector<std::string> names_;
  std::vector<State> states_;
  std::size_t count_ = 0;
};

}  // namespace somato::devices
