#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/archives/little_endian.h"
#include "somato/core/result.h"

// Messages in the encoding CDR of ROS 2 (OMG DDS-XTypes 1.3, 7.4.1, version 1): numbers at
// multiples of their size, counted from behind the four bytes of the encapsulation.

namespace somato {

inline constexpr std::size_t kCdrEncapsulation = 4;

/// Writes a message, least significant byte first.
class CdrWriter {
 public:
  template <typename T>
  CdrWriter& number(T value) {
    bytes_.resize(kCdrEncapsulation +
                  (bytes_.size() - kCdrEncapsulation + sizeof(T) - 1) / sizeof(T) * sizeof(T));
    append_little_endian(bytes_, value);
    return *this;
  }
  CdrWriter& text(std::string_view value);

  /// A sequence.
  template <typename T>
  CdrWriter& numbers(std::span<const T> values) {
    number(static_cast<std::uint32_t>(values.size()));
    if constexpr (sizeof(T) == 1) {
      bytes_.append(values.begin(), values.end());
    } else {
      for (const T value : values) number(value);
    }
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_{'\0', '\1', '\0', '\0'};
};

/// Errors (kData): `message` is not in CDR of version 1, in either order of bytes.
Result<void> check_cdr_encapsulation(std::string_view message);

/// Reads a message in either order of bytes, which check_cdr_encapsulation() has accepted. After
/// something that does not fit all is zero and empty.
class CdrReader {
 public:
  explicit CdrReader(std::string_view message)
      : body_(message.substr(kCdrEncapsulation)), is_little_(message[1] == 1) {}

  /// The bits of a number of `size` (1, 2, 4 or 8) bytes.
  std::uint64_t bits(std::size_t size);
  std::string_view text();

  /// A number of elements with at least `least` bytes each, checked against the remaining data.
  std::size_t count(std::size_t least);

  /// Passes over `count` numbers of `size` bytes.
  void skip(std::size_t size, std::size_t count);

  bool fits() const { return fits_; }

  /// The byte of the message at which the next thing begins, or the first that does not fit.
  std::size_t place() const { return kCdrEncapsulation + place_; }

 private:
  void align(std::size_t size);
  std::string_view raw(std::size_t count);

  std::string_view body_;
  std::size_t place_ = 0;
  bool fits_ = true;
  bool is_little_;
};

}  // namespace somato
