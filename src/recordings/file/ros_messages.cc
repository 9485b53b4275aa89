#include "recordings/file/ros_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "recordings/explorations/nanoseconds.h"
#include "recordings/ros/cdr.h"

namespace somato {
namespace {

constexpr std::string_view kRosMessages = "ros2msg";
constexpr std::string_view kRule =
    "================================================================================\n";
std::string array_definition(std::string_view number) {
  return fmt::format(
      "std_msgs/MultiArrayLayout layout\n{1}[] data\n{0}"
      "MSG: std_msgs/MultiArrayLayout\nstd_msgs/MultiArrayDimension[] dim\n"
      "uint32 data_offset\n{0}MSG: std_msgs/MultiArrayDimension\nstring label\n"
      "uint32 size\nuint32 stride\n",
      kRule, number);
}

}  // namespace

McapSchema joint_state_schema() {
  return {0, "sensor_msgs/msg/JointState", std::string(kRosMessages),
          fmt::format("std_msgs/Header header\n\nstring[] name\nfloat64[] position\nfloat64[] "
                      "velocity\nfloat64[] effort\n{0}MSG: std_msgs/Header\n"
                      "builtin_interfaces/Time stamp\nstring frame_id\n{0}"
                      "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n",
                      kRule)};
}

McapSchema float_array_schema() {
  return {0, "std_msgs/msg/Float32MultiArray", std::string(kRosMessages),
          array_definition("float32")};
}

std::string joint_state_message(std::uint64_t time, const std::vector<std::string>& names,
                                std::span<const double> positions) {
  constexpr std::uint64_t kLastSecond = std::numeric_limits<std::int32_t>::max();
  CdrWriter fields;
  fields.number(static_cast<std::int32_t>(std::min(time / kNanosecondsASecond, kLastSecond)))
      .number(static_cast<std::uint32_t>(time % kNanosecondsASecond))
      .text("")
      .number(static_cast<std::uint32_t>(names.size()));
  for (const std::string& name : names) fields.text(name);
  constexpr std::span<const double> kNone;
  return fields.numbers(positions).numbers(kNone).numbers(kNone).bytes();
}

std::string float_array_message(const std::vector<std::size_t>& shape,
                                std::span<const float> values) {
  CdrWriter fields;
  fields.number(static_cast<std::uint32_t>(shape.size()));
  std::size_t stride = values.size();
  for (std::size_t i = 0; i < shape.size(); ++i) {
    fields.text(fmt::format("axis {}", i + 1))
        .number(static_cast<std::uint32_t>(shape[i]))
        .number(static_cast<std::uint32_t>(stride));
    stride /= std::max<std::size_t>(shape[i], 1);
  }
  return fields.number(std::uint32_t{0}).numbers(values).bytes();
}

std::optional<std::string> standard_definition(std::string_view type) {
  if (type == joint_state_schema().name) return joint_state_schema().data;
  if (type == float_array_schema().name) return float_array_schema().data;
  if (type == "std_msgs/msg/Float64MultiArray") return array_definition("float64");
  return std::nullopt;
}

}  // namespace somato
