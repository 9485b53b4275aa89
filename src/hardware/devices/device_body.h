#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "hardware/device_files/device_file.h"
#include "hardware/devices/state_log.h"
#include "hardware/lines/lines.h"
#include "somato/bodies/body.h"

namespace somato::devices {

/// A body of real servos and sensors (or emulated ones) at serial lines. Its time is the time of
/// the lines' clock since it began.
///
/// Every period it reads the lines, checks what arrived, moves each servo towards its target within
/// its limits (SafeMotion), and sends the positions. It stops if a line hangs up, if no valid
/// answer or frame arrived for the permitted number of periods, if a servo reports an error or is
/// too hot, outside of its limits or not where it is commanded (ServoWatch), if samples of the
/// microphone were lost or have another rate (SampleClock), if the program was held up between two
/// steps or periods, or if the sensor of [safety] exceeds its limit: the servos hold their
/// positions for the declared time and are then switched off, and step() returns the error. They
/// are switched off at once if a servo does not obey, when the body is interrupted, and when it is
/// destroyed. A period allocates nothing.
class DeviceBody : public Body {
 public:
  /// Starts the servos and waits for the first frame; `lines`, those of lines_of(), must outlive
  /// the body. A servo whose position is unknown (SSC-32 after power-up) jumps to its resting
  /// position, one servo after the other. Errors (kSystem): a board that does not answer or sends
  /// nothing; (kData): a servo outside of its limits or with an error; a line too slow for the
  /// period; those of `before_jump`, which is called before the first servo jumps; (kInterrupted):
  /// `should_continue` has returned false. After an error or an exception all servos are off again;
  /// relax_bytes_of() is for a signal that ends the program meanwhile.
  static Result<std::unique_ptr<DeviceBody>> start(
      const DeviceFile& file, wire::Lines& lines,
      const std::function<Result<void>(const ServoSettings& servo)>& before_jump = {},
      const std::function<bool()>& should_continue = {});

  DeviceBody(const DeviceBody&) = delete;
  DeviceBody(DeviceBody&&) = delete;
  DeviceBody& operator=(const DeviceBody&) = delete;
  DeviceBody& operator=(DeviceBody&&) = delete;
  ~DeviceBody() override;

  const BodyDescription& description() const override;
  const BodyState& state() const override;

  /// The last states and commands.
  const StateLog& history() const;

  /// Begins another exploration: what has arrived in the meantime is discarded, and time is 0
  /// again. Errors (kSystem): a line has hung up.
  Result<void> begin();

  /// Ends the exploration. Errors (kSystem), after which the servos are off: samples of the
  /// microphone were lost, or there are too many.
  Result<void> end();

  /// Moves all servos to their resting positions at their own speeds. Errors: those of step().
  Result<void> go_to_rest();

  /// The next step follows after a wait of any duration, during which the servos hold, such as that
  /// for a person or a picture. Without this, a step that begins late is a fault.
  void expect_pause();

  /// Whether its servos are on: until it stops, or relax().
  bool is_on() const;

  /// Switches all servos off, now; nothing moves afterwards.
  void relax() noexcept;

  class Impl;

 protected:
  Result<void> drive_to(std::span<const double> targets) override;
  Result<void> pass(double seconds) override;

 private:
  explicit DeviceBody(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace somato::devices
