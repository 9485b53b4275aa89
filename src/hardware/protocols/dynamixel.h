#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hardware/lines/receive_buffer.h"

namespace somato::wire {

/// Instructions of the Dynamixel protocol 2. Source: ROBOTIS e-Manual, "DYNAMIXEL Protocol 2.0".
enum class DynamixelInstruction : std::uint8_t {
  kPing = 0x01,
  kRead = 0x02,
  kWrite = 0x03,
  kRegWrite = 0x04,
  kAction = 0x05,
  kReboot = 0x08,
  kStatus = 0x55,  ///< The answer of a servo.
  kSyncRead = 0x82,
  kSyncWrite = 0x83,
};

/// The id that addresses all servos; ids of servos are 0 to 252.
inline constexpr std::uint8_t kDynamixelEveryone = 0xFE;

/// Error numbers in the status of a servo, and the bit that announces a hardware error.
namespace dynamixel_error {
inline constexpr std::uint8_t kResult = 1;
inline constexpr std::uint8_t kInstruction = 2;
inline constexpr std::uint8_t kRange = 4;
inline constexpr std::uint8_t kLength = 5;
inline constexpr std::uint8_t kLimit = 6;
inline constexpr std::uint8_t kAccess = 7;
inline constexpr std::uint8_t kAlert = 0x80;
}  // namespace dynamixel_error

/// Addresses in the control table. Numbers are stored with the low byte first. Source: ROBOTIS
/// e-Manual, X series.
namespace dynamixel_x {
inline constexpr std::uint16_t kModelNumber = 0;        // 2 bytes
inline constexpr std::uint16_t kFirmware = 6;           // 1
inline constexpr std::uint16_t kId = 7;                 // 1
inline constexpr std::uint16_t kReturnDelay = 9;        // 1, unit 2 us
inline constexpr std::uint16_t kDriveMode = 10;         // 1
inline constexpr std::uint16_t kOperatingMode = 11;     // 1
inline constexpr std::uint16_t kVelocityLimit = 44;     // 4
inline constexpr std::uint16_t kMaxPosition = 48;       // 4
inline constexpr std::uint16_t kMinPosition = 52;       // 4
inline constexpr std::uint16_t kShutdown = 63;          // 1; the last of the EEPROM
inline constexpr std::uint16_t kTorqueEnable = 64;      // 1
inline constexpr std::uint16_t kStatusReturn = 68;      // 1
inline constexpr std::uint16_t kHardwareError = 70;     // 1
inline constexpr std::uint16_t kAcceleration = 108;     // 4, Profile Acceleration
inline constexpr std::uint16_t kVelocity = 112;         // 4, Profile Velocity
inline constexpr std::uint16_t kGoalPosition = 116;     // 4
inline constexpr std::uint16_t kPresentCurrent = 126;   // 2; velocity (4) and position (4) follow
inline constexpr std::uint16_t kPresentPosition = 132;  // 4
inline constexpr std::uint16_t kPresentTemperature = 146;  // 1, degrees Celsius
inline constexpr std::uint8_t kOverload = 0x20;            // bit of kHardwareError and kShutdown
inline constexpr std::uint8_t kTimeBasedProfile = 0x04;    // bits of kDriveMode
inline constexpr std::uint8_t kTorqueOnByGoal = 0x08;
/// Steps in a second for one unit of kVelocity: 0.229 revolutions of 4096 steps in a minute.
inline constexpr double kVelocityUnit = 0.229 * 4096.0 / 60.0;
}  // namespace dynamixel_x

/// CRC-16 of the protocol: polynomial 0x8005, from the highest bit, starting with 0.
std::uint16_t dynamixel_crc(std::span<const std::uint8_t> bytes);

/// Writes packets one after the other into memory of the caller, without allocation. Each function
/// throws InvalidArgument if the memory is too small.
class DynamixelWriter {
 public:
  explicit DynamixelWriter(std::span<std::uint8_t> out) : out_(out) {}

  /// Parts of a packet: begin(), its parameters, end().
  void begin(std::uint8_t id, DynamixelInstruction instruction);
  void put8(std::uint8_t value);
  void put16(std::uint16_t value);
  void put32(std::uint32_t value);
  void put(std::span<const std::uint8_t> bytes);
  void end();

  /// Complete packets. A sync write is continued by put8(id) and the data of each servo, then
  /// end().
  void ping(std::uint8_t id);
  void read(std::uint8_t id, std::uint16_t address, std::uint16_t size);
  void write(std::uint8_t id, std::uint16_t address, std::span<const std::uint8_t> data);
  void reg_write(std::uint8_t id, std::uint16_t address, std::span<const std::uint8_t> data);
  void action(std::uint8_t id);
  void reboot(std::uint8_t id);
  void sync_read(std::uint16_t address, std::uint16_t size, std::span<const std::uint8_t> ids);
  void begin_sync_write(std::uint16_t address, std::uint16_t size);
  void status(std::uint8_t id, std::uint8_t error, std::span<const std::uint8_t> parameters);

  /// All packets that were ended.
  std::span<const std::uint8_t> written() const { return out_.first(size_); }

 private:
  void append(std::uint8_t byte);

  std::span<std::uint8_t> out_;
  std::size_t start_ = 0;  // of the packet that was begun
  std::size_t next_ = 0;
  std::size_t size_ = 0;
};

/// A packet without stuffing. `parameters` of a status begin after its error.
struct DynamixelPacket {
  std::uint8_t id = 0;
  DynamixelInstruction instruction = DynamixelInstruction::kStatus;
  std::uint8_t error = 0;  ///< The error of a status: an error number and the bit kAlert.
  std::span<const std::uint8_t> parameters;
};

/// Finds the packets in a stream that may contain anything else: noise, damaged packets, and the
/// echo of the host's own instructions. Allocates nothing.
class DynamixelDecoder {
 public:
  /// The longest packet that it accepts, in bytes; a larger length is taken for damage.
  static constexpr std::size_t kLongest = 1024;

  void put(std::span<const std::uint8_t> bytes);
  void clear() { buffer_.clear(); }

  /// The next answer of a servo; instructions, as in an echo, are skipped. The packet is valid
  /// until the next call.
  std::optional<DynamixelPacket> next_status();

  /// The next instruction; answers, as of other servos, are skipped.
  std::optional<DynamixelPacket> next_instruction();

 private:
  std::optional<DynamixelPacket> next();
  std::optional<DynamixelPacket> take(std::size_t size);

  ReceiveBuffer<2 * kLongest> buffer_;
  std::array<std::uint8_t, kLongest> body_{};  // instruction and parameters, without stuffing
};

}  // namespace somato::wire
