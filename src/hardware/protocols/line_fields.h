#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace somato::wire {

/// The name of a number in a line, and its place among the values of a frame.
struct LineName {
  std::string name;
  std::size_t place = 0;
};

/// Why a line gives no values.
struct LineFault {
  enum class Kind {
    kTooLong,     ///< It is longer than `number` characters.
    kSeparators,  ///< It has both commas and semicolons.
    kCount,       ///< It has `number` fields.
    kEmpty,       ///< The field `number`, counted from 1, is empty.
    kNoNumber,    ///< The field `number` is no number.
    kUnnamed,     ///< The field `number` has no name, but others have.
    kNoNames,     ///< It names its values, but no place has a name.
    kMissing,     ///< The place `number` has a name that is missing in the line.
    kRepeated,    ///< The field `number` has a name that occurred before.
    kAmbiguous,   ///< The field `number` has a name that stands for several places.
  };
  Kind kind = Kind::kCount;
  std::size_t number = 0;
};

/// Reads the numbers of a line. Its fields are separated by commas, by semicolons, or else by
/// blanks and tabs; a separator may also follow the last field. Either every field is a number, in
/// the order of the places, or every field is `name:number` or `name=number`: then each number goes
/// to the place with its name, in upper or lower case if that leaves one place. All names of places
/// must occur; further ones in the line are ignored, and a place without a name is NaN. `nan`,
/// `inf` and `ovf`, which boards print for a number that they do not have, are NaN.
class LineFields {
 public:
  /// For `values` numbers; `names` of places below that.
  LineFields(std::size_t values, std::vector<LineName> names);

  /// After a fault, `values` have no meaning. Allocates nothing.
  std::optional<LineFault> read(std::string_view line, std::span<float> values);

  /// The fault as text, such as "4 fields instead of 3".
  std::string to_string(const LineFault& fault) const;

 private:
  std::optional<LineFault> read_in_order(std::string_view line, std::span<float> values) const;
  std::optional<LineFault> read_by_name(std::string_view line, std::span<float> values);
  std::optional<LineFault::Kind> put(std::string_view name, float number, std::span<float> values);

  std::size_t count_;
  std::vector<LineName> names_;
  std::vector<char> seen_;  // of each place, in the present line
};

}  // namespace somato::wire
