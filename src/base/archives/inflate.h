#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "somato/core/result.h"

namespace somato {

/// The container of deflated bytes.
enum class Deflated {
  kRaw,   ///< None, as in ZIP archives.
  kZlib,  ///< That of zlib (RFC 1950), as in MAT-files.
};

/// The first `most` bytes that `packed` inflates to, or all if there are fewer. Memory is what they
/// take. Errors (kData, without a location): damaged data; kSystem if they exceed a third of the
/// available memory.
Result<std::string> inflate_bytes(std::string_view packed, std::size_t most, Deflated kind);

}  // namespace somato
