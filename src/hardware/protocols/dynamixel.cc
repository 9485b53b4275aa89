#include "hardware/protocols/dynamixel.h"

#include <algorithm>

#include "somato/core/check.h"

namespace somato::wire {
namespace {

constexpr std::size_t kDynamixelHeaderSize = 4;  // FF FF FD 00
constexpr std::size_t kDynamixelBody = 7;        // after header, id and length
constexpr std::size_t kDynamixelCrcSize = 2;
constexpr std::array<std::uint8_t, kDynamixelHeaderSize> kDynamixelHeader{0xFF, 0xFF, 0xFD, 0x00};

constexpr std::array<std::uint16_t, 256> dynamixel_crc_table() {
  std::array<std::uint16_t, 256> table{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    unsigned crc = byte << 8;
    for (int bit = 0; bit < 8; ++bit) crc = (crc << 1) ^ ((crc & 0x8000) != 0 ? 0x8005U : 0U);
    table[byte] = static_cast<std::uint16_t>(crc);
  }
  return table;
}

constexpr std::array<std::uint16_t, 256> kDynamixelCrcTable = dynamixel_crc_table();

// Whether the three bytes before `end` must be followed by a stuffing byte.
bool needs_stuffing(std::span<const std::uint8_t> body) {
  const std::size_t size = body.size();
  return size >= 3 && body[size - 1] == 0xFD && body[size - 2] == 0xFF && body[size - 3] == 0xFF;
}

// Where a header begins in `bytes`, at the earliest `from`; one that is cut off by the end counts.
std::size_t find_dynamixel_header(std::span<const std::uint8_t> bytes, std::size_t from) {
  for (; from < bytes.size(); ++from) {
    const auto rest =
        bytes.subspan(from).first(std::min(kDynamixelHeaderSize, bytes.size() - from));
    if (std::equal(rest.begin(), rest.end(), kDynamixelHeader.begin())) break;
  }
  return from;
}

// A body never contains a header, because of the stuffing: one that does was cut off.
bool contains_dynamixel_header(std::span<const std::uint8_t> body) {
  return std::search(body.begin(), body.end(), kDynamixelHeader.begin(), kDynamixelHeader.end()) !=
         body.end();
}

}  // namespace

std::uint16_t dynamixel_crc(std::span<const std::uint8_t> bytes) {
  unsigned crc = 0;
  for (const std::uint8_t byte : bytes) {
    crc = ((crc << 8) ^ kDynamixelCrcTable[((crc >> 8) ^ byte) & 0xFF]) & 0xFFFF;
  }
  return static_cast<std::uint16_t>(crc);
}

void DynamixelWriter::append(std::uint8_t byte) {
  require(next_ < out_.size(), "the packet needs more memory");
  out_[next_++] = byte;
}

void DynamixelWriter::begin(std::uint8_t id, DynamixelInstruction instruction) {
  start_ = next_ = size_;
  for (const std::uint8_t byte : kDynamixelHeader) append(byte);
  append(id);
  append(0);  // the length, which end() knows
  append(0);
  append(static_cast<std::uint8_t>(instruction));
}

void DynamixelWriter::put8(std::uint8_t value) {
  append(value);
  const std::size_t body = start_ + kDynamixelBody;
  if (needs_stuffing(out_.subspan(body, next_ - body))) append(0xFD);
}

void DynamixelWriter::put16(std::uint16_t value) {
  put8(static_cast<std::uint8_t>(value & 0xFF));
  put8(static_cast<std::uint8_t>(value >> 8));
}

void DynamixelWriter::put32(std::uint32_t value) {
  put16(static_cast<std::uint16_t>(value & 0xFFFF));
  put16(static_cast<std::uint16_t>(value >> 16));
}

void DynamixelWriter::put(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) put8(byte);
}

void DynamixelWriter::end() {
  const std::size_t length = next_ - start_ - kDynamixelBody + kDynamixelCrcSize;
  require(length <= 0xFFFF, "the packet is too long");
  out_[start_ + 5] = static_cast<std::uint8_t>(length & 0xFF);
  out_[start_ + 6] = static_cast<std::uint8_t>(length >> 8);
  const std::uint16_t crc = dynamixel_crc(out_.subspan(start_, next_ - start_));
  append(static_cast<std::uint8_t>(crc & 0xFF));
  append(static_cast<std::uint8_t>(crc >> 8));
  size_ = next_;
}

void DynamixelWriter::ping(std::uint8_t id) {
  begin(id, DynamixelInstruction::kPing);
  end();
}

