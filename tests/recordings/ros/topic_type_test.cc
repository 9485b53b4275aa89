#include "recordings/ros/topic_type.h"

#include <gtest/gtest.h>

#include <string>

namespace somato {
namespace {

TEST(TopicType, KnownTypesHaveChannelsWithUnits) {
  const TopicType topic =
      topic_type({"geometry_msgs/msg/Wrench", "cdr", "ros2msg",
                  "geometry_msgs/Vector3 force\ngeometry_msgs/Vector3 torque\n===\nMSG: "
                  "geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n"});
  ASSERT_EQ(topic.channels.size(), 2U);
  EXPECT_EQ(topic.channels[0].suffix, "/force");
  EXPECT_EQ(topic.channels[0].unit, "N");
  EXPECT_EQ(topic.channels[1].unit, "N*m");
  EXPECT_TRUE(topic.reason.empty());
}

TEST(TopicType, WithoutChannelsThereIsAReason) {
  const auto reason_of = [](const TopicEncoding& encoding) { return topic_type(encoding).reason; };
  EXPECT_EQ(reason_of({"a/B", "cbor", "", ""}),
            "its messages are in the encoding 'cbor', not in CDR, JSON or protobuf");
  EXPECT_EQ(reason_of({"a/B", "protobuf", "ros2msg", "..."}),
            "its messages are in protobuf, their definition is in the encoding 'ros2msg'");
  EXPECT_EQ(reason_of({"a/B", "json", "jsonschema", "{}"}),
            "JSON Schema: the messages are not objects with properties");
  EXPECT_EQ(reason_of({"a/B", "json", "", ""}), "its messages in JSON have no JSON Schema");
  EXPECT_EQ(reason_of({"a/B", "cdr", "ros2msg", ""}).substr(0, 34),
            "the file holds no definition of a/");
  EXPECT_EQ(reason_of({"std_msgs/msg/Empty", "cdr", "ros2msg", ""}),
            "its messages hold no numbers");
  EXPECT_EQ(reason_of({"a/B", "cdr", "ros2msg", "int8 a\nfloat64[] b\n"}),
            "a/B is not a known type; its numbers: a, b[*]");
  EXPECT_EQ(reason_of({"a/B", "cdr", "ros2msg", "string a\n"}), "its messages hold no numbers");
  EXPECT_EQ(reason_of({"geometry_msgs/msg/Wrench", "cdr", "ros2msg", "int8 a\n"}),
            "geometry_msgs/msg/Wrench has other fields than the known type of that name; its "
            "numbers: a");
  EXPECT_EQ(reason_of({"a/B", "cdr", "ros2msg", "int8[9] a\nC c\n"}),
            "definition of a/B:2: there is no definition of 'a/C'");
  EXPECT_EQ(reason_of({"a/B", "cdr", "ros2msg",
                       "int8 a\nint8 b\nint8 c\nint8 d\nint8 e\nint8 f\nint8 g\n"}),
            "a/B is not a known type; its numbers: a, b, c, d, e, f, ...");
}

}  // namespace
}  // namespace somato
