#include "recordings/ros/channel_reader.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "base/support/sanitized.h"
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

// A message with its numbers of rows and columns, in a list of pads.
std::string pads_message(std::uint32_t rows, std::uint32_t columns, std::uint32_t count) {
  CdrWriter written;
  written.number(std::uint32_t{1}).number(rows).number(columns).number(count);
  for (std::uint32_t i = 0; i < count; ++i) written.number(static_cast<float>(i));
  return written.bytes();
}

TEST(ChannelReader, TheShapeOfAListIsThatOfTheRowsAndColumnsBesideIt) {
  for (const auto& [rows, columns] :
       {std::pair("rows", "cols"), std::pair("rows", "columns"), std::pair("height", "width")}) {
    const auto type = type_of(
        fmt::format("pkg/Pad[] pads\n===\nMSG: pkg/Pad\nuint32 {}\nuint32 {}\nfloat32[] data\n",
                    rows, columns));
    const ChannelReader reader = ChannelReader::compile(type, {"pads[0].data"}).value();
    EXPECT_EQ(reader.shape(pads_message(2, 3, 6)).value(), (Shape{2, 3})) << rows;
    EXPECT_TRUE(reader.shape(pads_message(2, 3, 7)).value().empty());
    EXPECT_TRUE(reader.shape(pads_message(0, 3, 3)).value().empty());
    EXPECT_TRUE(reader.shape(pads_message(4294967295U, 4294967295U, 1)).value().empty());
    EXPECT_EQ(reader.element_names(pads_message(1, 2, 2)).value()[1], "pads[0].data[1]");
  }
  const auto type = type_of("float32 rows\nfloat32[] data\n");
  EXPECT_TRUE(ChannelReader::compile(type, {"data"}).has_value());
}

TEST(ChannelReader, ValuesBeforeTheOffsetOfAnArrayAreLeftOut) {
  const ChannelReader reader = array_reader();
  EXPECT_EQ(values_of(reader, array_message(1, 2, 4, 2)), (Values{2.0, 3.0}));
  EXPECT_EQ(values_of(reader, array_message(1, 2, 4, 9)), Values{});
  EXPECT_EQ(reader.shape(array_message(1, 2, 4, 2)).value(), (Shape{1, 2}));
}

TEST(ChannelReader, PathsFollowEachOther) {
  const auto type = type_of("int8 a\nint8[2] b\nstring[] labels\n");
  CdrWriter writer;
  writer.number(std::int8_t{1}).number(std::int8_t{2}).number(std::int8_t{3});
  writer.number(std::uint32_t{3}).text("x").text("y").text("z");
  const auto reader = ChannelReader::compile(type, {"b", "a"}).value();
  EXPECT_EQ(values_of(reader, writer.bytes()), (Values{2.0, 3.0, 1.0}));
  EXPECT_EQ(reader.element_names(writer.bytes()).value(), (Names{"b[0]", "b[1]", "a"}));
  const auto named = ChannelReader::compile(type, {"b", "a"}, "labels").value();
  EXPECT_EQ(named.element_names(writer.bytes()).value(), (Names{"x", "y", "z"}));
  const auto misnamed = ChannelReader::compile(type, {"b"}, "labels").value();
  EXPECT_EQ(misnamed.element_names(writer.bytes()).value(), (Names{"b[0]", "b[1]"}));
}

// The values of a message in the order of the elements; nothing if it is left out or refused.
Values ordered(const ChannelReader& reader, ElementOrder& order, const std::string& message) {
  Values values{99.0};
  const auto read = reader.read(message, order, values);
  EXPECT_EQ(read.value_or(false), !values.empty());
  return values;
}

// string[] name, float64[] position
std::string joints(const Names& names, const Values& positions) {
  CdrWriter writer;
  writer.number(static_cast<std::uint32_t>(names.size()));
  for (const std::string& name : names) writer.text(name);
  return writer.numbers(std::span<const double>(positions)).bytes();
}

