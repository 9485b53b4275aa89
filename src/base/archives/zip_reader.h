#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// Whether `bytes` begin like a ZIP archive with members.
bool is_zip(std::string_view bytes);

/// The members of a ZIP archive in memory, stored or deflated, each below 4 GiB. Source: PKWARE's
/// APPNOTE.TXT 6.3.10, sections 4.3 and 4.4.
class ZipReader {
 public:
  struct Member {
    std::string name;
    std::uint16_t method = 0;
    std::uint32_t crc = 0;
    std::uint32_t packed_size = 0;
    std::uint32_t size = 0;
    std::uint32_t place = 0;  ///< The byte at which its head begins.
  };

  /// `bytes` must outlive the reader. Errors (kData, at `where`): no or a damaged list of members.
  static Result<ZipReader> open(std::string_view bytes, std::string where);

  const std::vector<Member>& members() const { return members_; }

  /// The content of a member. Errors (kData): it is damaged or encrypted, or packed by another
  /// method; kSystem for too little memory.
  Result<std::string> read(const Member& member) const;

 private:
  ZipReader(std::string_view bytes, std::string where) : bytes_(bytes), where_(std::move(where)) {}

  tl::unexpected<Error> bad(std::string what) const;
  Result<void> read_directory();

  std::string_view bytes_;
  std::string where_;
  std::vector<Member> members_;
};

}  // namespace somato
