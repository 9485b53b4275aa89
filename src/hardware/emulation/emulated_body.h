#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "hardware/boards/emulated_board.h"
#include "hardware/device_files/device_file.h"
#include "hardware/emulation/emulated_wire.h"
#include "hardware/emulation/sound_board.h"
#include "somato/bodies/body.h"

namespace somato::emulation {

/// The boards of a device, and the simulated body that they move and sense: the servo controller
/// drives the body's servos, and the body's sensors give the frames of the sensor board and the
/// samples of the microphone.
class EmulatedBody {
 public:
  /// `body` has the servos and sensors of the device file; see devices::check_against(). Throws
  /// InvalidArgument, here or while time passes, if a reading has other elements than its sensor.
  EmulatedBody(devices::DeviceFile file, std::unique_ptr<Body> body);

  /// Another body in its place, such as the same hand before another object.
  void replace(std::unique_ptr<Body> body);

  /// A servo that is stuck stays where it is, whatever the controller does; see DeviceFile::servos.
  void set_stuck(std::size_t servo, bool stuck) { stuck_.at(servo) = stuck ? 1 : 0; }

  /// Advances body and boards to `now`. Errors: those of the body.
  Result<void> advance(double now);

  /// Throws InvalidArgument if the device has none.
  EmulatedServos& servos();

  /// The number of servos that the boards drive now.
  std::size_t servos_on() const;
  EmulatedSensors* sensors() { return sensors_.get(); }

  /// The wires of the device, in the order of devices::lines_of().
  std::vector<EmulatedWire*> wires();

  const Body& body() const { return *body_; }

 private:
  Result<void> step();
  Result<void> drive();
  void sense();
  void measure();
  const Matrix<float>& readings_of(std::size_t sensor) const;
  double current(std::size_t servo) const;
  double target(std::size_t servo) const;

  devices::DeviceFile file_;
  std::unique_ptr<Body> body_;
  std::unique_ptr<EmulatedServos> servos_;
  std::unique_ptr<EmulatedSensors> sensors_;
  std::optional<SoundBoard> sound_;
  std::vector<std::unique_ptr<EmulatedWire>> wires_;
  std::vector<std::size_t> servo_of_;  // In the body, for each servo of the file.
  std::vector<char> stuck_;
  std::vector<double> targets_;
  std::vector<float> frame_;
  double done_ = 0.0;
};

}  // namespace somato::emulation