void DynamixelWriter::read(std::uint8_t id, std::uint16_t address, std::uint16_t size) {
  begin(id, DynamixelInstruction::kRead);
  put16(address);
  put16(size);
  end();
}

void DynamixelWriter::write(std::uint8_t id, std::uint16_t address,
                            std::span<const std::uint8_t> data) {
  begin(id, DynamixelInstruction::kWrite);
  put16(address);
  put(data);
  end();
}

void DynamixelWriter::reg_write(std::uint8_t id, std::uint16_t address,
                                std::span<const std::uint8_t> data) {
  begin(id, DynamixelInstruction::kRegWrite);
  put16(address);
  put(data);
  end();
}

void DynamixelWriter::action(std::uint8_t id) {
  begin(id, DynamixelInstruction::kAction);
  end();
}

void DynamixelWriter::reboot(std::uint8_t id) {
  begin(id, DynamixelInstruction::kReboot);
  end();
}

void DynamixelWriter::sync_read(std::uint16_t address, std::uint16_t size,
                                std::span<const std::uint8_t> ids) {
  begin(kDynamixelEveryone, DynamixelInstruction::kSyncRead);
  put16(address);
  put16(size);
  put(ids);
  end();
}

void DynamixelWriter::begin_sync_write(std::uint16_t address, std::uint16_t size) {
  begin(kDynamixelEveryone, DynamixelInstruction::kSyncWrite);
  put16(address);
  put16(size);
}

void DynamixelWriter::status(std::uint8_t id, std::uint8_t error,
                             std::span<const std::uint8_t> parameters) {
  begin(id, DynamixelInstruction::kStatus);
  put8(error);
  put(parameters);
  end();
}

void DynamixelDecoder::put(std::span<const std::uint8_t> bytes) {
  buffer_.put(bytes);
}

std::optional<DynamixelPacket> DynamixelDecoder::next_status() {
  for (;;) {
    const auto packet = next();
    if (!packet || packet->instruction == DynamixelInstruction::kStatus) return packet;
  }
}

std::optional<DynamixelPacket> DynamixelDecoder::next_instruction() {
  for (;;) {
    const auto packet = next();
    if (!packet || packet->instruction != DynamixelInstruction::kStatus) return packet;
  }
}

std::optional<DynamixelPacket> DynamixelDecoder::next() {
  for (;;) {
    buffer_.drop(find_dynamixel_header(buffer_.bytes(), 0));
    const auto bytes = buffer_.bytes();
    if (bytes.size() < kDynamixelBody) return std::nullopt;
    const std::size_t length = bytes[5] | static_cast<std::size_t>(bytes[6]) << 8;
    const std::size_t size = kDynamixelBody + length;
    const bool possible = length >= 3 && size <= kLongest && bytes[4] != 0xFD && bytes[4] != 0xFF;
    const std::size_t body =
        possible ? std::min(length - kDynamixelCrcSize, bytes.size() - kDynamixelBody) : 0;
    if (!possible || contains_dynamixel_header(bytes.subspan(kDynamixelBody, body))) {
      buffer_.drop(1);
    } else if (bytes.size() < size) {
      return std::nullopt;
    } else if (const auto packet = take(size)) {
      return packet;
    }
  }
}

// The packet of `size` bytes at the beginning of the buffer, if its CRC is right.
std::optional<DynamixelPacket> DynamixelDecoder::take(std::size_t size) {
  const auto bytes = buffer_.bytes().first(size);
  const unsigned crc = bytes[size - 2] | static_cast<unsigned>(bytes[size - 1]) << 8;
  if (dynamixel_crc(bytes.first(size - kDynamixelCrcSize)) != crc) {
    buffer_.drop(1);
    return std::nullopt;
  }
  DynamixelPacket packet;
  packet.id = bytes[4];
  std::size_t count = 0;
  const auto body = bytes.subspan(kDynamixelBody, size - kDynamixelBody - kDynamixelCrcSize);
  for (std::size_t i = 0; i < body.size(); ++i) {
    body_[count++] = body[i];
    const bool more = i + 1 < body.size() && body[i + 1] == 0xFD;
    if (more && needs_stuffing(body.first(i + 1))) ++i;  // the byte that follows is stuffing
  }
  buffer_.drop(size);
  packet.instruction = static_cast<DynamixelInstruction>(body_[0]);
  packet.parameters = std::span<const std::uint8_t>(body_).subspan(1, count - 1);
  if (packet.instruction != DynamixelInstruction::kStatus) return packet;
  if (count < 2) return std::nullopt;  // a status without an error is none
  packet.error = body_[1];
  packet.parameters = packet.parameters.subspan(1);
  return packet;
}

}  // namespace somato::wire
