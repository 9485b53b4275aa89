#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hardware/device_files/device_file.h"

namespace somato::devices {

/// The only source of the positions that a bus is sent: it keeps every servo to its limits in
/// position and speed, whatever is commanded. Nothing here allocates after construction.
class SafeMotion {
 public:
  explicit SafeMotion(std::span<const ServoSettings> servos);

  /// Where each servo is, in its unit, when it is switched on; NaN: unknown, so that it is sent
  /// nothing until switch_on().
  void begin(std::span<const double> positions);

  /// Sends a servo of unknown position to its resting position: it jumps there at its own speed.
  void switch_on(std::size_t servo);

  /// The targets, in the units of the servos. A target that is not finite leaves the servo's
  /// target unchanged; one beyond a limit becomes the limit.
  void set_targets(std::span<const double> targets);

  /// The positions so far have been sent to the servos.
  void note_sent();

  /// Stops every servo at the position that it was sent last, or where it was when it began.
  void hold();

  /// Moves each position towards its target by at most `seconds` times the servo's highest speed;
  /// returns the positions on the bus, NaN for servos that are not switched on.
  std::span<const double> advance(double seconds);

  /// The positions so far, in the units of the servos; of a servo that is not switched on its
  /// resting position.
  std::span<const double> positions() const { return positions_; }

  std::span<const double> targets() const { return targets_; }

 private:
  std::vector<ServoSettings> servos_;
  std::vector<double> positions_;
  std::vector<double> sent_;
  std::vector<double> targets_;
  std::vector<char> on_;
  std::vector<double> on_bus_;
};

}  // namespace somato::devices
