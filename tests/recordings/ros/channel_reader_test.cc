#include "recordings/ros/channel_reader.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "recordings/ros/cdr.h"
#include "recordings/ros/definition.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;
using Shape = std::vector<std::size_t>;
using Values = std::vector<double>;

std::shared_ptr<const RosType> type_of(const std::string& text) {
  return std::make_shared<const RosType>(compile_ros_definition("a/Top", "ros2msg", text).value());
}

// An array of two axes, with `count` ascending values and `offset` in front.
std::string array_message(std::uint32_t rows, std::uint32_t columns, std::uint32_t count,
                          std::uint32_t offset = 0) {
  CdrWriter written;
  written.number(std::uint32_t{2}).text("row").number(rows).number(rows * columns);
  written.text("column").number(columns).number(columns).number(offset).number(count);
  for (std::uint32_t i = 0; i < count; ++i) written.number(static_cast<float>(i));
  return written.bytes();
}

ChannelReader array_reader() {
  return ChannelReader::compile(
             type_of("std_msgs/MultiArrayLayout layout\nfloat32[] data\n===\nMSG: "
                     "std_msgs/MultiArrayLayout\nstd_msgs/MultiArrayDimension[] dim\nuint32 "
                     "data_offset\n===\nMSG: std_msgs/MultiArrayDimension\nstring label\nuint32 "
                     "size\nuint32 stride\n"),
             {"data"})
      .value();
}

Values values_of(const ChannelReader& reader, const std::string& message) {
  Values values{99.0};
  EXPECT_TRUE(reader.read(message, values));
  return values;
}

TEST(ChannelReader, AShapeThatTheValuesDoNotFillIsNone) {
  const ChannelReader reader = array_reader();
  EXPECT_EQ(reader.shape(array_message(2, 3, 6)).value(), (Shape{2, 3}));
  EXPECT_TRUE(reader.shape(array_message(2, 3, 5)).value().empty());
  EXPECT_TRUE(reader.shape(array_message(2, 3, 7)).value().empty());
  EXPECT_TRUE(reader.shape(array_message(2, 3, 12)).value().empty());
  EXPECT_TRUE(reader.shape(array_message(0, 3, 6)).value().empty());
}

TEST(ChannelReader, ValuesBeforeTheOffsetOfAnArrayAreLeftOut) {
  const ChannelReader reader = array_reader();
  EXPECT_EQ(values_of(reader, array_message(1, 2, 4, 2)), (Values{2.0, 3.0}));
  EXPECT_EQ(values_of(reader, array_message(1, 2, 4, 9)), Values{});
  EXPECT_EQ(reader.shape(array_message(1, 2, 4, 2)).value(), (Shape{1, 2}));
}

TEST(ChannelReader, PathsFollowEachOther) {
  const auto type = type_of("int8 a\nint8[2] b\nstring[] names\n");
  CdrWriter writer;
  writer.number(std::int8_t{1}).number(std::int8_t{2}).number(std::int8_t{3});
  writer.number(std::uint32_t{3}).text("x").text("y").text("z");
  const auto reader = ChannelReader::compile(type, {"b", "a"}).value();
  EXPECT_EQ(values_of(reader, writer.bytes()), (Values{2.0, 3.0, 1.0}));
  EXPECT_EQ(reader.element_names(writer.bytes()).value(), (Names{"b[0]", "b[1]", "a"}));
  const auto named = ChannelReader::compile(type, {"b", "a"}, "names").value();
  EXPECT_EQ(named.element_names(writer.bytes()).value(), (Names{"x", "y", "z"}));
  const auto misnamed = ChannelReader::compile(type, {"b"}, "names").value();
  EXPECT_TRUE(misnamed.element_names(writer.bytes()).value().empty());
}

TEST(ChannelReader, PathsAreRequired) {
  EXPECT_FALSE(ChannelReader::compile(type_of("int8 a\n"), {}));
  EXPECT_FALSE(ChannelReader::compile(type_of("int8 a\n"), {"a"}, "a"));
}

}  // namespace
}  // namespace somato
