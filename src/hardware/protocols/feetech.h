#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hardware/lines/receive_buffer.h"
#include "hardware/protocols/packets.h"

namespace somato::wire {

/// Addresses in the memory of a servo. Source: Feetech, memory tables of the STS and SCSCL series.
namespace feetech {
inline constexpr std::uint8_t kModel = 3;             // 2 bytes
inline constexpr std::uint8_t kId = 5;                // 1
inline constexpr std::uint8_t kReturnDelay = 7;       // 1, unit 2 us
inline constexpr std::uint8_t kResponseLevel = 8;     // 1; 0: only ping and read are answered
inline constexpr std::uint8_t kMinPosition = 9;       // 2
inline constexpr std::uint8_t kMaxPosition = 11;      // 2
inline constexpr std::uint8_t kMode = 33;             // 1, only STS; 0: position
inline constexpr std::uint8_t kTorqueEnable = 40;     // 1; the first after the EEPROM
inline constexpr std::uint8_t kAcceleration = 41;     // 1, only STS; unit 100 steps/s^2, 0: highest
inline constexpr std::uint8_t kGoalPosition = 42;     // 2
inline constexpr std::uint8_t kGoalTime = 44;         // 2, ms
inline constexpr std::uint8_t kGoalSpeed = 46;        // 2, steps/s
inline constexpr std::uint8_t kLockScs = 48;          // 1; 0: the EEPROM keeps what is written
inline constexpr std::uint8_t kLockSts = 55;          // 1
inline constexpr std::uint8_t kPresentPosition = 56;  // 2; speed (2) and load (2) follow
inline constexpr std::uint8_t kPresentTemperature = 63;  // 1, degrees Celsius
inline constexpr std::uint8_t kStatus = 65;              // 1, the error bits
inline constexpr std::uint8_t kPresentCurrent = 69;      // 2, only STS
inline constexpr std::uint8_t kOverload = 0x20;          // bit of kStatus
inline constexpr double kCurrentUnit = 6.5;              // mA
inline constexpr std::uint16_t kNegative = 0x8000;       // sign of positions and currents
}  // namespace feetech

/// The series differ in some addresses, and in the order of bytes.
enum class FeetechSeries {
  kSts,  ///< And SMS: with a magnetic encoder of 4096 steps in a turn.
  kScs,  ///< With a potentiometer of 1024 steps.
};

constexpr ByteOrder feetech_order(FeetechSeries series) {
  return series == FeetechSeries::kSts ? ByteOrder::kLowFirst : ByteOrder::kHighFirst;
}

/// Two bytes as a number.
std::uint16_t feetech_word(std::span<const std::uint8_t> bytes, ByteOrder order);

/// A number with its sign in the highest bit, and back; `value` within +-32767.
int feetech_signed(std::uint16_t word);
std::uint16_t feetech_unsigned(int value);

/// Writes packets of the Feetech SCS protocol; ids of servos are 0 to 253.
class FeetechWriter : public PacketWriter {
 public:
  explicit FeetechWriter(ByteOrder order) : FeetechWriter({}, order) {}
  FeetechWriter(std::span<std::uint8_t> out, ByteOrder order) : PacketWriter(out, order, 1) {}

  void status(std::uint8_t id, std::uint8_t error,
              std::span<const std::uint8_t> parameters) override;

 private:
  void append_header(std::uint8_t id) override;
  void complete() override;
};

/// Finds packets of the Feetech SCS protocol, which protects a packet by a sum of 8 bits only: of
/// the packets that lack a byte, about 1 in 256 is accepted, with wrong content; all that lack a
/// byte 255 are, if another packet follows at once. A user should therefore accept only what can be
/// the answer to the last request.
class FeetechDecoder : public PacketDecoder {
 public:
  /// The longest packet of the protocol, in bytes.
  static constexpr std::size_t kLongest = 4 + 0xFF;

  /// Packets of servos that are longer than `longest` bytes are taken for damage, so that a wrong
  /// length does not hide the packets that follow.
  explicit FeetechDecoder(std::size_t longest = kLongest) : longest_(longest) {}

  void put(std::span<const std::uint8_t> bytes) override { buffer_.put(bytes); }

  void expect_echo(std::span<const std::uint8_t> sent) override;
  void clear() override;

  /// The next packet that is no echo.
  std::optional<Packet> next();
  std::optional<Packet> next_status() override { return next(); }
  std::optional<Packet> next_instruction() override { return next(); }

 private:
  std::optional<std::size_t> complete();
  bool skip_echo(std::size_t size);

  ReceiveBuffer<8 * kLongest> buffer_;
  ReceiveBuffer<8 * kLongest> echo_;
  std::array<std::uint8_t, kLongest> body_{};
  std::size_t longest_;
};

}  // namespace somato::wire
