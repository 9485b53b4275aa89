#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/archives/checksum.h"
#include "base/archives/little_endian.h"

namespace somato {

/// `bytes` deflated by zlib, in its own container or without one.
inline std::string deflated(const std::string& bytes, bool is_raw) {
  z_stream stream{};
  (void)::deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, is_raw ? -MAX_WBITS : MAX_WBITS, 8,
                       Z_DEFAULT_STRATEGY);
  std::string packed(::deflateBound(&stream, bytes.size()), '\0');
  std::string copy = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(copy.data());
  stream.avail_in = static_cast<uInt>(copy.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  (void)::deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  (void)::deflateEnd(&stream);
  return packed;
}

/// A ZIP archive of members with names and bytes, stored or deflated.
inline std::string made_zip(const std::vector<std::pair<std::string, std::string>>& members,
                            bool is_deflated) {
  std::string bytes;
  std::string directory;
  for (const auto& [name, content] : members) {
    const std::string packed = is_deflated ? deflated(content, true) : content;
    std::string head;  // The member's head and its entry in the directory share it.
    append_little_endian(head, std::uint32_t{20});
    append_little_endian(head, std::uint16_t{is_deflated ? std::uint16_t{8} : std::uint16_t{0}});
    append_little_endian(head, std::uint32_t{0});
    append_little_endian(head, crc32(content));
    append_little_endian(head, static_cast<std::uint32_t>(packed.size()));
    append_little_endian(head, static_cast<std::uint32_t>(content.size()));
    append_little_endian(head, static_cast<std::uint16_t>(name.size()));
    append_little_endian(head, std::uint16_t{0});
    directory += std::string("PK\1\2\0\0", 6) + head;
    append_little_endian(directory, std::uint64_t{0});
    append_little_endian(directory, std::uint16_t{0});
    append_little_endian(directory, static_cast<std::uint32_t>(bytes.size()));
    directory += name;
    bytes += std::string("PK\3\4", 4) + head + name + packed;
  }
  const auto place = static_cast<std::uint32_t>(bytes.size());
  bytes += directory + std::string("PK\5\6\0\0\0\0", 8);
  for (int i = 0; i < 2; ++i) {
    append_little_endian(bytes, static_cast<std::uint16_t>(members.size()));
  }
  append_little_endian(bytes, static_cast<std::uint32_t>(directory.size()));
  append_little_endian(bytes, place);
  append_little_endian(bytes, std::uint16_t{0});
  return bytes;
}

}  // namespace somato
