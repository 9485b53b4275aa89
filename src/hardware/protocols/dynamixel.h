#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hardware/lines/receive_buffer.h"
#include "hardware/protocols/packets.h"

namespace somato::wire {

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

/// Writes packets of the Dynamixel protocol 2; ids of servos are 0 to 252.
class DynamixelWriter : public PacketWriter {
 public:
  explicit DynamixelWriter(std::span<std::uint8_t> out = {})
      : PacketWriter(out, ByteOrder::kLowFirst, 2) {}

  void put8(std::uint8_t value) override;  // with a stuffing byte if it is needed
  void status(std::uint8_t id, std::uint8_t error,
              std::span<const std::uint8_t> parameters) override;

 private:
  void append_header(std::uint8_t id) override;
  void complete() override;
};

/// Finds packets of the Dynamixel protocol 2, and removes the stuffing. The error of a status is an
/// error number and the bit kAlert.
class DynamixelDecoder : public PacketDecoder {
 public:
  /// The longest packet that it accepts, in bytes; a larger length is taken for damage.
  static constexpr std::size_t kLongest = 1024;

  void put(std::span<const std::uint8_t> bytes) override { buffer_.put(bytes); }
  void clear() override { buffer_.clear(); }
  std::optional<Packet> next_status() override;       // skips instructions, as in an echo
  std::optional<Packet> next_instruction() override;  // skips answers, as of other servos

 private:
  std::optional<Packet> next();
  std::optional<Packet> take(std::size_t size);

  ReceiveBuffer<2 * kLongest> buffer_;
  std::array<std::uint8_t, kLongest> body_{};  // instruction and parameters, without stuffing
};

}  // namespace somato::wire
