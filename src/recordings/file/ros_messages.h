#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/mcap/mcap_records.h"

// The messages of ROS 2 that recordings consist of.

namespace somato {

/// The schemas, without ids.
McapSchema joint_state_schema();
McapSchema float_array_schema();

/// A sensor_msgs/msg/JointState of these positions at a time in nanoseconds.
std::string joint_state_message(std::uint64_t time, const std::vector<std::string>& names,
                                std::span<const double> positions);

/// A std_msgs/msg/Float32MultiArray of that shape.
std::string float_array_message(const std::vector<std::size_t>& shape,
                                std::span<const float> values);

/// The definition of a message type of the frames of recordings, or nothing for another type. The
/// text in a file is not used for these, so that it may be missing.
std::optional<std::string> standard_definition(std::string_view type);

}  // namespace somato
