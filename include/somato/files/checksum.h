#pragma once

#include <cstdint>
#include <string_view>

namespace somato {

/// CRC-32C (Castagnoli's polynomial 0x1EDC6F41, reflected, inverted before and after) of `bytes`.
/// It finds every change of up to three bits, and every burst of up to 32 bits, in the files we
/// write. Source: RFC 3720, appendix B.4.
std::uint32_t crc32c(std::string_view bytes);

}  // namespace somato
