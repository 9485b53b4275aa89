#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hardware/boards/servo_chain.h"

namespace somato::emulation {

/// A servo as it comes out of the box, except for its id.
struct EmulatedDynamixel {
  std::uint8_t id = 1;
  std::uint16_t model = 1240;       ///< XC330-M288.
  double position = 2048.0;         ///< In steps.
  double current_unit = 1.0;        ///< mA for a count of its current.
  std::uint8_t return_delay = 250;  ///< In 2 us.
};

/// Dynamixel servos of the X series (protocol 2).
class DynamixelServos : public ServoChain {
 public:
  explicit DynamixelServos(const std::vector<EmulatedDynamixel>& servos, bool echo = false);

  void set_measured(std::size_t servo, double position, double current) override;
  void overload(std::size_t servo) override;

 private:
  void obey_single(Servo& servo, const wire::Packet& packet) override;
  bool answers(const Servo& servo, Instruction to) const override;
  std::uint8_t error_bits(const Servo& servo) const override;
  std::uint8_t refusal(const Servo& servo, std::size_t address, Span data) const override;
  void write_byte(Servo& servo, std::size_t address, std::uint8_t value) const override;
  void set_defaults(Servo& servo) const override;
  double position(const Servo& servo, std::uint16_t address) const override;
  double speed(const Servo& servo, double way) const override;
  std::uint8_t result_of(Servo& servo, const wire::Packet& packet);

  std::vector<double> current_units_;
};

}  // namespace somato::emulation
