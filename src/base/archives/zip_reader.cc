#include "base/archives/zip_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/archives/checksum.h"
#include "base/archives/inflate.h"
#include "base/archives/little_endian.h"
#include "base/text/text.h"

namespace somato {
namespace {

constexpr std::string_view kMemberHead("PK\3\4", 4);
constexpr std::string_view kDirectoryEntry("PK\1\2", 4);
constexpr std::string_view kDirectoryEnd("PK\5\6", 4);
constexpr std::size_t kMemberHeadSize = 30;
constexpr std::size_t kDirectoryEntrySize = 46;
constexpr std::size_t kDirectoryEndSize = 22;
constexpr std::size_t kLongestComment = 65535;
constexpr std::uint32_t kIn64Bits = 0xFFFFFFFF;
constexpr std::uint16_t kStored = 0;
constexpr std::uint16_t kDeflated = 8;
constexpr unsigned kEncrypted = 1;

std::uint16_t short_at(std::string_view bytes, std::size_t place) {
  return little_endian<std::uint16_t>(bytes.data() + place);
}

std::uint32_t zip_number_at(std::string_view bytes, std::size_t place) {
  return little_endian<std::uint32_t>(bytes.data() + place);
}

}  // namespace

bool is_zip(std::string_view bytes) {
  return bytes.starts_with(kMemberHead);
}

tl::unexpected<Error> ZipReader::bad(std::string what) const {
  return fail(ErrorKind::kData, std::move(what), where_, "copy or save it again");
}

Result<ZipReader> ZipReader::open(std::string_view bytes, std::string where) {
  ZipReader reader(bytes, std::move(where));
  SOMATO_TRY_VOID(reader.read_directory());
  return reader;
}

Result<void> ZipReader::read_directory() {
  const std::size_t tail = std::min(bytes_.size(), kDirectoryEndSize + kLongestComment);
  const std::string_view last = bytes_.substr(bytes_.size() - tail);
  const std::size_t end = last.rfind(kDirectoryEnd);
  if (end == std::string_view::npos || last.size() - end < kDirectoryEndSize) {
    return bad("the archive has no list of its members");
  }
  const std::size_t count = short_at(last, end + 10);
  const std::uint32_t size = zip_number_at(last, end + 12);
  const std::size_t begin = zip_number_at(last, end + 16);
  std::size_t place = begin;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view entry = bytes_.substr(std::min(place, bytes_.size()));
    if (!entry.starts_with(kDirectoryEntry) || entry.size() < kDirectoryEntrySize) {
      return bad("the list of the archive's members is damaged");
    }
    const std::size_t name = short_at(entry, 28);
    const std::size_t whole =
        kDirectoryEntrySize + name + short_at(entry, 30) + short_at(entry, 32);
    if (entry.size() < whole) return bad("the list of the archive's members is cut");
    members_.push_back({std::string(entry.substr(kDirectoryEntrySize, name)), short_at(entry, 10),
                        zip_number_at(entry, 16), zip_number_at(entry, 20),
                        zip_number_at(entry, 24), zip_number_at(entry, 42)});
    if ((short_at(entry, 8) & kEncrypted) != 0) return bad("the archive is encrypted");
    place += whole;
  }
  // A damaged number of members would hide some of them.
  if (size != kIn64Bits && place - begin != size) {
    return bad("the list of the archive's members does not have its size");
  }
  return {};
}

Result<std::string> ZipReader::read(const Member& member) const {
  const std::string what = fmt::format("the member {}", shown(member.name));
  if (member.packed_size == kIn64Bits || member.size == kIn64Bits || member.place == kIn64Bits) {
    return bad(what + " has 4 GiB or more");
  }
  const std::string_view head = bytes_.substr(std::min<std::size_t>(member.place, bytes_.size()));
  if (!head.starts_with(kMemberHead) || head.size() < kMemberHeadSize) {
    return bad(what + " is not where the list of members says");
  }
  const std::size_t start = kMemberHeadSize + short_at(head, 26) + short_at(head, 28);
  if (head.size() < start || head.size() - start < member.packed_size) return bad(what + " is cut");
  const std::string_view packed = head.substr(start, member.packed_size);
  if (member.method != kStored && member.method != kDeflated) {
    return bad(
        fmt::format("{} is packed by the method {}, which is not known", what, member.method));
  }
  Result<std::string> bytes = member.method == kStored
                                  ? Result<std::string>(std::string(packed))
                                  : inflate_bytes(packed, member.size, Deflated::kRaw);
  if (!bytes) {
    bytes.error().what = what + ": " + bytes.error().what;
    bytes.error().where = where_;
    return bytes;
  }
  if (bytes->size() != member.size || crc32(*bytes) != member.crc) {
    return bad(what + " does not match its checksum");
  }
  return bytes;
}

}  // namespace somato
