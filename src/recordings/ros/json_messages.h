#pragma once

#include <string>
#include <string_view>

#include "recordings/ros/message_type.h"
#include "somato/core/result.h"

// Messages in JSON, which MCAP files and the protocol of Foxglove permit, are read as those of ROS:
// their JSON Schema is compiled to a type, and each message is written in CDR of that type.

namespace somato {

/// The type of messages with a JSON Schema: objects are structures, arrays are sequences (arrays of
/// arrays have a field `items` between), numbers are float64, booleans bool. Properties of other
/// types, and of none, are left out. Errors (kData): a text that is not JSON, a schema that is not
/// that of an object, references to what is not in the schema or to itself.
Result<RosType> compile_json_schema(std::string_view name, std::string_view schema);

/// The message in CDR of a type of compile_json_schema(). A number that is missing, null or not a
/// number is NaN; other missing values are empty. Errors (kData): a text that is not a JSON object.
Result<std::string> cdr_of_json(const RosType& type, std::string_view message);

}  // namespace somato
