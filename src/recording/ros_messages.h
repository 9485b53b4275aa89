#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "recording/mcap_records.h"

// Messages of ROS 2 in the encoding CDR, as far as recordings use them.

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

/// The frame in a message. Views refer to the message.
struct RosFrame {
  std::vector<std::string_view> names;  ///< The names of joints.
  std::vector<std::size_t> shape;       ///< The shape of an array; empty: flat.
  std::vector<double> values;
};

/// The kinds of message that hold a frame.
enum class RosKind { kJointState, kFloat32Array, kFloat64Array };

/// The kind of that schema, or nothing.
std::optional<RosKind> ros_kind(const McapSchema& schema, const McapChannel& channel);

/// Nothing when `message` is not such a message in either byte order.
std::optional<RosFrame> parse_ros_message(RosKind kind, std::string_view message);

}  // namespace somato
