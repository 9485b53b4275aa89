#include "base/archives/zip_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/archives/checksum.h"
#include "base/archives/little_endian.h"

namespace somato {
namespace {

constexpr std::uint32_t kHeadOfMember = 0x04034B50;
constexpr std::uint32_t kEntryOfDirectory = 0x02014B50;
constexpr std::uint32_t kEndOfDirectory = 0x06054B50;
constexpr std::uint32_t kEndOfDirectory64 = 0x06064B50;
constexpr std::uint32_t kDirectoryLocator64 = 0x07064B50;
constexpr std::uint16_t kZipVersion = 20;  // 2.0
constexpr std::uint16_t kZipVersion64 = 45;
constexpr std::uint16_t kNamesInUtf8 = 1U << 11U;
constexpr std::uint16_t kUncompressed = 0;
constexpr std::uint16_t kMidnight = 0;
constexpr std::uint16_t kFirstDay = 0x21;  // 1980-01-01
constexpr std::uint16_t kExtra64 = 1;
constexpr std::uint64_t kMost16 = std::numeric_limits<std::uint16_t>::max();
constexpr std::uint64_t kMost32 = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kEnd64Size = 44;  // The record without its first 12 bytes.

void append16(std::string& bytes, std::uint64_t number) {
  append_little_endian(bytes, static_cast<std::uint16_t>(std::min(number, kMost16)));
}

void append32(std::string& bytes, std::uint64_t number) {
  append_little_endian(bytes, static_cast<std::uint32_t>(std::min(number, kMost32)));
}

// The fields that the head of a member and its entry in the directory share.
void append_member(std::string& bytes, const std::string& name, std::string_view content) {
  append16(bytes, kNamesInUtf8);
  append16(bytes, kUncompressed);
  append16(bytes, kMidnight);
  append16(bytes, kFirstDay);
  append32(bytes, crc32(content));
  append32(bytes, content.size());
  append32(bytes, content.size());
  append16(bytes, name.size());
}

std::string directory_entry(const std::string& name, std::string_view content,
                            std::uint64_t place) {
  std::string extra;
  if (place >= kMost32) {
    append16(extra, kExtra64);
    append16(extra, sizeof(place));
    append_little_endian(extra, place);
  }
  const std::uint16_t version = extra.empty() ? kZipVersion : kZipVersion64;
  std::string entry;
  append_little_endian(entry, kEntryOfDirectory);
  append16(entry, version);
  append16(entry, version);
  append_member(entry, name, content);
  append16(entry, extra.size());
  append16(entry, 0);  // No comment.
  append16(entry, 0);  // The first disk.
  append16(entry, 0);  // No attributes, internal or external.
  append32(entry, 0);
  append32(entry, place);
  return entry + name + extra;
}

// The end of a directory of `size` bytes at `place`.
std::string directory_end(std::uint64_t members, std::uint64_t size, std::uint64_t place) {
  std::string end;
  if (members >= kMost16 || size >= kMost32 || place >= kMost32) {
    append_little_endian(end, kEndOfDirectory64);
    append_little_endian(end, kEnd64Size);
    append16(end, kZipVersion64);
    append16(end, kZipVersion64);
    append32(end, 0);  // This disk, and that of the directory.
    append32(end, 0);
    append_little_endian(end, members);
    append_little_endian(end, members);
    append_little_endian(end, size);
    append_little_endian(end, place);
    append_little_endian(end, kDirectoryLocator64);
    append32(end, 0);
    append_little_endian(end, place + size);
    append32(end, 1);  // The number of disks.
  }
  append_little_endian(end, kEndOfDirectory);
  append32(end, 0);  // Both disks.
  append16(end, members);
  append16(end, members);
  append32(end, size);
  append32(end, place);
  append16(end, 0);  // No comment.
  return end;
}

}  // namespace

Result<void> ZipWriter::put(std::string_view bytes) {
  place_ += bytes.size();
  return sink_(bytes);
}

Result<void> ZipWriter::add(const std::string& name, std::string_view bytes) {
  if (bytes.size() >= kMost32) {
    return fail(ErrorKind::kData, fmt::format("the array {} has 4 GiB or more", name), {},
                "use shorter explorations");
  }
  const std::uint64_t place = place_;
  std::string head;
  append_little_endian(head, kHeadOfMember);
  append16(head, kZipVersion);
  append_member(head, name, bytes);
  append16(head, 0);  // No further fields.
  directory_ += directory_entry(name, bytes, place);
  ++members_;
  return put(head + name).and_then([&] { return put(bytes); });
}

Result<void> ZipWriter::finish() {
  const std::uint64_t place = place_;
  return put(directory_).and_then([&] {
    return put(directory_end(members_, directory_.size(), place));
  });
}

}  // namespace somato
