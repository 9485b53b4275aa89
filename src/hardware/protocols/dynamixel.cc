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

void DynamixelWriter::append_header(std::uint8_t id) {
  for (const std::uint8_t byte : kDynamixelHeader) append(byte);
  append(id);
  append(0);
  append(0);
}

void DynamixelWriter::put8(std::uint8_t value) {
  append(value);
  if (needs_stuffing(packet().subspan(kDynamixelBody))) append(0xFD);
}

void DynamixelWriter::complete() {
  const auto bytes = packet();
  const std::size_t length = bytes.size() - kDynamixelBody + kDynamixelCrcSize;
  require(length <= 0xFFFF, "the packet is too long");
  bytes[5] = static_cast<std::uint8_t>(length & 0xFF);
  bytes[6] = static_cast<std::uint8_t>(length >> 8);
  const std::uint16_t crc = dynamixel_crc(bytes);
  append(static_cast<std::uint8_t>(crc & 0xFF));
  append(static_cast<std::uint8_t>(crc >> 8));
}

void DynamixelWriter::status(std::uint8_t id, std::uint8_t error,
                             std::span<const std::uint8_t> parameters) {
  begin(id, PacketInstruction::kStatus);
  put8(error);
  put(parameters);
  end();
}

std::optional<Packet> DynamixelDecoder::next_status() {
  for (;;) {
    const auto packet = next();
    if (!packet || packet->instruction == PacketInstruction::kStatus) return packet;
  }
}

std::optional<Packet> DynamixelDecoder::next_instruction() {
  for (;;) {
    const auto packet = next();
    if (!packet || packet->instruction != PacketInstruction::kStatus) return packet;
  }
}

std::optional<Packet> DynamixelDecoder::next() {
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
std::optional<Packet> DynamixelDecoder::take(std::size_t size) {
  const auto bytes = buffer_.bytes().first(size);
  const unsigned crc = bytes[size - 2] | static_cast<unsigned>(bytes[size - 1]) << 8;
  if (dynamixel_crc(bytes.first(size - kDynamixelCrcSize)) != crc) {
    buffer_.drop(1);
    return std::nullopt;
  }
  Packet packet;
  packet.id = bytes[4];
  std::size_t count = 0;
  const auto body = bytes.subspan(kDynamixelBody, size - kDynamixelBody - kDynamixelCrcSize);
  for (std::size_t i = 0; i < body.size(); ++i) {
    body_[count++] = body[i];
    const bool more = i + 1 < body.size() && body[i + 1] == 0xFD;
    if (more && needs_stuffing(body.first(i + 1))) ++i;  // the byte that follows is stuffing
  }
  buffer_.drop(size);
  packet.instruction = static_cast<PacketInstruction>(body_[0]);
  packet.parameters = std::span<const std::uint8_t>(body_).subspan(1, count - 1);
  if (packet.instruction != PacketInstruction::kStatus) return packet;
  if (count < 2) return std::nullopt;  // a status without an error is none
  packet.error = body_[1];
  packet.parameters = packet.parameters.subspan(1);
  return packet;
}

}  // namespace somato::wire
