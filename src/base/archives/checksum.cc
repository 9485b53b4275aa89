#include "base/archives/checksum.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>

namespace somato {
namespace {

constexpr std::uint32_t kReflectedCastagnoli = 0x82F63B78;
constexpr std::uint32_t kReflectedIeee = 0xEDB88320;

// Eight bytes at a time: their remainders do not wait for each other (Kounavis and Berry 2005).
constexpr std::size_t kSlices = 8;

// At [k][byte], the remainder of the byte with k zero bytes after it.
using Remainders = std::array<std::array<std::uint32_t, 256>, kSlices>;

constexpr Remainders remainders_of_bytes(std::uint32_t reflected_polynomial) {
  Remainders tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t remainder = byte;
    for (std::size_t slice = 0; slice < kSlices; ++slice) {
      for (int bit = 0; bit < 8; ++bit) {
        remainder = (remainder >> 1) ^ ((remainder & 1) ? reflected_polynomial : 0);
      }
      tables[slice][byte] = remainder;
    }
  }
  return tables;
}

constexpr Remainders kCastagnoli = remainders_of_bytes(kReflectedCastagnoli);
constexpr Remainders kIeee = remainders_of_bytes(kReflectedIeee);

// Bits 8 * byte to 8 * byte + 7.
constexpr std::size_t byte_of(std::uint32_t bits, int byte) {
  return (bits >> (8 * byte)) & 0xFF;
}

// Four bytes, the first of them lowest.
std::uint32_t word_at(std::string_view bytes, std::size_t place) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) {
    word = (word << 8) | static_cast<unsigned char>(bytes[place + i]);
  }
  return word;
}

std::uint32_t divided(const Remainders& tables, std::uint32_t remainder, std::string_view bytes) {
  std::size_t place = 0;
  for (; place + kSlices <= bytes.size(); place += kSlices) {
    const std::uint32_t low = remainder ^ word_at(bytes, place);
    const std::uint32_t high = word_at(bytes, place + 4);
    remainder = tables[7][byte_of(low, 0)] ^ tables[6][byte_of(low, 1)] ^
                tables[5][byte_of(low, 2)] ^ tables[4][byte_of(low, 3)] ^
                tables[3][byte_of(high, 0)] ^ tables[2][byte_of(high, 1)] ^
                tables[1][byte_of(high, 2)] ^ tables[0][byte_of(high, 3)];
  }
  for (; place < bytes.size(); ++place) {
    const std::uint32_t byte = static_cast<unsigned char>(bytes[place]);
    remainder = (remainder >> 8) ^ tables[0][byte_of(remainder ^ byte, 0)];
  }
  return remainder;
}

}  // namespace

std::uint32_t crc32c(std::string_view bytes) {
  return ~divided(kCastagnoli, 0xFFFFFFFF, bytes);
}

void Crc32::add(std::string_view bytes) {
  remainder_ = divided(kIeee, remainder_, bytes);
}

std::uint32_t crc32(std::string_view bytes) {
  Crc32 crc;
  crc.add(bytes);
  return crc.value();
}

std::string checksum_name(std::string_view text) {
  return fmt::format("{:08x}{:08x}", crc32c(text), crc32(text));
}

}  // namespace somato