TEST(ChannelReader, NamesBesideTheValuesAreThoseOfTheElements) {
  const auto type = type_of("string[] name\nfloat64[] position\n");
  const auto reader = ChannelReader::compile(type, {"position"}).value();
  ElementOrder order = reader.order();
  EXPECT_EQ(ordered(reader, order, joints({"b", "a"}, {1, 2})), (Values{1, 2}));
  EXPECT_EQ(ordered(reader, order, joints({"a", "b"}, {2, 1})), (Values{1, 2}));
  EXPECT_EQ(order.names(), (Names{"b", "a"}));
  Values values;
  EXPECT_FALSE(reader.read(joints({"a", "c"}, {1, 2}), order, values));
  EXPECT_FALSE(reader.read(joints({"a"}, {1, 2}), order, values));
}

TEST(ChannelReader, ElementsAreSelectedByName) {
  const auto type = type_of("string[] name\nfloat64[] position\n");
  const auto reader = ChannelReader::compile(type, {"position[wrist,left arm]"}).value();
  ElementOrder order = reader.order();
  EXPECT_EQ(ordered(reader, order, joints({"x"}, {9})), Values{});
  EXPECT_EQ(ordered(reader, order, joints({"left arm", "x", "wrist"}, {1, 2, 3})), (Values{3, 1}));
  EXPECT_EQ(ordered(reader, order, joints({}, {1, 2, 3})), Values{});
  EXPECT_FALSE(ChannelReader::compile(type_of("float64[] x\n"), {"x[a]"}));
  EXPECT_FALSE(ChannelReader::compile(type, {"position[a]", "position"}));
}

TEST(ChannelReader, ElementsOfSeveralPathsHaveTheNamesOfTheirFields) {
  const auto type = type_of("string[] name\nfloat64[] position\nfloat64[] effort\n");
  const auto reader = ChannelReader::compile(type, {"position[b]", "effort[a]"}).value();
  CdrWriter writer;
  writer.number(std::uint32_t{2}).text("a").text("b");
  const Values positions{1, 2};
  const Values efforts{3, 4};
  writer.numbers(std::span<const double>(positions)).numbers(std::span<const double>(efforts));
  ElementOrder order = reader.order();
  EXPECT_EQ(ordered(reader, order, writer.bytes()), (Values{2, 3}));
  EXPECT_EQ(order.names(), (Names{"position[b]", "effort[a]"}));
}

TEST(ChannelReader, TheAdviceNamesElementsThatCanBeSelected) {
  const auto type = type_of("string[] name\nfloat64[] position\n");
  const auto reader = ChannelReader::compile(type, {"position"}).value();
  const auto advice = [&](const std::string& first, const std::string& second) {
    ElementOrder order = reader.order();
    Values values;
    EXPECT_TRUE(reader.read(first, order, values));
    return reader.read(second, order, values).error().advice;
  };
  const std::string unnamed = joints({}, {1, 2});
  EXPECT_NE(advice(unnamed, joints({"a", "b"}, {1, 2})).find("position[a,b]"), std::string::npos);
  EXPECT_NE(advice(joints({"a", "b"}, {1, 2}), unnamed).find("position[a,b]"), std::string::npos);
  const std::string twice = joints({"c", "c"}, {1, 2});
  EXPECT_NE(advice(twice, joints({"a", "b"}, {1, 2})).find("position[a,b]"), std::string::npos);
  EXPECT_NE(advice(twice, unnamed).find("position[NAME]"), std::string::npos);
}

