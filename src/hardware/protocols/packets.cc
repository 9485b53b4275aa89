#include "hardware/protocols/packets.h"

#include "somato/core/check.h"

namespace somato::wire {

void PacketWriter::use(std::span<std::uint8_t> out) {
  out_ = out;
  start_ = next_ = size_ = 0;
}

void PacketWriter::append(std::uint8_t byte) {
  require(next_ < out_.size(), "the packet needs more memory");
  out_[next_++] = byte;
}

void PacketWriter::begin(std::uint8_t id, std::uint8_t code) {
  start_ = next_ = size_;
  append_header(id);
  append(code);
}

void PacketWriter::begin(std::uint8_t id, PacketInstruction instruction) {
  begin(id, static_cast<std::uint8_t>(instruction));
}

void PacketWriter::put_number(std::uint32_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t byte = order_ == ByteOrder::kLowFirst ? i : size - 1 - i;
    put8(static_cast<std::uint8_t>(value >> 8 * byte & 0xFF));
  }
}

void PacketWriter::put(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) put8(byte);
}

void PacketWriter::end() {
  complete();
  size_ = next_;
}

void PacketWriter::put_address(std::uint16_t value) {
  require(address_size_ == 2 || value <= 0xFF, "an address or a size has one byte");
  put_number(value, address_size_);
}

void PacketWriter::begin_at(std::uint8_t id, PacketInstruction instruction, std::uint16_t address) {
  begin(id, instruction);
  put_address(address);
}

void PacketWriter::put_packet(std::uint8_t id, PacketInstruction instruction) {
  begin(id, instruction);
  end();
}

void PacketWriter::read(std::uint8_t id, std::uint16_t address, std::uint16_t size) {
  begin_at(id, PacketInstruction::kRead, address);
  put_address(size);
  end();
}

void PacketWriter::write(std::uint8_t id, std::uint16_t address,
                         std::span<const std::uint8_t> data) {
  begin_at(id, PacketInstruction::kWrite, address);
  put(data);
  end();
}

void PacketWriter::reg_write(std::uint8_t id, std::uint16_t address,
                             std::span<const std::uint8_t> data) {
  begin_at(id, PacketInstruction::kRegWrite, address);
  put(data);
  end();
}

void PacketWriter::sync_read(std::uint16_t address, std::uint16_t size,
                             std::span<const std::uint8_t> ids) {
  begin_at(kEveryone, PacketInstruction::kSyncRead, address);
  put_address(size);
  put(ids);
  end();
}

void PacketWriter::begin_sync_write(std::uint16_t address, std::uint16_t size) {
  begin_at(kEveryone, PacketInstruction::kSyncWrite, address);
  put_address(size);
}

}  // namespace somato::wire
