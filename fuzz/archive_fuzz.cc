#include <cstdint>
#include <cstring>
#include <string>

#include "base/archives/archive.h"
#include "base/archives/checksum.h"
#include "somato/core/check.h"

namespace {

void put_number(std::string& bytes, std::size_t offset, std::uint64_t number, int size) {
  for (int i = 0; i < size; ++i) {
    bytes[offset + static_cast<std::size_t>(i)] = static_cast<char>(number >> (8 * i) & 0xFF);
  }
}

// Makes magic, version, length and checksum right, so that what lies behind them is reached.
std::string made_whole(std::string bytes) {
  if (bytes.size() < 36) return bytes;
  bytes.replace(0, 12, std::string("\x8FSOMATO\r\n\x1A\n\0", 12));
  put_number(bytes, 12, 1, 4);
  put_number(bytes, 16, bytes.size(), 8);
  const std::size_t content = bytes.size() - 4;
  put_number(bytes, content, somato::crc32c(std::string_view(bytes).substr(0, content)), 4);
  return bytes;
}

// An accepted archive is exactly what would be written.
void check(const std::string& bytes) {
  const somato::Result<somato::Archive> archive = somato::decode_archive(bytes, "input");
  if (archive) SOMATO_ASSERT(somato::encode_archive(*archive) == bytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  check(bytes);
  check(made_whole(bytes));
  return 0;
}
