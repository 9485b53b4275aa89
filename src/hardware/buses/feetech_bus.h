#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hardware/buses/packet_bus.h"
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

/// A read of the memory as far as the model. A request of two bytes would have an echo that looks
/// like its answer.
BusInquiry feetech_inquiry(wire::FeetechSeries series);

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
///
/// Servos that do not know the instruction of a reboot must be switched off and on.
class FeetechBus : public PacketBus {
 public:
  /// Throws InvalidArgument for no servos, an id that is not possible or occurs twice, an unknown
  /// model, or servos of both series.
  explicit FeetechBus(const std::vector<PacketServo>& servos);

  Result<void> start(wire::Exchange& exchange) override;
  std::span<const std::uint8_t> follow_up() override;
  bool reads_one_by_one() const override { return !is_sts(); }

  /// An SCS servo whose answer was lost is polled again after a wait.
  double recovery() const override;

  /// With all follow-ups.
  std::size_t bytes_per_tick() const override;

 private:
  bool is_sts() const { return series_ == wire::FeetechSeries::kSts; }
  std::size_t state_size() const;
  std::uint16_t word(Span bytes, std::size_t at) const;

  Result<void> check(std::size_t servo, wire::Exchange& exchange) override;
  Result<void> measure(std::size_t servo, wire::Exchange& exchange) override;
  Result<void> write(const Servo& servo, std::uint16_t address, const Bytes& data,
                     wire::Exchange& exchange) override;
  Result<void> write_goal(std::size_t servo, wire::Exchange& exchange) override;
  Result<void> restart(const Servo& servo, wire::Exchange& exchange) override;
  void put_goal(wire::PacketWriter& to, std::size_t servo, double goal, double seconds) override;
  void request_states(wire::PacketWriter& to, double seconds) override;
  void take(std::size_t servo, const wire::Packet& packet, double now) override;

  Result<void> check_limits(Servo& servo, Span memory) const;
  void poll_one(wire::PacketWriter& to);
  bool is_state(std::size_t servo, const wire::Packet& packet) const;
  void take_state(std::size_t servo, std::uint8_t error, Span state, double now);

  wire::FeetechSeries series_;
  std::vector<const FeetechModel*> models_;  // of the servos
  std::size_t polled_ = 0;                   // the servo that was polled last
  std::size_t to_poll_ = 0;                  // how many are left in this tick
  bool answered_ = true;                     // whether it has answered
  double waited_ = 0.0;                      // the ticks' seconds since it was polled
};

}  // namespace somato::devices
