#include "recordings/ros/definition.h"

#include <gtest/gtest.h>

#include <string>

namespace somato {
namespace {

const std::string kRule = std::string(80, '=') + "\n";

std::string place_of(const Result<RosType>& type) {
  return type ? "compiled" : type.error().where;
}

std::string what_of(const Result<RosType>& type) {
  return type ? "compiled" : type.error().what;
}

TEST(Definition, TypesComeAfterThoseThatTheyContain) {
  const auto type = compile_ros_definition(
      "a_msgs/msg/Top", "ros2msg",
      "std_msgs/Header header\nPart[] parts\n" + kRule +
          "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + kRule +
          "MSG: a_msgs/msg/Part\r\nfloat64[3] x\r\nuint8[<=5] bytes\r\n");
  ASSERT_TRUE(type) << to_string(type.error());
  ASSERT_EQ(type->structures.size(), 4U);
  EXPECT_EQ(type->structures[0].name, "builtin_interfaces/Time");
  EXPECT_EQ(type->structures[1].name, "std_msgs/Header");
  EXPECT_EQ(type->structures[2].name, "a_msgs/Part");
  EXPECT_EQ(type->root().name, "a_msgs/Top");
  EXPECT_EQ(type->root().fields[1].structure, 2U);
  EXPECT_EQ(type->structures[0].least_bytes, 8U);
  EXPECT_EQ(type->structures[1].least_bytes, 12U);
  EXPECT_EQ(type->structures[2].least_bytes, 28U);  // Three numbers, and the length of none.
  EXPECT_EQ(type->root().least_bytes, 16U);
}

TEST(Definition, ATypeWithoutFieldsTakesAByte) {
  const auto type = compile_ros_definition("std_msgs/msg/Empty", "ros2msg", "# nothing\n");
  EXPECT_EQ(type.value().root().least_bytes, 1U);
}

TEST(Definition, OldNamesOfTimeAndHeaderAreKnown) {
  const auto type =
      compile_ros_definition("a/B", "ros2msg",
                             "Header header\ntime t\nduration d\n" + kRule +
                                 "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id");
  ASSERT_TRUE(type) << to_string(type.error());
  EXPECT_EQ(type->root().least_bytes, 16U + 8U + 8U);
}

TEST(Definition, ErrorsNameTheLineOfTheWholeText) {
  const std::string whole = "Part p\n\n" + kRule + "MSG: a/Part\nint32 x\nint32\n";
  EXPECT_EQ(place_of(compile_ros_definition("a/B", "ros2msg", whole)), "definition of a/B:6");
  EXPECT_EQ(place_of(compile_ros_definition("a/B", "ros2msg", "int8 a\nb/Missing m\n")),
            "definition of a/B:2");
  EXPECT_EQ(place_of(compile_ros_definition("a/B", "ros2msg", "int8 a\nint8 a\n")),
            "definition of a/B:2");
}

TEST(Definition, ATypeThatContainsItselfIsRefused) {
  const auto type = compile_ros_definition("a/B", "ros2msg", "C c\n" + kRule + "MSG: a/C\nB[] b\n");
  EXPECT_EQ(what_of(type).substr(0, 22), "'a/B' contains itself,") << what_of(type);
}

TEST(Definition, ManyLevelsOfTypesAreRefused) {
  const auto nested = [](int levels) {
    std::string text = "T1 next\n";
    for (int i = 1; i < levels; ++i) {
      text += kRule + "MSG: a/T" + std::to_string(i) + "\n";
      text += i + 1 < levels ? "T" + std::to_string(i + 1) + " next\n" : "int8 x\n";
    }
    return compile_ros_definition("a/T0", "ros2msg", text);
  };
  EXPECT_TRUE(nested(32));
  EXPECT_FALSE(nested(33));
}

TEST(Definition, HugeArraysDoNotOverflow) {
  std::string text = "T1[4294967295] x\n";
  for (const std::string i : {"1", "2", "3"}) {
    text += kRule + "MSG: a/T" + i + "\n" +
            (i == "3" ? std::string("float64[4294967295] x\n")
                      : "T" + std::to_string(std::stoi(i) + 1) + "[4294967295] x\n");
  }
  EXPECT_EQ(compile_ros_definition("a/T0", "ros2msg", text).value().root().least_bytes, kUnbounded);
}

TEST(Definition, OtherEncodingsAreNamed) {
  EXPECT_EQ(what_of(compile_ros_definition("a/B", "ros2idl", "module a {};")),
            "its definition is in the encoding 'ros2idl', not in ros2msg");
}

TEST(Definition, TheFirstDefinitionOfANameIsUsed) {
  RosDefinitions definitions;
  definitions.add("a/msg/B", "int8 x\n", "B.msg");
  definitions.add("a/B", "int8 x\nint8 y\n", "other/B.msg");
  EXPECT_TRUE(definitions.has("a/msg/B"));
  EXPECT_EQ(definitions.compile("a/B").value().root().fields.size(), 1U);
}

}  // namespace
}  // namespace somato
