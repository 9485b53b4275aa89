#include "recordings/ros/field_line.h"

#include <gtest/gtest.h>

#include <string>

namespace somato {
namespace {

using Kind = RosField::Kind;

DeclaredField declared(const std::string& line) {
  return parse_field_line(line).value().value();
}

bool declares_nothing(const std::string& line) {
  const auto field = parse_field_line(line);
  return field && !*field;
}

TEST(FieldLine, ArraysAndSequencesHaveTheirLengths) {
  EXPECT_EQ(declared("float64 x").field.kind, Kind::kOne);
  EXPECT_EQ(declared("float64[] x").field.kind, Kind::kSequence);
  EXPECT_EQ(declared("float64[] x").field.length, kUnbounded);
  EXPECT_EQ(declared("float64[<=7] x").field.kind, Kind::kSequence);
  EXPECT_EQ(declared("float64[<=7] x").field.length, 7U);
  EXPECT_EQ(declared("float64[36] x").field.kind, Kind::kArray);
  EXPECT_EQ(declared("float64[36] x").field.length, 36U);
  EXPECT_EQ(declared("string<=10[<=5] names").field.length, 5U);
  EXPECT_EQ(declared("string<=10[<=5] names").field.primitive, RosPrimitive::kString);
}

TEST(FieldLine, TypesAreKnownOrNamed) {
  EXPECT_EQ(declared("byte b").field.primitive, RosPrimitive::kUint8);
  EXPECT_EQ(declared("char c").field.primitive, RosPrimitive::kUint8);
  EXPECT_EQ(declared("wstring w").field.primitive, RosPrimitive::kWstring);
  EXPECT_EQ(declared("std_msgs/Header header").type, "std_msgs/Header");
  EXPECT_FALSE(declared("std_msgs/Header header").is_primitive);
  EXPECT_EQ(declared("  PillarState[]\tpillars  # all").type, "PillarState");
  EXPECT_EQ(declared("float32 gfX").field.name, "gfX");
}

TEST(FieldLine, DefaultsAreLeftOutAndConstantsAreNoFields) {
  EXPECT_EQ(declared("int32 x 5").field.name, "x");
  EXPECT_EQ(declared("int32[] x [1, 2, 3]").field.name, "x");
  EXPECT_EQ(declared("string s \"a = b\"").field.name, "s");
  EXPECT_TRUE(declares_nothing("uint8 KIND_TOUCH=3"));
  EXPECT_TRUE(declares_nothing("string NAME = one word # and more"));
  EXPECT_TRUE(declares_nothing("   "));
  EXPECT_TRUE(declares_nothing("# int8 x"));
}

TEST(FieldLine, OtherLinesAreRefused) {
  for (const std::string line :
       {"float64", "float64[0] x", "float64[-1] x", "float64[ x", "float64[99999999999] x",
        "int32<=3 x", "string<=0 x", "7up x", "float64 7x", "float64 x-y", "Part X=1",
        "float64[] X=1", "[3] x", "a b$"}) {
    EXPECT_FALSE(parse_field_line(line)) << line;
  }
}

}  // namespace
}  // namespace somato
