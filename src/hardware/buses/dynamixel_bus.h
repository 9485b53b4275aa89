#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hardware/buses/goal_speed.h"
#include "hardware/buses/servo_bus.h"
#include "hardware/protocols/dynamixel.h"

namespace somato::devices {

/// A model of the X series. Source: ROBOTIS e-Manual, X series.
struct DynamixelModel {
  std::string_view name;
  std::uint16_t number = 0;
  double current_unit = 0.0;  ///< mA for a count of the present current; NaN: it measures a load.
};

/// The models that are known by name.
std::span<const DynamixelModel> dynamixel_models();

/// A servo as the device file declares it.
struct DynamixelServo {
  std::uint8_t id = 1;  ///< 0 to 252.
  std::string model;    ///< A name of dynamixel_models(); empty: any of them.
};

/// Dynamixel servos of the X series (protocol 2) that hold positions in steps of 4096 in a turn.
///
/// Each tick sends one sync write of goals and one sync read of states. With each goal goes the
/// profile velocity at which it is reached just in the given time, without acceleration: then the
/// servo moves evenly from goal to goal. Without a profile it would jump to each goal and stop
/// there, 50 times in a second; with an acceleration it would stop between goals too. Drive modes
/// with a profile in time get the time instead.
///
/// A servo announces a hardware error by a bit of each answer. It is then reported as
/// kUnknownError, and the next tick requests the errors instead of the states. Nothing is written
/// to the EEPROM.
class DynamixelBus : public ServoBus {
 public:
  /// A hardware error whose kind has not been read yet.
  static constexpr std::uint8_t kUnknownError = wire::dynamixel_error::kAlert;

  /// Throws InvalidArgument for no servos, an id that is not possible or occurs twice, or an
  /// unknown model.
  explicit DynamixelBus(std::vector<DynamixelServo> servos);

  /// Also switches the torque of all servos on, with their present positions as goals.
  Result<void> start(wire::Exchange& exchange) override;

  std::span<const std::uint8_t> tick(std::span<const double> positions, double seconds) override;
  void receive(std::span<const std::uint8_t> bytes, double now) override;

  /// A broadcast to all servos of the line, repeated: if the packet before it was cut off, servos
  /// take the first ones for the rest of that packet.
  std::span<const std::uint8_t> relax_bytes() const override { return relax_; }

  bool reports_states() const override { return true; }
  std::size_t bytes_per_tick() const override;

  Result<void> reboot(std::size_t servo, wire::Exchange& exchange) override;

  /// Problems found by start() that do not prevent the use of the servos.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  using Bytes = std::vector<std::uint8_t>;
  struct Servo {
    DynamixelServo declared;
    double current_unit = 0.0;
    double goal = 0.0;  // the last that was sent
    GoalSpeed speed{};
    double lowest = 0.0;
    double highest = 0.0;
    double fastest = 0.0;  // limit of the profile velocity
    bool timed = false;    // profile in time
  };

  Result<Bytes> exchange_with(const Servo& servo, std::span<const std::uint8_t> request,
                              std::size_t size, wire::Exchange& exchange) const;
  Result<Bytes> read(const Servo& servo, std::uint16_t address, std::size_t size,
                     wire::Exchange& exchange) const;
  Result<void> write(const Servo& servo, std::uint16_t address, std::span<const std::uint8_t> data,
                     wire::Exchange& exchange) const;
  Result<void> check(Servo& servo, wire::Exchange& exchange);
  Result<void> check_model(Servo& servo, wire::Exchange& exchange) const;
  Result<void> check_modes(Servo& servo, wire::Exchange& exchange);
  Result<void> check_error(const Servo& servo, wire::Exchange& exchange) const;
  Result<void> read_limits(Servo& servo, bool one_turn, wire::Exchange& exchange) const;
  Result<void> hold(std::size_t servo, wire::Exchange& exchange);
  Result<void> hold_all(wire::Exchange& exchange);
  std::uint32_t profile_velocity(std::size_t servo, double goal, double seconds);
  void write_goals(wire::DynamixelWriter& to, std::span<const double> positions, double seconds);
  void take_state(std::size_t servo, std::span<const std::uint8_t> state, double now);
  bool error_is_unknown() const;
  std::uint16_t size_of_next_state();

  std::vector<Servo> servos_;
  std::vector<std::uint8_t> ids_;
  std::array<std::uint8_t, 256> servo_of_id_{};
  Bytes tick_;
  Bytes relax_;
  bool errors_requested_ = false;
  double since_temperatures_ = 0.0;  // s
  wire::DynamixelDecoder decoder_;
  std::vector<std::string> warnings_;
};

}  // namespace somato::devices
