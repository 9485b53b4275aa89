#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "recordings/ros/message_type.h"
#include "somato/core/result.h"

namespace somato {

/// A field as its line declares it.
struct DeclaredField {
  std::string type;  ///< Without bounds, such as "uint8", "Header" or "std_msgs/Header".
  RosField field;    ///< Its primitive, if `type` is one, but no structure.
  bool is_primitive = false;
};

/// The field that a line of a definition declares; nothing for an empty line, a comment and a
/// constant. Errors (kData, without a place): a line that is none of these.
Result<std::optional<DeclaredField>> parse_field_line(std::string_view line);

}  // namespace somato