// The interfaces of ros2_control: each joint with any interfaces in any order.
TEST(ChannelReader, NamesOfSeveralLevelsAreJoined) {
  const auto type = type_of(
      "string[] joint_names\nInterfaceValue[] interface_values\n===\nMSG: a/InterfaceValue\n"
      "string[] interface_names\nfloat64[] values\n");
  const auto message = [](bool is_turned) {
    CdrWriter writer;
    writer.number(std::uint32_t{2}).text(is_turned ? "b" : "a").text(is_turned ? "a" : "b");
    writer.number(std::uint32_t{2});
    for (const std::string joint : {is_turned ? "b" : "a", is_turned ? "a" : "b"}) {
      const double first = joint == "a" ? 10.0 : 20.0;
      const bool has_two = joint == "a";
      writer.number(has_two ? std::uint32_t{2} : std::uint32_t{1}).text("position");
      if (has_two) writer.text("effort");
      const Values values = has_two ? Values{first, first + 1} : Values{first};
      writer.numbers(std::span<const double>(values));
    }
    return writer.bytes();
  };
  const auto reader = ChannelReader::compile(type, {"interface_values[*].values"},
                                             "joint_names+interface_values[*].interface_names")
                          .value();
  ElementOrder order = reader.order();
  EXPECT_EQ(ordered(reader, order, message(false)), (Values{10, 11, 20}));
  EXPECT_EQ(order.names(), (Names{"a/position", "a/effort", "b/position"}));
  EXPECT_EQ(ordered(reader, order, message(true)), (Values{10, 11, 20}));
}

TEST(ChannelReader, ATextNamesAllValuesOfItsSensor) {
  const auto type =
      type_of("Sensor[] sensors\n===\nMSG: a/Sensor\nstring name\nfloat32[] values\n");
  const auto message = [](const Names& names, const std::vector<std::size_t>& counts) {
    CdrWriter writer;
    writer.number(static_cast<std::uint32_t>(names.size()));
    for (std::size_t i = 0; i < names.size(); ++i) {
      writer.text(names[i]);
      std::vector<float> values;
      for (std::size_t j = 0; j < counts[i]; ++j) {
        values.push_back(static_cast<float>(10 * names[i][0] + static_cast<int>(j)));
      }
      writer.numbers(std::span<const float>(values));
    }
    return writer.bytes();
  };
  const auto reader = ChannelReader::compile(type, {"sensors[*].values"}).value();
  ElementOrder order = reader.order();
  const Values first = ordered(reader, order, message({"t", "i"}, {2, 1}));
  EXPECT_EQ(order.names(), (Names{"t[0]", "t[1]", "i[0]"}));
  EXPECT_EQ(ordered(reader, order, message({"i", "t"}, {1, 2})), first);
  Values values;
  EXPECT_FALSE(reader.read(message({"t", "i"}, {1, 2}), order, values));
  const auto selected = ChannelReader::compile(type, {"sensors[*].values[i[0],t[1]]"}).value();
  ElementOrder selection = selected.order();
  EXPECT_EQ(ordered(selected, selection, message({"t", "i"}, {2, 1})),
            (Values{first[2], first[1]}));
}

TEST(ChannelReader, ValuesWithoutNamesThatMoveBetweenListsAreRefused) {
  const auto type = type_of("float64[] a\nList[] lists\n===\nMSG: a/List\nfloat64[] x\n");
  const auto message = [](std::size_t first, std::size_t second) {
    CdrWriter writer;
    writer.number(std::uint32_t{0}).number(std::uint32_t{2});
    const Values values(3, 1.0);
    writer.numbers(std::span<const double>(values).first(first));
    writer.numbers(std::span<const double>(values).first(second));
    return writer.bytes();
  };
  const auto reader = ChannelReader::compile(type, {"lists[*].x"}).value();
  ElementOrder order = reader.order();
  EXPECT_EQ(ordered(reader, order, message(1, 2)).size(), 3U);
  EXPECT_EQ(ordered(reader, order, message(1, 2)).size(), 3U);
  Values values;
  EXPECT_FALSE(reader.read(message(2, 1), order, values));
}

