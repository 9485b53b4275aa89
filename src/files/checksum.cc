#include "somato/files/checksum.h"

#include <array>

namespace somato {
namespace {

constexpr std::uint32_t kReflectedCastagnoli = 0x82F63B78;
constexpr std::uint32_t kReflectedIeee = 0xEDB88320;

using Remainders = std::array<std::uint32_t, 256>;

constexpr Remainders remainders_of_bytes(std::uint32_t reflected_polynomial) {
  Remainders table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t remainder = byte;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder >> 1) ^ ((remainder & 1) ? reflected_polynomial : 0);
    }
    table[byte] = remainder;
  }
  return table;
}

constexpr Remainders kCastagnoli = remainders_of_bytes(kReflectedCastagnoli);
constexpr Remainders kIeee = remainders_of_bytes(kReflectedIeee);

std::uint32_t divided(const Remainders& table, std::uint32_t remainder, std::string_view bytes) {
  for (const char c : bytes) {
    const std::uint32_t index = (remainder ^ static_cast<unsigned char>(c)) & 0xFF;
    remainder = (remainder >> 8) ^ table[index];
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

}  // namespace somato
