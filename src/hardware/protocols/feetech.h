#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hardware/lines/receive_buffer.h"

namespace somato::wire {

/// Instructions of the Feetech SCS protocol. Source: Feetech, "SCS communication protocol".
enum class FeetechInstruction : std::uint8_t {
  kPing = 0x01,
  kRead = 0x02,
  kWrite = 0x03,
  kRegWrite = 0x04,
  kAction = 0x05,
  kReboot = 0x08,    ///< Has no answer; not every servo knows it.
  kSyncRead = 0x82,  ///< Only the STS series.
  kSyncWrite = 0x83,
};

/// The id that addresses all servos; ids of servos are 0 to 253.
inline constexpr std::uint8_t kFeetechEveryone = 0xFE;

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

/// The order of the bytes of a number with two bytes.
enum class ByteOrder { kLowFirst, kHighFirst };

constexpr ByteOrder feetech_order(FeetechSeries series) {
  return series == FeetechSeries::kSts ? ByteOrder::kLowFirst : ByteOrder::kHighFirst;
}

/// Two bytes as a number, and back.
std::uint16_t feetech_word(std::span<const std::uint8_t> bytes, ByteOrder order);
std::array<std::uint8_t, 2> feetech_bytes(std::uint16_t word, ByteOrder order);

/// A number with its sign in the highest bit, and back; `value` within +-32767.
int feetech_signed(std::uint16_t word);
std::uint16_t feetech_unsigned(int value);

/// Writes packets one after the other into memory of the caller, without allocation. Each function
/// throws InvalidArgument if the memory is too small or a packet longer than the protocol permits.
class FeetechWriter {
 public:
  FeetechWriter(std::span<std::uint8_t> out, ByteOrder order) : out_(out), order_(order) {}

  /// Parts of a packet: begin(), its parameters, end().
  void begin(std::uint8_t id, std::uint8_t code);
  void put8(std::uint8_t value);
  void put16(std::uint16_t value);
  void put(std::span<const std::uint8_t> bytes);
  void end();

  /// Complete packets. A sync write is continued by put8(id) and the data of each servo, then
  /// end().
  void ping(std::uint8_t id);
  void read(std::uint8_t id, std::uint8_t address, std::uint8_t size);
  void write(std::uint8_t id, std::uint8_t address, std::span<const std::uint8_t> data);
  void reg_write(std::uint8_t id, std::uint8_t address, std::span<const std::uint8_t> data);
  void action(std::uint8_t id);
  void reboot(std::uint8_t id);
  void sync_read(std::uint8_t address, std::uint8_t size, std::span<const std::uint8_t> ids);
  void begin_sync_write(std::uint8_t address, std::uint8_t size);
  void status(std::uint8_t id, std::uint8_t error, std::span<const std::uint8_t> parameters);

  /// All packets that were ended.
  std::span<const std::uint8_t> written() const { return out_.first(size_); }

 private:
  void begin(std::uint8_t id, FeetechInstruction instruction);

  std::span<std::uint8_t> out_;
  ByteOrder order_;
  std::size_t start_ = 0;  // of the packet that was begun
  std::size_t next_ = 0;
  std::size_t size_ = 0;
};

/// A packet: of the host, `code` is an instruction; of a servo, its error bits. The bytes do
/// not distinguish the two.
struct FeetechPacket {
  std::uint8_t id = 0;
  std::uint8_t code = 0;
  std::span<const std::uint8_t> parameters;
};

/// Finds the packets in a stream that may contain anything else: noise, damaged packets, and the
/// echo of the host's own instructions. Allocates nothing. The protocol protects a packet by a sum
/// of 8 bits only: of the packets that lack a byte, about 1 in 256 is accepted, with wrong
/// content; all that lack a byte 255 are, if another packet follows at once. A user should
/// therefore accept only what can be the answer to the last request.
class FeetechDecoder {
 public:
  /// The longest packet of the protocol, in bytes.
  static constexpr std::size_t kLongest = 4 + 0xFF;

  /// Packets of servos that are longer than `longest` bytes are taken for damage, so that a wrong
  /// length does not hide the packets that follow.
  explicit FeetechDecoder(std::size_t longest = kLongest) : longest_(longest) {}

  void put(std::span<const std::uint8_t> bytes);

  /// The packets that the host sends now: their echo, if there is one, is skipped.
  void expect_echo(std::span<const std::uint8_t> sent);

  /// Forgets what was received, and which echo is expected.
  void clear();

  /// The next packet that is no echo. It is valid until the next call.
  std::optional<FeetechPacket> next();

 private:
  std::optional<std::size_t> complete();
  bool skip_echo(std::size_t size);

  ReceiveBuffer<8 * kLongest> buffer_;
  ReceiveBuffer<8 * kLongest> echo_;
  std::array<std::uint8_t, kLongest> body_{};
  std::size_t longest_;
};

}  // namespace somato::wire
