#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/ros/message_type.h"

// The syntax of the paths of a FieldReader.

namespace somato {

/// The elements that brackets behind the name of an array or sequence select.
struct PathElements {
  std::size_t first = 0;
  std::size_t last = kUnbounded;
  bool is_padded = false;          ///< Whether elements that a message lacks are missing numbers.
  std::vector<std::string> names;  ///< If not empty, all elements are read, for these of them.
};

/// The content of brackets: "*", "2", "2..5", "*:32" or names with commas between. Nothing for
/// anything else, such as empty or repeated names.
std::optional<PathElements> parse_path_elements(std::string_view text);

/// The part of a path up to the next dot outside brackets, which is cut off with the dot. A dot at
/// the end stays, as the start of a part without a name.
std::string_view take_path_part(std::string_view& rest);

/// The parts of a list, such as of paths with `+` between; a separator in brackets belongs to a
/// name.
std::vector<std::string> split_outside_brackets(std::string_view text, char separator);

}  // namespace somato
