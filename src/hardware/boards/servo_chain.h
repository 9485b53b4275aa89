#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hardware/boards/emulated_board.h"
#include "hardware/protocols/packets.h"

namespace somato::emulation {

/// The memory of a kind of servos. Addresses below `torque` are in the EEPROM.
struct ServoMemory {
  wire::ByteOrder order = wire::ByteOrder::kLowFirst;
  std::size_t address_size = 1;  ///< Bytes of an address, and of a size, in an instruction.
  std::size_t end = 0;           ///< The first address that does not exist.
  std::uint16_t id = 0;          ///< Addresses from here on.
  std::uint16_t return_delay = 0;
  std::uint16_t torque = 0;
  std::uint16_t goal = 0;
  std::size_t goal_size = 0;
  std::uint16_t position = 0;
  std::uint16_t temperature = 0;
  std::uint16_t measured = 0;  ///< The first of the measurements that a restart does not change.
  std::size_t measured_size = 0;
  std::uint8_t access_error = 0;  ///< Answers a read of what does not exist; 0: no answer.
  bool sync_by_any_id = false;    ///< Whether sync instructions need not be addressed to all.
  double boot = 0.0;              ///< s until a servo that was switched on answers.
};

/// A chain of servos at one line that exchange packets with the host: their memories, the ramps of
/// their goals, and their answers. They move nowhere by themselves: the caller reads
/// driven_position() and says what they measure.
class ServoChain : public EmulatedServos {
 public:
  void receive(std::span<const std::uint8_t> bytes) override;
  void advance(double now, std::vector<std::uint8_t>& sent) override;
  void restart() override;
  std::optional<double> driven_position(std::size_t servo) const override;

  /// The servo measures this temperature, in degrees Celsius, without an error.
  void heat(std::size_t servo, std::uint8_t temperature);

  /// The servo notices an overload and switches its torque off until it is rebooted.
  virtual void overload(std::size_t servo) = 0;

  /// Whether the servo answers nothing and obeys nothing, as if its cable were pulled.
  void set_silent(std::size_t servo, bool silent) { servos_.at(servo).silent = silent; }

  /// The number of `size` bytes at an address, and writing it past all checks.
  std::uint32_t stored(std::size_t servo, std::uint16_t address, std::size_t size) const;
  void store(std::size_t servo, std::uint16_t address, std::size_t size, std::uint32_t value);

  /// How many instructions have written to the EEPROM, which endures few.
  std::size_t eeprom_writes() const { return eeprom_writes_; }

 protected:
  using Span = std::span<const std::uint8_t>;
  using Instruction = wire::PacketInstruction;
  struct Servo {
    std::array<std::uint8_t, 256> memory{};
    std::array<std::uint8_t, 256> kept{};  // the EEPROM, which may differ while it is locked
    std::vector<std::uint8_t> registered;  // address and data of a reg write
    double ramp = 0.0;                     // where its motion has arrived
    double speed = 0.0;                    // of the motion in steps/s; 0: a step
    double away_until = 0.0;               // it boots
    bool silent = false;
  };

  /// With `echo`, the line returns everything that it receives, as adapters with one wire for both
  /// directions do.
  ServoChain(const ServoMemory& layout, std::size_t servos, bool echo,
             std::unique_ptr<wire::PacketWriter> writer,
             std::unique_ptr<wire::PacketDecoder> decoder);

  std::uint32_t number(Span bytes) const;
  std::uint32_t number(const Servo& servo, std::uint16_t address, std::size_t size) const;
  void boot(Servo& servo) const;
  void reboot(Servo& servo) const;
  std::uint8_t write(Servo& servo, Span address_and_data);
  void answer(const Servo& servo, Instruction to, std::uint8_t error, Span data);
  void answer_read(const Servo& servo, Instruction to, Span address_and_size);

  std::vector<Servo> servos_;

 private:
  struct Answer {
    double time;
    std::vector<std::uint8_t> bytes;
  };

  /// Obeys an instruction that is neither a sync read nor a sync write.
  virtual void obey_single(Servo& servo, const wire::Packet& packet) = 0;

  /// Whether the servo is set to answer the instruction, and the error bits of its answers.
  virtual bool answers(const Servo& servo, Instruction to) const = 0;
  virtual std::uint8_t error_bits(const Servo& servo) const = 0;

  /// The error number of a write that is refused.
  virtual std::uint8_t refusal(const Servo&, std::size_t, Span) const { return 0; }
  virtual void write_byte(Servo& servo, std::size_t address, std::uint8_t value) const = 0;

  /// Sets the numbers that are not 0 in the memory of a servo that was switched on.
  virtual void set_defaults(Servo& servo) const = 0;

  virtual double position(const Servo& servo, std::uint16_t address) const = 0;
  virtual double limited_goal(const Servo& servo) const { return position(servo, layout_.goal); }
  virtual double speed(const Servo& servo, double way) const = 0;

  bool is_powered(const Servo& servo) const { return servo.memory[layout_.torque] == 1; }
  bool listens(const Servo& servo) const { return !servo.silent && now_ >= servo.away_until; }
  void obey(const wire::Packet& packet);
  void obey_sync_read(Span parameters);
  void obey_sync_write(Span parameters);

  ServoMemory layout_;
  bool echo_;
  double now_ = 0.0;
  double line_free_ = 0.0;  // when the last answer that is planned begins
  std::size_t eeprom_writes_ = 0;
  std::unique_ptr<wire::PacketWriter> writer_;
  std::unique_ptr<wire::PacketDecoder> decoder_;
  std::deque<Answer> answers_;
};

}  // namespace somato::emulation
