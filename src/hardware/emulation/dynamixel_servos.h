#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "hardware/emulation/emulated_board.h"
#include "hardware/protocols/dynamixel.h"

namespace somato::emulation {

/// A servo as it comes out of the box, except for its id.
struct EmulatedDynamixel {
  std::uint8_t id = 1;
  std::uint16_t model = 1240;       ///< XC330-M288.
  double position = 2048.0;         ///< In steps.
  double current_unit = 1.0;        ///< mA for a count of its current.
  std::uint8_t return_delay = 250;  ///< In 2 us.
};

/// A chain of Dynamixel servos of the X series at one line (protocol 2): their control tables, the
/// ramps of their goals, and their answers. They move nowhere by themselves: the caller reads
/// driven_position() and says what they measure.
class DynamixelServos : public EmulatedServos {
 public:
  /// With `echo`, the line returns everything that it receives, as adapters with one wire for both
  /// directions do.
  explicit DynamixelServos(const std::vector<EmulatedDynamixel>& servos, bool echo = false);

  void receive(std::span<const std::uint8_t> bytes) override;
  void advance(double now, std::vector<std::uint8_t>& sent) override;
  void restart() override;
  std::optional<double> driven_position(std::size_t servo) const override;
  void set_measured(std::size_t servo, double position, double current) override;

  /// The servo measures this temperature, in degrees Celsius, without an error.
  void heat(std::size_t servo, std::uint8_t temperature);

  /// The servo notices an overload and switches its torque off until it is rebooted.
  void overload(std::size_t servo);

  /// Whether the servo answers nothing and obeys nothing, as if its cable were pulled.
  void set_silent(std::size_t servo, bool silent);

  /// The number at an address of the control table, and writing it past all checks.
  std::uint32_t stored(std::size_t servo, std::uint16_t address, std::size_t size) const;
  void store(std::size_t servo, std::uint16_t address, std::size_t size, std::uint32_t value);

  /// How many instructions have written to the EEPROM, which endures few.
  std::size_t eeprom_writes() const { return eeprom_writes_; }

 private:
  using Span = std::span<const std::uint8_t>;
  struct Servo {
    EmulatedDynamixel made;
    std::array<std::uint8_t, 256> table{};
    std::vector<std::uint8_t> registered;  // instruction and parameters of a reg write
    double ramp = 0.0;                     // where its profile has arrived
    double speed = 0.0;                    // of the profile in steps/s; 0: none
    double away_until = 0.0;               // it boots
    bool silent = false;
  };
  struct Answer {
    double time;
    std::vector<std::uint8_t> bytes;
  };

  void boot(Servo& servo) const;
  bool listens(const Servo& servo) const;
  void obey(const wire::DynamixelPacket& packet);
  void obey_single(Servo& servo, const wire::DynamixelPacket& packet);
  void obey_sync_read(Span parameters);
  void obey_sync_write(Span parameters);
  std::uint8_t write(Servo& servo, std::uint16_t address, Span data);
  std::uint8_t refusal(const Servo& servo, std::uint16_t address, Span data) const;
  void follow_goal(Servo& servo) const;
  void answer(const Servo& servo, std::uint8_t error, Span parameters, std::uint8_t level);

  std::vector<Servo> servos_;
  bool echo_;
  double now_ = 0.0;
  double line_free_ = 0.0;  // when the last answer that is planned begins
  std::size_t eeprom_writes_ = 0;
  wire::DynamixelDecoder decoder_;
  std::deque<Answer> answers_;
};

}  // namespace somato::emulation
