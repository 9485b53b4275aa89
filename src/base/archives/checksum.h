#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace somato {

/// CRC-32C (Castagnoli's polynomial 0x1EDC6F41, reflected, inverted before and after) of `bytes`.
/// It finds every change of up to three bits, and every burst of up to 32 bits, in the files we
/// write. Source: RFC 3720, appendix B.4.
std::uint32_t crc32c(std::string_view bytes);

/// CRC-32 (polynomial 0x04C11DB7, reflected, inverted before and after), as zlib and MCAP have it,
/// of bytes that come in pieces. Source: RFC 1952, section 8.
class Crc32 {
 public:
  void add(std::string_view bytes);
  std::uint32_t value() const { return ~remainder_; }

 private:
  std::uint32_t remainder_ = 0xFFFFFFFF;
};

/// The same for contiguous `bytes`.
std::uint32_t crc32(std::string_view bytes);

/// FNV-1a of 64 bits, of `bytes` that follow those with the hash `before`. It distinguishes
/// contents that differ by accident. Source: Fowler, Noll and Vo; IETF draft-eastlake-fnv.
constexpr std::uint64_t fnv1a64(std::string_view bytes,
                                std::uint64_t before = 0xCBF29CE484222325U) {
  for (const char c : bytes) before = (before ^ static_cast<std::uint8_t>(c)) * 0x100000001B3U;
  return before;
}

/// The name of a file with the content that a text describes, 16 hexadecimal digits.
std::string checksum_name(std::string_view text);

}  // namespace somato
