#include "recordings/ros/message_type.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

RosField field_of(RosPrimitive primitive, RosField::Kind kind, std::size_t length) {
  RosField field;
  field.primitive = primitive;
  field.kind = kind;
  field.length = length;
  return field;
}

// A sequence or text at least has its length; each element of an array has the least of one.
TEST(MessageType, LeastBytesCountElements) {
  RosType type{{{"a/B", {}, 6}}};
  EXPECT_EQ(least_bytes_of(type, field_of(RosPrimitive::kFloat64, RosField::Kind::kOne, 1)), 8U);
  EXPECT_EQ(least_bytes_of(type, field_of(RosPrimitive::kInt16, RosField::Kind::kArray, 5)), 10U);
  EXPECT_EQ(least_bytes_of(type, field_of(RosPrimitive::kInt16, RosField::Kind::kSequence, 5)), 4U);
  EXPECT_EQ(least_bytes_of(type, field_of(RosPrimitive::kString, RosField::Kind::kArray, 5)), 20U);
  RosField parts = field_of(RosPrimitive::kUint8, RosField::Kind::kArray, 5);
  parts.structure = 0;
  EXPECT_EQ(least_bytes_of(type, parts), 30U);
}

}  // namespace
}  // namespace somato
