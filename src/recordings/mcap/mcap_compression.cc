#include "recordings/mcap/mcap_compression.h"

#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

#include <memory>

#include "base/text/text.h"

namespace somato {
namespace {

constexpr std::string_view kLz4 = "lz4";
constexpr std::string_view kZstd = "zstd";
constexpr int kZstdLevel = 1;  // Sensors do not wait.

tl::unexpected<Error> cannot_pack(std::string_view name, const char* reason) {
  return fail(ErrorKind::kSystem, fmt::format("cannot compress with {}: {}", name, reason));
}

tl::unexpected<Error> cannot_unpack(std::string_view name, const char* reason) {
  return fail(ErrorKind::kData, fmt::format("cannot decompress {}: {}", name, reason));
}

tl::unexpected<Error> another_size(std::string_view name) {
  return cannot_unpack(name, "its size differs from the declared size");
}

Result<std::string> pack_lz4(std::string_view bytes) {
  std::string packed(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
  const std::size_t size =
      LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), nullptr);
  if (LZ4F_isError(size) != 0) return cannot_pack(kLz4, LZ4F_getErrorName(size));
  packed.resize(size);
  return packed;
}

Result<std::string> pack_zstd(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kZstdLevel);
  if (ZSTD_isError(size) != 0) return cannot_pack(kZstd, ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
}

struct FreeLz4 {
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};

// Whether the frame ends with the last byte of `packed` and the last of `room`.
Result<std::string> unpack_lz4(std::string_view packed, std::size_t size) {
  LZ4F_dctx* made = nullptr;
  const std::size_t status = LZ4F_createDecompressionContext(&made, LZ4F_VERSION);
  if (LZ4F_isError(status) != 0) return cannot_unpack(kLz4, LZ4F_getErrorName(status));
  const std::unique_ptr<LZ4F_dctx, FreeLz4> context(made);
  std::string bytes(size, '\0');
  std::size_t filled = 0;
  for (;;) {
    std::size_t room = bytes.size() - filled;
    std::size_t taken = packed.size();
    const std::size_t wanted = LZ4F_decompress(context.get(), bytes.data() + filled, &room,
                                               packed.data(), &taken, nullptr);
    if (LZ4F_isError(wanted) != 0) return cannot_unpack(kLz4, LZ4F_getErrorName(wanted));
    filled += room;
    packed.remove_prefix(taken);
    if (wanted == 0) break;
    if (room == 0 && taken == 0) return another_size(kLz4);
  }
  if (filled != size || !packed.empty()) return another_size(kLz4);
  return bytes;
}

Result<std::string> unpack_zstd(std::string_view packed, std::size_t size) {
  std::string bytes(size, '\0');
  const std::size_t filled =
      ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
  if (ZSTD_isError(filled) != 0) return cannot_unpack(kZstd, ZSTD_getErrorName(filled));
  if (filled != size) return another_size(kZstd);
  return bytes;
}

}  // namespace

std::string_view mcap_name(Compression compression) {
  if (compression == Compression::kLz4) return kLz4;
  return compression == Compression::kZstd ? kZstd : std::string_view();
}

Result<std::string> pack(Compression compression, std::string_view bytes) {
  if (compression == Compression::kLz4) return pack_lz4(bytes);
  if (compression == Compression::kZstd) return pack_zstd(bytes);
  return std::string(bytes);
}

Result<std::string> unpack(std::string_view name, std::string_view packed, std::size_t size) {
  if (name == kLz4) return unpack_lz4(packed, size);
  if (name == kZstd) return unpack_zstd(packed, size);
  if (!name.empty()) {
    return fail(ErrorKind::kData, fmt::format("the compression {} is unknown", shown(name)), {},
                "use lz4, zstd or no compression");
  }
  if (packed.size() != size)
    return cannot_unpack("a chunk", "its size differs from the declared size");
  return std::string(packed);
}

}  // namespace somato
