#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hardware/boards/servo_chain.h"
#include "hardware/protocols/feetech.h"

namespace somato::emulation {

/// A servo as it comes out of the box, except for its id.
struct EmulatedFeetech {
  std::uint8_t id = 1;
  std::uint16_t model = 777;      ///< STS3215; 1284: SCS0009.
  double position = 512.0;        ///< In steps.
  std::uint8_t return_delay = 0;  ///< In 2 us.
};

/// Feetech servos of one series.
class FeetechServos : public ServoChain {
 public:
  FeetechServos(wire::FeetechSeries series, const std::vector<EmulatedFeetech>& servos,
                bool echo = false);

  void set_measured(std::size_t servo, double position, double current) override;
  void overload(std::size_t servo) override;

 private:
  bool is_sts() const { return series_ == wire::FeetechSeries::kSts; }
  std::uint16_t lock() const {
    return is_sts() ? wire::feetech::kLockSts : wire::feetech::kLockScs;
  }
  void obey_single(Servo& servo, const wire::Packet& packet) override;
  bool answers(const Servo& servo, Instruction to) const override;
  std::uint8_t error_bits(const Servo& servo) const override;
  void write_byte(Servo& servo, std::size_t address, std::uint8_t value) const override;
  void set_defaults(Servo& servo) const override;
  double position(const Servo& servo, std::uint16_t address) const override;
  double limited_goal(const Servo& servo) const override;
  double speed(const Servo& servo, double way) const override;

  wire::FeetechSeries series_;
};

}  // namespace somato::emulation
