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
#include "hardware/protocols/feetech.h"

namespace somato::devices {

/// A model of Feetech's. Source: the numbers that the servos report.
struct FeetechModel {
  std::string_view name;
  std::uint16_t number = 0;  ///< 0: any model of the series.
  wire::FeetechSeries series = wire::FeetechSeries::kSts;
};

/// The models that are known by name, and "STS" and "SCS" for any of a series.
std::span<const FeetechModel> feetech_models();

/// A servo as the device file declares it.
struct FeetechServo {
  std::uint8_t id = 1;  ///< 0 to 253.
  std::string model;    ///< A name of feetech_models().
};

/// Feetech servos of one series that hold positions, in steps of 4096 (STS) or 1024 (SCS) in a
/// turn.
///
/// Each tick sends one sync write of goals. With each goal goes what lets the servo move evenly to
/// it in the given time: to an STS servo the speed, because it ignores the time, in multiples of 50
/// steps/s, which is its resolution; to an SCS servo the time. Without it, a servo would jump to
/// each goal and stop there, 50 times in a second.
///
/// The states of STS servos are requested by one sync read. SCS servos do not know it and are read
/// one by one: follow_up() polls the next when one has answered, and each tick begins behind the
/// last one polled. A tick waits for an answer that may still arrive, because an adapter may be
/// slower than a period. They report no current. The answers of both contain the error bits.
/// Nothing is written to the EEPROM.
class FeetechBus : public ServoBus {
 public:
  /// Throws InvalidArgument for no servos, an id that is not possible or occurs twice, an unknown
  /// model, or servos of both series.
  explicit FeetechBus(std::vector<FeetechServo> servos);

  /// Also switches the torque of all servos on, with their present positions as goals.
  Result<void> start(wire::Exchange& exchange) override;

  std::span<const std::uint8_t> tick(std::span<const double> positions, double seconds) override;
  void receive(std::span<const std::uint8_t> bytes, double now) override;
  std::span<const std::uint8_t> follow_up() override;

  /// A broadcast to all servos of the line, repeated: if the packet before it was cut off, servos
  /// take the first ones for the rest of that packet.
  std::span<const std::uint8_t> relax_bytes() const override { return relax_; }

  bool reports_states() const override { return true; }
  bool reads_one_by_one() const override { return !is_sts(); }

  /// An SCS servo whose answer was lost is polled again after a wait.
  double recovery() const override;

  /// With all follow-ups.
  std::size_t bytes_per_tick() const override;

  /// Servos that do not know the instruction must be switched off and on.
  Result<void> reboot(std::size_t servo, wire::Exchange& exchange) override;

  /// Problems found by start() that do not prevent the use of the servos.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  using Bytes = std::vector<std::uint8_t>;
  struct Answer {
    std::uint8_t error = 0;
    Bytes data;
  };
  struct Servo {
    FeetechServo declared;
    const FeetechModel* model = nullptr;
    double goal = 0.0;  // the last that was sent
    GoalSpeed speed{};
    double lowest = 0.0;
    double highest = 0.0;
  };

  bool is_sts() const { return series_ == wire::FeetechSeries::kSts; }
  std::size_t state_size() const;
  std::uint16_t word(std::span<const std::uint8_t> bytes, std::size_t at) const;
  template <typename Fill>
  Bytes packet(const Fill& fill) const;
  Result<Answer> read(const Servo& servo, std::uint8_t address, std::size_t size,
                      wire::Exchange& exchange) const;
  Result<void> write(const Servo& servo, std::uint8_t address, const Bytes& data,
                     wire::Exchange& exchange) const;
  Result<void> check(Servo& servo, wire::Exchange& exchange);
  Result<void> check_limits(Servo& servo, std::span<const std::uint8_t> memory) const;
  Result<void> hold(std::size_t servo, wire::Exchange& exchange);
  Result<void> hold_all(wire::Exchange& exchange);
  void write_goals(wire::FeetechWriter& to, std::span<const double> positions, double seconds);
  void put_goal(wire::FeetechWriter& to, std::size_t servo, double goal, double seconds);
  std::span<const std::uint8_t> poll_one(wire::FeetechWriter& to);
  bool is_state(std::size_t servo, const wire::FeetechPacket& packet) const;
  void take_state(std::size_t servo, const wire::FeetechPacket& packet, double now);

  std::vector<Servo> servos_;
  std::vector<std::uint8_t> ids_;
  std::array<std::uint8_t, 256> servo_of_id_{};
  wire::FeetechSeries series_ = wire::FeetechSeries::kSts;
  Bytes tick_;
  Bytes relax_;
  std::size_t polled_ = 0;   // the servo that was polled last
  std::size_t to_poll_ = 0;  // how many are left in this tick
  bool answered_ = true;     // whether it has answered
  double waited_ = 0.0;      // the ticks' seconds since it was polled
  wire::FeetechDecoder decoder_;
  std::vector<std::string> warnings_;
};

}  // namespace somato::devices
