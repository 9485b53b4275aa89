#pragma once

#include <cstdint>
#include <span>

namespace somato::wire {

/// CRC-32 (polynomial 0x04C11DB7, reflected, inverted before and after). Source: RFC 1952,
/// section 8.
std::uint32_t crc32(std::span<const std::uint8_t> bytes);

}  // namespace somato::wire
