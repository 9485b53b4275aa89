#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "hardware/device_files/device_file.h"

namespace somato::devices {

/// The calibration of one servo, found step by step: positions on the bus and what a person says
/// about them.
class Calibration {
 public:
  explicit Calibration(ServoSettings servo) : servo_(std::move(servo)) {}

  /// The position on the bus is position 0.
  void set_zero(double on_bus);

  /// The position on the bus is the given position, in the unit of the servo. Errors (kData): it is
  /// 0, or the position on the bus is that of 0.
  Result<void> set_position(double on_bus, double position);

  /// The position on the bus is a limit, or the resting position.
  void set_least(double on_bus) { least_ = on_bus; }
  void set_most(double on_bus) { most_ = on_bus; }
  void set_rest(double on_bus) { rest_ = on_bus; }

  /// The servo with what was found; limits are exchanged if the servo turns the other way.
  ServoSettings servo() const;

  /// The text of the device file with the calibration of this servo. Errors: those of
  /// parse_device_file(); nothing is changed then.
  Result<std::string> in_text(std::string_view text, std::string_view where) const;

 private:
  ServoSettings servo_;
  std::optional<double> least_;
  std::optional<double> most_;
  std::optional<double> rest_;
};

/// A device file with only one servo, which may move slowly over all that its bus can express, and
/// without sensors: for calibrating it. Errors (kUsage): no servo with this name.
Result<DeviceFile> one_servo(const DeviceFile& file, std::string_view servo);

}  // namespace somato::devices