TEST(ChannelReader, SequencesOfAnyLengthArePaddedOrCut) {
  const auto type = type_of("int8 a\nPoint[] points\n===\nMSG: a/Point\nint16 x\nint16[2] y\n");
  const auto message = [](int count) {
    CdrWriter writer;
    writer.number(std::int8_t{1}).number(static_cast<std::uint32_t>(count));
    for (int i = 0; i < 3 * count; ++i) writer.number(static_cast<std::int16_t>(i));
    return writer.bytes();
  };
  const auto reader = ChannelReader::compile(type, {"points[*:2]"}).value();
  EXPECT_EQ(values_of(reader, message(3)), (Values{0, 1, 2, 3, 4, 5}));
  const Values padded = values_of(reader, message(1));
  ASSERT_EQ(padded.size(), 6U);
  EXPECT_EQ(Values(padded.begin(), padded.begin() + 3), (Values{0, 1, 2}));
  for (std::size_t i = 3; i < 6; ++i) EXPECT_TRUE(std::isnan(padded[i]));
  const auto inner = ChannelReader::compile(type, {"points[*:2].y[1]"}).value();
  EXPECT_EQ(values_of(inner, message(0)).size(), 2U);
  EXPECT_EQ(inner.element_names(message(0)).value(), (Names{"points[0].y[1]", "points[1].y[1]"}));
  const auto nested = type_of("List[] lists\n===\nMSG: a/List\nfloat64[] x\n");
  EXPECT_FALSE(ChannelReader::compile(nested, {"lists[*:2].x"}));
  EXPECT_TRUE(ChannelReader::compile(nested, {"lists[*:2].x[*:3]"}));
  EXPECT_FALSE(ChannelReader::compile(nested, {"lists[*:100000].x[*:100000]"}));
}

// The law of names: in any frames of any publishers, a value stands under its own name, or the
// message is left out or refused.
TEST(ChannelReader, RandomlyNamedValuesStandUnderTheirNames) {
  const auto type = type_of("string[] name\nfloat64[] position\n");
  const auto any = ChannelReader::compile(type, {"position"}).value();
  const auto chosen = ChannelReader::compile(type, {"position[c,a,f]"}).value();
  std::mt19937 random(40);
  const auto below = [&](std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
  };
  std::size_t stored = 0;
  std::size_t refused = 0;
  constexpr int kSequences = testing::fewer_if_sanitized(100'000);
  for (int sequence = 0; sequence < kSequences; ++sequence) {
    const ChannelReader& reader = sequence % 2 == 0 ? any : chosen;
    ElementOrder order = reader.order();
    const std::size_t joint_count = 1 + below(8);
    for (int i = 0; i < 4; ++i) {
      Names names;
      for (std::size_t j = 0; j < joint_count; ++j)
        names.emplace_back(1, static_cast<char>('a' + j));
      std::shuffle(names.begin(), names.end(), random);
      if (below(3) == 0) names.resize(below(joint_count + 1));
      if (!names.empty() && below(8) == 0) names.push_back(names[below(names.size())]);
      Values positions;
      for (const std::string& name : names) positions.push_back(name[0]);
      Values values;
      const auto read = reader.read(joints(names, positions), order, values);
      if (!read) ++refused;
      if (!read || values.empty()) continue;
      ++stored;
      ASSERT_EQ(values.size(), order.names().size());
      for (std::size_t j = 0; j < values.size(); ++j) ASSERT_EQ(values[j], order.names()[j][0]);
    }
  }
  EXPECT_GT(stored, static_cast<std::size_t>(kSequences / 2));
  EXPECT_GT(refused, static_cast<std::size_t>(kSequences / 2));
}

TEST(ChannelReader, PathsAreRequired) {
  EXPECT_FALSE(ChannelReader::compile(type_of("int8 a\n"), {}));
  EXPECT_FALSE(ChannelReader::compile(type_of("int8 a\n"), {"a"}, "a"));
}

}  // namespace
}  // namespace somato
