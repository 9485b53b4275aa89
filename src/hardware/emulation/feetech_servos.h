#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "hardware/emulation/emulated_board.h"
#include "hardware/protocols/feetech.h"

namespace somato::emulation {

/// A servo as it comes out of the box, except for its id.
struct EmulatedFeetech {
  std::uint8_t id = 1;
  std::uint16_t model = 777;      ///< STS3215; 1284: SCS0009.
  double position = 512.0;        ///< In steps.
  std::uint8_t return_delay = 0;  ///< In 2 us.
};

/// A chain of Feetech servos of one series at one line: their memories, the ramps of their goals,
/// and their answers. They move nowhere by themselves: the caller reads driven_position() and says
/// what they measure.
class FeetechServos : public EmulatedServos {
 public:
  /// With `echo`, the line returns everything that it receives, as adapters with one wire for both
  /// directions do.
  FeetechServos(wire::FeetechSeries series, const std::vector<EmulatedFeetech>& servos,
                bool echo = false);

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

  /// The number of one or two bytes at an address, and writing it past all checks.
  std::uint16_t stored(std::size_t servo, std::uint8_t address, std::size_t size) const;
  void store(std::size_t servo, std::uint8_t address, std::size_t size, std::uint16_t value);

  /// How many instructions have written to the EEPROM, which endures few.
  std::size_t eeprom_writes() const { return eeprom_writes_; }

 private:
  using Span = std::span<const std::uint8_t>;
  using Memory = std::array<std::uint8_t, 128>;
  struct Servo {
    EmulatedFeetech made;
    Memory memory{};
    Memory kept{};                         // the EEPROM, which may differ while it is locked
    std::vector<std::uint8_t> registered;  // address and data of a reg write
    double ramp = 0.0;                     // where its motion has arrived
    double speed = 0.0;                    // of the motion in steps/s; 0: a step
    double away_until = 0.0;               // it boots
    bool silent = false;
  };
  struct Answer {
    double time;
    std::vector<std::uint8_t> bytes;
  };

  bool is_sts() const { return series_ == wire::FeetechSeries::kSts; }
  std::uint16_t word(const Servo& servo, std::uint8_t address) const;
  double position(const Servo& servo, std::uint8_t address) const;
  void boot(Servo& servo) const;
  bool listens(const Servo& servo) const;
  void obey(const wire::FeetechPacket& packet);
  void obey_single(Servo& servo, const wire::FeetechPacket& packet);
  void obey_sync_read(Span parameters);
  void obey_sync_write(Span parameters);
  void write(Servo& servo, Span address_and_data);
  void write_byte(Servo& servo, std::size_t address, std::uint8_t value) const;
  void follow_goal(Servo& servo) const;
  void answer(const Servo& servo, Span data);

  wire::FeetechSeries series_;
  std::vector<Servo> servos_;
  bool echo_;
  double now_ = 0.0;
  double line_free_ = 0.0;  // when the last answer that is planned begins
  std::size_t eeprom_writes_ = 0;
  wire::FeetechDecoder decoder_;
  std::deque<Answer> answers_;
};

}  // namespace somato::emulation
