#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace somato::wire {

/// Instructions of the Dynamixel protocol 2 and of the Feetech SCS protocol, which have the same
/// numbers. Sources: ROBOTIS e-Manual, "DYNAMIXEL Protocol 2.0"; Feetech, "SCS communication
/// protocol".
enum class PacketInstruction : std::uint8_t {
  kPing = 0x01,
  kRead = 0x02,
  kWrite = 0x03,
  kRegWrite = 0x04,
  kAction = 0x05,
  kReboot = 0x08,    ///< Feetech: has no answer; not every servo knows it.
  kStatus = 0x55,    ///< Dynamixel: the answer of a servo.
  kSyncRead = 0x82,  ///< Feetech: only the STS series.
  kSyncWrite = 0x83,
};

/// The id that addresses all servos.
inline constexpr std::uint8_t kEveryone = 0xFE;

/// The order of the bytes of a number.
enum class ByteOrder { kLowFirst, kHighFirst };

/// Writes packets one after the other into memory of the caller, without allocation. Each function
/// throws InvalidArgument if the memory is too small or a packet longer than the protocol permits.
class PacketWriter {
 public:
  PacketWriter(const PacketWriter&) = delete;
  PacketWriter(PacketWriter&&) = delete;
  PacketWriter& operator=(const PacketWriter&) = delete;
  PacketWriter& operator=(PacketWriter&&) = delete;
  virtual ~PacketWriter() = default;

  /// Begins anew, in other memory.
  void use(std::span<std::uint8_t> out);

  /// Parts of a packet: begin(), its parameters, end().
  void begin(std::uint8_t id, std::uint8_t code);
  void begin(std::uint8_t id, PacketInstruction instruction);
  virtual void put8(std::uint8_t value) { append(value); }
  void put16(std::uint16_t value) { put_number(value, 2); }
  void put32(std::uint32_t value) { put_number(value, 4); }
  void put(std::span<const std::uint8_t> bytes);
  void end();

  /// Complete packets. A sync write is continued by put8(id) and the data of each servo, then
  /// end().
  void ping(std::uint8_t id) { put_packet(id, PacketInstruction::kPing); }
  void read(std::uint8_t id, std::uint16_t address, std::uint16_t size);
  void write(std::uint8_t id, std::uint16_t address, std::span<const std::uint8_t> data);
  void reg_write(std::uint8_t id, std::uint16_t address, std::span<const std::uint8_t> data);
  void action(std::uint8_t id) { put_packet(id, PacketInstruction::kAction); }
  void reboot(std::uint8_t id) { put_packet(id, PacketInstruction::kReboot); }
  void sync_read(std::uint16_t address, std::uint16_t size, std::span<const std::uint8_t> ids);
  void begin_sync_write(std::uint16_t address, std::uint16_t size);
  virtual void status(std::uint8_t id, std::uint8_t error,
                      std::span<const std::uint8_t> parameters) = 0;

  /// All packets that were ended.
  std::span<const std::uint8_t> written() const { return out_.first(size_); }

 protected:
  /// The addresses and sizes of the protocol have `address_size` bytes.
  PacketWriter(std::span<std::uint8_t> out, ByteOrder order, std::size_t address_size)
      : out_(out), order_(order), address_size_(address_size) {}

  void append(std::uint8_t byte);

  /// The bytes since begin().
  std::span<std::uint8_t> packet() const { return out_.subspan(start_, next_ - start_); }

 private:
  virtual void append_header(std::uint8_t id) = 0;  // as far as the length, which is not known yet
  virtual void complete() = 0;                      // writes the length and appends the check
  void put_number(std::uint32_t value, std::size_t size);
  void put_packet(std::uint8_t id, PacketInstruction instruction);
  void begin_at(std::uint8_t id, PacketInstruction instruction, std::uint16_t address);
  void put_address(std::uint16_t value);

  std::span<std::uint8_t> out_;
  ByteOrder order_;
  std::size_t address_size_;
  std::size_t start_ = 0;  // of the packet that was begun
  std::size_t next_ = 0;
  std::size_t size_ = 0;
};

/// A packet. Of the host, it has an instruction; of a servo, an error and `parameters` after it.
/// The bytes of the Feetech protocol do not distinguish the two: both members have the same byte.
struct Packet {
  std::uint8_t id = 0;
  PacketInstruction instruction = PacketInstruction::kStatus;
  std::uint8_t error = 0;
  std::span<const std::uint8_t> parameters;
};

/// Finds the packets in a stream that may contain anything else: noise, damaged packets, and the
/// echo of the host's own instructions. Allocates nothing. A packet is valid until the next call.
class PacketDecoder {
 public:
  PacketDecoder() = default;
  PacketDecoder(const PacketDecoder&) = delete;
  PacketDecoder(PacketDecoder&&) = delete;
  PacketDecoder& operator=(const PacketDecoder&) = delete;
  PacketDecoder& operator=(PacketDecoder&&) = delete;
  virtual ~PacketDecoder() = default;

  virtual void put(std::span<const std::uint8_t> bytes) = 0;

  /// The packets that the host sends now: their echo, if there is one, is no answer.
  virtual void expect_echo(std::span<const std::uint8_t> /*sent*/) {}

  /// Forgets what was received, and which echo is expected.
  virtual void clear() = 0;

  /// The next answer of a servo.
  virtual std::optional<Packet> next_status() = 0;

  /// The next instruction of the host.
  virtual std::optional<Packet> next_instruction() = 0;
};

}  // namespace somato::wire
