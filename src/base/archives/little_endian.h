#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace somato {

/// The unsigned integer that is as wide as T.
template <typename T>
using Bits = std::conditional_t<
    sizeof(T) == 1, std::uint8_t,
    std::conditional_t<sizeof(T) == 2, std::uint16_t,
                       std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;

/// The number in the first bytes, least significant byte first; `bytes` must be long enough.
template <typename T>
T little_endian(const char* bytes) {
  Bits<T> bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bits = static_cast<Bits<T>>(bits | Bits<T>{static_cast<unsigned char>(bytes[i])} << (8 * i));
  }
  return std::bit_cast<T>(bits);
}

/// The same for big-endian order.
template <typename T>
T big_endian(const char* bytes) {
  char turned[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) turned[i] = bytes[sizeof(T) - 1 - i];
  return little_endian<T>(turned);
}

/// Appends `number`, least significant byte first.
template <typename T>
void append_little_endian(std::string& bytes, T number) {
  const auto bits = std::bit_cast<Bits<T>>(number);
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xFF);
}

}  // namespace somato
