#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "somato/core/result.h"
#include "somato/recording/recording_writer.h"

namespace somato {

/// MCAP's name of it: empty, "lz4" (the frame format of LZ4) or "zstd".
std::string_view mcap_name(Compression compression);

/// `bytes`, packed. Errors: kSystem with the reason of the library that packs.
Result<std::string> pack(Compression compression, std::string_view bytes);

/// Decompresses data with `size` decompressed bytes, with MCAP's name of the compression. Errors
/// (kData, without a location): an unknown name, damaged data, and data of another size; at most
/// `size` bytes are written.
Result<std::string> unpack(std::string_view name, std::string_view packed, std::size_t size);

}  // namespace somato
