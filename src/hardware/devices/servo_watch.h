#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "hardware/buses/servo_bus.h"
#include "hardware/device_files/device_file.h"
#include "somato/core/result.h"

namespace somato::devices {

/// Compares what servos report with what they are commanded, at each of their reports. A single
/// damaged report is outvoted by its neighbours, and time without reports does not count. Nothing
/// allocates after construction, unless there is an error.
class ServoWatch {
 public:
  /// `file` must outlive it.
  explicit ServoWatch(const DeviceFile& file);

  /// Forgets what it has seen: the servos start, or their reports have paused.
  void begin();

  /// Takes the reports, as far as they are new, and the positions commanded so far, one for each
  /// servo in its unit. Errors (kData) name the servo: it is too hot;
  /// it is outside of its limits; it moves away from where it is commanded; it does not move
  /// although it is commanded.
  Result<void> check(std::span<const double> commanded, std::span<const ServoReport> reports);

  /// Whether the servos do what they are commanded, so that they can hold: false after the error of
  /// a servo that is outside of its limits or moves away.
  bool obeys() const { return obeys_; }

 private:
  static constexpr std::size_t kReports = 3;

  struct Servo {
    std::array<double, kReports> last{};  // the last reports, in its unit
    std::size_t count = 0;
    std::size_t hot = 0;     // successive reports that are too hot
    double time = 0.0;       // of the last report
    double measured = 0.0;   // their median
    double commanded = 0.0;  // at the report before
    double direction = 0.0;  // of the last command
    double begun_at = 0.0;   // where it was when it was sent in this direction
    double away = 0.0;       // how far it has moved away from where it is commanded
    double still_at = 0.0;
    double still_for = 0.0;   // s
    double behind_for = 0.0;  // s
  };

  Result<void> take(std::size_t servo, double commanded, const ServoReport& report);
  Result<void> check_heat(std::size_t servo, const ServoReport& report);
  Result<void> check_position(std::size_t servo, double commanded, double passed);
  Result<void> check_limits(std::size_t servo);
  Result<void> check_drift(std::size_t servo, double before);
  Result<void> check_movement(std::size_t servo) const;
  void note_movement(std::size_t servo, double commanded, double passed);
  double deviation(std::size_t servo) const;

  const DeviceFile& file_;
  bool may_be_blocked_;
  bool obeys_ = true;
  std::vector<Servo> servos_;
};

}  // namespace somato::devices
