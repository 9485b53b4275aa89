#include "recordings/ros/cdr.h"

#include <fmt/format.h>

namespace somato {

CdrWriter& CdrWriter::text(std::string_view value) {
  number(static_cast<std::uint32_t>(value.size() + 1));
  bytes_ += value;
  bytes_ += '\0';
  return *this;
}

Result<void> check_cdr_encapsulation(std::string_view message) {
  if (message.size() < kCdrEncapsulation) {
    return fail(
        ErrorKind::kData,
        fmt::format("the message has {} bytes, fewer than CDR begins with", message.size()));
  }
  const auto kind = big_endian<std::uint16_t>(message.data());
  if (kind <= 1) return {};
  return fail(ErrorKind::kData,
              fmt::format("the message begins with 0x{:04x}: it is not in plain CDR of version 1, "
                          "which ROS 2 uses",
                          kind),
              {}, "parameter lists and XCDR2 are not read; record it with a ROS 2 middleware");
}

std::uint64_t CdrReader::bits(std::size_t size) {
  align(size);
  const std::string_view taken = raw(size);
  if (taken.empty()) return 0;
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const auto byte = static_cast<unsigned char>(taken[is_little_ ? size - 1 - i : i]);
    bits = bits << 8 | byte;
  }
  return bits;
}

// The terminating zero is counted, but some writers have none in an empty text.
std::string_view CdrReader::text() {
  std::string_view taken = raw(static_cast<std::size_t>(bits(sizeof(std::uint32_t))));
  if (taken.ends_with('\0')) taken.remove_suffix(1);
  return taken;
}

std::size_t CdrReader::count(std::size_t least) {
  const auto declared = static_cast<std::size_t>(bits(sizeof(std::uint32_t)));
  fits_ = fits_ && declared <= (body_.size() - place_) / least;
  return fits_ ? declared : 0;
}

void CdrReader::skip(std::size_t size, std::size_t count) {
  if (count == 0) return;
  align(size);
  fits_ = fits_ && place_ <= body_.size() && count <= (body_.size() - place_) / size;
  if (fits_) place_ += count * size;
}

void CdrReader::align(std::size_t size) {
  place_ += (size - place_ % size) % size;
}

std::string_view CdrReader::raw(std::size_t count) {
  fits_ = fits_ && place_ <= body_.size() && count <= body_.size() - place_;
  if (!fits_) return {};
  place_ += count;
  return body_.substr(place_ - count, count);
}

}  // namespace somato
