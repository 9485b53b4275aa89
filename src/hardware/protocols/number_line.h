#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hardware/protocols/line_fields.h"

namespace somato::wire {

/// The most characters of a number in a line, with its comma.
inline constexpr std::size_t kMostNumberBytes = 24;

/// Writes the numbers, separated by commas, and LF; returns the number of bytes. Every number is
/// as short as possible for reading back the same float; one that is missing is "nan". Throws
/// InvalidArgument if there are none, for infinite numbers, and if `bytes` is smaller than
/// kMostNumberBytes for each. Allocates nothing.
std::size_t encode_number_line(std::span<const float> values, std::span<std::uint8_t> bytes);

/// Reads lines of numbers, as many sketches print them, which end with LF, CR or both; LineFields
/// describes their fields. A line with another count, with anything else, or with a number that no
/// float can express is rejected as a whole; empty lines are skipped, and so is all that precedes
/// the first end of a line, because it may be the rest of a line. The format has no checksum: a
/// digit that changes is not noticed. Allocates at its creation only, except for text.
class NumberLineDecoder {
 public:
  /// For lines with `values` numbers, which may have names.
  explicit NumberLineDecoder(std::size_t values, const std::vector<LineName>& names = {});

  /// Takes the next byte; returns whether it completes a line with numbers.
  bool take(std::uint8_t byte);

  /// The numbers of the last line; NaN where the board had none.
  std::span<const float> values() const { return values_; }

  std::size_t rejected() const { return rejected_; }

  /// The last line that was rejected and the reason, or that no line has ended; empty if neither is
  /// so.
  std::string complaint() const;

  /// The last line, accepted or not, with its special characters escaped; empty before the first.
  std::string last_line() const;

 private:
  bool finish();
  bool read();

  LineFields fields_;
  std::vector<float> values_;
  std::vector<float> candidate_;
  std::vector<char> line_;
  std::size_t size_ = 0;
  bool began_ = false;
  std::vector<char> last_;  // The line before; as much of it as there is room for.
  std::size_t last_size_ = 0;
  std::vector<char> wrong_;  // The last line that was rejected.
  std::size_t wrong_size_ = 0;
  LineFault fault_;
  std::size_t rejected_ = 0;
};

}  // namespace somato::wire
