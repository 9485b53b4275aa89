#include "base/archives/inflate.h"

#include <fmt/format.h>

#define ZLIB_CONST  // Input is const.
#include <zlib.h>

#include <algorithm>
#include <limits>

#include "base/core/memory.h"

namespace somato {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20;

// The state of zlib, which is released on every way out.
class Inflation {
 public:
  explicit Inflation(Deflated kind)
      : is_ready_(::inflateInit2(&stream_, kind == Deflated::kRaw ? -MAX_WBITS : MAX_WBITS) ==
                  Z_OK) {}
  Inflation(const Inflation&) = delete;
  Inflation(Inflation&&) = delete;
  Inflation& operator=(const Inflation&) = delete;
  Inflation& operator=(Inflation&&) = delete;
  ~Inflation() { (void)::inflateEnd(&stream_); }

  bool is_ready() const { return is_ready_; }
  z_stream& stream() { return stream_; }

 private:
  z_stream stream_{};
  bool is_ready_;
};

}  // namespace

// The declared size of a damaged file is not believed: the result grows with what is there.
Result<std::string> inflate_bytes(std::string_view packed, std::size_t most, Deflated kind) {
  const std::size_t most_memory = free_memory() / 3;
  Inflation inflation(kind);
  if (!inflation.is_ready()) return fail(ErrorKind::kSystem, "zlib cannot begin to inflate");
  z_stream& stream = inflation.stream();
  std::string bytes;
  int status = Z_OK;
  while (status == Z_OK && bytes.size() < most) {
    const std::size_t piece = std::min(kPiece, most - bytes.size());
    if (bytes.size() + piece > most_memory) {
      return fail(ErrorKind::kSystem,
                  fmt::format("it inflates to more than the available memory of {}",
                              memory_text(static_cast<double>(most_memory))));
    }
    const std::size_t start = bytes.size();
    bytes.resize(start + piece);
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + start);
    stream.avail_out = static_cast<uInt>(piece);
    while (status == Z_OK && stream.avail_out > 0) {
      if (stream.avail_in == 0) {
        const std::size_t given = std::min(packed.size(), kPiece);
        if (given == 0) return fail(ErrorKind::kData, "the compressed data are cut");
        stream.next_in = reinterpret_cast<const Bytef*>(packed.data());
        stream.avail_in = static_cast<uInt>(given);
        packed.remove_prefix(given);
      }
      status = ::inflate(&stream, Z_NO_FLUSH);
    }
    bytes.resize(start + piece - stream.avail_out);
  }
  if (status == Z_OK || status == Z_STREAM_END) return bytes;
  return fail(ErrorKind::kData, "the compressed data are damaged");
}

}  // namespace somato
