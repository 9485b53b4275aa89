#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace somato::wire {

/// The most characters of a number in a line, with its comma.
inline constexpr std::size_t kMostNumberBytes = 24;

/// Writes the numbers, separated by commas, and LF; returns the number of bytes. Every number is
/// as short as possible for reading back the same float. Throws InvalidArgument if there are none,
/// for numbers that are not finite, and if `bytes` is smaller than kMostNumberBytes for each.
/// Allocates nothing.
std::size_t encode_number_line(std::span<const float> values, std::span<std::uint8_t> bytes);

/// Reads lines of numbers, as many sketches print them: decimal numbers separated by commas, with
/// spaces or tabs around them if need be, and LF or CR LF. A line with another count, with anything
/// else, or with a number that no float can express is rejected as a whole; empty lines are
/// skipped, and so is all that precedes the first end of a line, because it may be the rest of a
/// line. The format has no checksum: a digit that changes is not noticed. Allocates at its creation
/// only.
class NumberLineDecoder {
 public:
  /// For lines with `values` numbers.
  explicit NumberLineDecoder(std::size_t values);

  /// Takes the next byte; returns whether it completes a line with numbers.
  bool take(std::uint8_t byte);

  /// The numbers of the last line.
  std::span<const float> values() const { return values_; }

  std::size_t rejected() const { return rejected_; }

 private:
  bool finish();
  bool read();

  std::vector<float> values_;
  std::vector<float> candidate_;
  std::vector<char> line_;
  std::size_t size_ = 0;
  bool began_ = false;
  std::size_t rejected_ = 0;
};

}  // namespace somato::wire
