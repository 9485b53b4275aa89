#include "recording/ros_messages.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace somato {
namespace {

using Names = std::vector<std::string_view>;
using Values = std::vector<double>;
using Shape = std::vector<std::size_t>;

// A message of Float32MultiArray without its values, in the order of bytes of this machine, written
// from the specification of CDR: each number at a multiple of its size, texts end with a zero.
class WrittenArray {
 public:
  WrittenArray& number(std::uint32_t value) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    for (unsigned shift = 0; shift < 32; shift += 8) {
      bytes_ += static_cast<char>(value >> shift & 0xFFU);
    }
    return *this;
  }
  WrittenArray& text(const std::string& value) {
    number(static_cast<std::uint32_t>(value.size() + 1));
    bytes_ += value + std::string(1, '\0');
    return *this;
  }
  WrittenArray& zeros(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) number(0);
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_{'\0', '\1', '\0', '\0'};
};

// An array of two axes, with `count` zeros.
RosFrame array_of(std::uint32_t rows, std::uint32_t columns, std::uint32_t count) {
  WrittenArray written;
  written.number(2).text("row").number(rows).number(rows * columns);
  written.text("column").number(columns).number(columns).number(0).number(count).zeros(count);
  return parse_ros_message(RosKind::kFloat32Array, written.bytes()).value();
}

TEST(RosMessages, JointsKeepTheirWholeNames) {
  const std::vector<std::string> names{"thumb", "", "i"};
  const Values positions{0.5, -1.25, 3.0};
  const std::string message = joint_state_message(7'000'000'001, names, positions);
  const auto frame = parse_ros_message(RosKind::kJointState, message);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->names, (Names{"thumb", "", "i"}));
  EXPECT_EQ(frame->values, positions);
  EXPECT_TRUE(frame->shape.empty());
}

TEST(RosMessages, ArraysKeepTheShapeThatTheirValuesFill) {
  for (const Shape& shape : {Shape{2, 3}, Shape{1, 6}, Shape{3, 1, 2}}) {
    const std::vector<float> values{1, 2, 3, 4, 5, 6};
    const std::string message = float_array_message(shape, values);
    const auto frame = parse_ros_message(RosKind::kFloat32Array, message);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->shape, shape);
    EXPECT_EQ(frame->values, Values(values.begin(), values.end()));
  }
}

TEST(RosMessages, AShapeThatTheValuesDoNotFillIsNone) {
  EXPECT_EQ(array_of(2, 3, 6).shape, (Shape{2, 3}));
  EXPECT_TRUE(array_of(2, 3, 5).shape.empty());
  EXPECT_TRUE(array_of(2, 3, 7).shape.empty());
  EXPECT_TRUE(array_of(2, 3, 12).shape.empty());
  EXPECT_TRUE(array_of(0, 3, 6).shape.empty());
  EXPECT_EQ(array_of(2, 3, 7).values.size(), 7U);
}

TEST(RosMessages, OneAxisIsNoShape) {
  const std::string message = float_array_message({3}, std::vector<float>{1, 2, 3});
  const auto frame = parse_ros_message(RosKind::kFloat32Array, message);
  ASSERT_TRUE(frame);
  EXPECT_TRUE(frame->shape.empty());
  EXPECT_EQ(frame->values.size(), 3U);
}

}  // namespace
}  // namespace somato
