#include "recording/ros_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "files/little_endian.h"
#include "recording/nanoseconds.h"

namespace somato {
namespace {

constexpr std::string_view kRosMessages = "ros2msg";
constexpr std::string_view kCdr = "cdr";
constexpr std::string_view kRule =
    "================================================================================\n";
constexpr std::size_t kEncapsulation = 4;

// Fields aligned to their size, counted from behind the encapsulation.
class CdrFields {
 public:
  template <typename T>
  CdrFields& number(T value) {
    bytes_.resize(kEncapsulation +
                  (bytes_.size() - kEncapsulation + sizeof(T) - 1) / sizeof(T) * sizeof(T));
    append_little_endian(bytes_, value);
    return *this;
  }
  CdrFields& text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size() + 1));
    bytes_ += value;
    bytes_ += '\0';
    return *this;
  }
  template <typename T>
  CdrFields& numbers(std::span<const T> values) {
    number(static_cast<std::uint32_t>(values.size()));
    for (const T value : values) number(value);
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_{'\0', '\1', '\0', '\0'};
};

// The opposite, for both byte orders; after a field that does not fit all are empty.
class CdrTaker {
 public:
  explicit CdrTaker(std::string_view message)
      : body_(message.substr(std::min(kEncapsulation, message.size()))),
        fits_(message.size() >= kEncapsulation && message[0] == 0 &&
              (message[1] == 0 || message[1] == 1)),
        little_(fits_ && message[1] == 1) {}

  template <typename T>
  T number() {
    place_ = (place_ + sizeof(T) - 1) / sizeof(T) * sizeof(T);
    const std::string_view taken = raw(sizeof(T));
    if (taken.empty()) return T{};
    return little_ ? little_endian<T>(taken.data()) : big_endian<T>(taken.data());
  }
  std::string_view text() {
    const std::string_view taken = raw(number<std::uint32_t>());
    return taken.substr(0, taken.empty() ? 0 : taken.size() - 1);
  }
  // A number of elements with at least `least` bytes each, checked against the remaining data.
  std::size_t count(std::size_t least) {
    const auto declared = number<std::uint32_t>();
    const std::size_t left = place_ <= body_.size() ? body_.size() - place_ : 0;
    fits_ = fits_ && declared <= left / least;
    return fits_ ? declared : 0;
  }
  template <typename T>
  std::vector<double> numbers() {
    std::vector<double> values(count(sizeof(T)));
    for (double& value : values) value = number<T>();
    return values;
  }
  bool fits() const { return fits_; }

 private:
  std::string_view raw(std::size_t count) {
    fits_ = fits_ && place_ <= body_.size() && count <= body_.size() - place_;
    if (!fits_) return {};
    place_ += count;
    return body_.substr(place_ - count, count);
  }

  std::string_view body_;
  std::size_t place_ = 0;
  bool fits_;
  bool little_;
};

RosFrame take_joint_state(CdrTaker& taker) {
  RosFrame frame;
  (void)taker.number<std::int32_t>();
  (void)taker.number<std::uint32_t>();
  (void)taker.text();
  frame.names.resize(taker.count(sizeof(std::uint32_t)));
  for (std::string_view& name : frame.names) name = taker.text();
  frame.values = taker.numbers<double>();
  return frame;
}

// A shape that the values do not fill is none.
void keep_fitting_shape(RosFrame& frame) {
  std::size_t elements = 1;
  for (const std::size_t length : frame.shape) {
    elements = length == 0 || elements > frame.values.size() ? 0 : elements * length;
  }
  if (elements != frame.values.size() || frame.shape.size() < 2) frame.shape.clear();
}

template <typename T>
RosFrame take_array(CdrTaker& taker) {
  constexpr std::size_t kLeastDimension = 3 * sizeof(std::uint32_t);
  RosFrame frame;
  frame.shape.resize(taker.count(kLeastDimension));
  for (std::size_t& length : frame.shape) {
    (void)taker.text();
    length = taker.number<std::uint32_t>();
    (void)taker.number<std::uint32_t>();
  }
  const auto offset = taker.number<std::uint32_t>();
  frame.values = taker.numbers<T>();
  const std::size_t skipped = std::min(std::size_t{offset}, frame.values.size());
  frame.values.erase(frame.values.begin(),
                     frame.values.begin() + static_cast<std::ptrdiff_t>(skipped));
  keep_fitting_shape(frame);
  return frame;
}

RosFrame take(RosKind kind, CdrTaker& taker) {
  if (kind == RosKind::kJointState) return take_joint_state(taker);
  return kind == RosKind::kFloat32Array ? take_array<float>(taker) : take_array<double>(taker);
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
          fmt::format("std_msgs/MultiArrayLayout layout\nfloat32[] data\n{0}"
                      "MSG: std_msgs/MultiArrayLayout\nstd_msgs/MultiArrayDimension[] dim\n"
                      "uint32 data_offset\n{0}MSG: std_msgs/MultiArrayDimension\nstring label\n"
                      "uint32 size\nuint32 stride\n",
                      kRule)};
}

std::string joint_state_message(std::uint64_t time, const std::vector<std::string>& names,
                                std::span<const double> positions) {
  constexpr std::uint64_t kLastSecond = std::numeric_limits<std::int32_t>::max();
  CdrFields fields;
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
  CdrFields fields;
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

std::optional<RosKind> ros_kind(const McapSchema& schema, const McapChannel& channel) {
  if (channel.message_encoding != kCdr) return std::nullopt;
  if (schema.name == "sensor_msgs/msg/JointState") return RosKind::kJointState;
  if (schema.name == "std_msgs/msg/Float32MultiArray") return RosKind::kFloat32Array;
  if (schema.name == "std_msgs/msg/Float64MultiArray") return RosKind::kFloat64Array;
  return std::nullopt;
}

std::optional<RosFrame> parse_ros_message(RosKind kind, std::string_view message) {
  CdrTaker taker(message);
  RosFrame frame = take(kind, taker);
  if (!taker.fits()) return std::nullopt;
  return frame;
}

}  // namespace somato
