#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hardware/buses/packet_bus.h"
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

/// A ping, whose answer contains the model.
BusInquiry dynamixel_inquiry();

/// Dynamixel servos of the X series (protocol 2) that hold positions in steps of 4096 in a turn.
///
/// Each tick sends one sync write of goals and one sync read of states. With each goal goes the
/// profile velocity at which it is reached just in the given time, without acceleration: then the
/// servo moves evenly from goal to goal. Without a profile it would jump to each goal and stop
/// there, 50 times in a second; with an acceleration it would stop between goals too. Drive modes
/// with a profile in time get the time instead.
///
/// A servo announces a hardware error by a bit of each answer. It is then reported as
/// kUnknownError, and the next tick requests the errors instead of the states.
class DynamixelBus : public PacketBus {
 public:
  /// A hardware error whose kind has not been read yet.
  static constexpr std::uint8_t kUnknownError = wire::dynamixel_error::kAlert;

  /// Throws InvalidArgument for no servos, an id that is not possible or occurs twice, or an
  /// unknown model. An empty model stands for any.
  explicit DynamixelBus(const std::vector<PacketServo>& servos);

  Result<void> start(wire::Exchange& exchange) override;
  std::size_t bytes_per_tick() const override;

 private:
  struct Settings {
    double current_unit = 0.0;
    double fastest = 0.0;  // limit of the profile velocity
    bool timed = false;    // profile in time
  };

  Result<void> check(std::size_t servo, wire::Exchange& exchange) override;
  Result<void> measure(std::size_t servo, wire::Exchange& exchange) override;
  Result<void> write(const Servo& servo, std::uint16_t address, const Bytes& data,
                     wire::Exchange& exchange) override;
  Result<void> write_goal(std::size_t servo, wire::Exchange& exchange) override;
  Result<void> restart(const Servo& servo, wire::Exchange& exchange) override;
  void put_goal(wire::PacketWriter& to, std::size_t servo, double goal, double seconds) override;
  void request_states(wire::PacketWriter& to, double seconds) override;
  void take(std::size_t servo, const wire::Packet& packet, double now) override;

  Result<void> check_model(std::size_t servo, wire::Exchange& exchange);
  Result<void> check_modes(std::size_t servo, wire::Exchange& exchange);
  Result<void> read_limits(std::size_t servo, bool one_turn, wire::Exchange& exchange);
  std::uint32_t profile_velocity(std::size_t servo, double goal, double seconds);
  void take_state(std::size_t servo, Span state, double now);
  bool error_is_unknown() const;
  std::uint16_t size_of_next_state();

  std::vector<Settings> settings_;
  bool errors_requested_ = false;
  double since_temperatures_ = 0.0;  // s
};

}  // namespace somato::devices
