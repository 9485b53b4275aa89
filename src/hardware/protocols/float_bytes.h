#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace somato::wire {

/// Writes the `bytes.size()` lowest bytes of `value`, the lowest first.
inline void put_little_endian(std::uint32_t value, std::span<std::uint8_t> bytes) {
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(value);
    value >>= 8;
  }
}

/// The number whose bytes, the lowest first, are `bytes`, at most 4.
inline std::uint32_t little_endian(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes.size(); i > 0; --i) value = (value << 8) | bytes[i - 1];
  return value;
}

/// The same for an IEEE 754 number of 4 bytes.
inline void put_float(float value, std::span<std::uint8_t, 4> bytes) {
  put_little_endian(std::bit_cast<std::uint32_t>(value), bytes);
}

inline float float_of(std::span<const std::uint8_t, 4> bytes) {
  return std::bit_cast<float>(little_endian(bytes));
}

}  // namespace somato::wire
