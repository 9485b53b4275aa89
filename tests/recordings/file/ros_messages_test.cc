#include "recordings/file/ros_messages.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "recordings/ros/topic_type.h"

namespace somato {
namespace {

using Values = std::vector<double>;

// The channel in messages of that type.
ChannelReader reader_of(const std::string& type) {
  const TopicType topic =
      topic_type({type, "cdr", "ros2msg", standard_definition(type).value_or("")});
  EXPECT_FALSE(topic.channels.empty()) << topic.reason;
  return topic.channels.at(0).reader;
}

Values values_in(const ChannelReader& reader, const std::string& message) {
  Values values;
  EXPECT_TRUE(reader.read(message, values));
  return values;
}

TEST(RosMessages, JointsKeepTheirWholeNames) {
  const std::vector<std::string> names{"thumb", "", "i"};
  const Values positions{0.5, -1.25, 3.0};
  const std::string message = joint_state_message(7'000'000'001, names, positions);
  const ChannelReader reader = reader_of("sensor_msgs/msg/JointState");
  EXPECT_EQ(values_in(reader, message), positions);
  EXPECT_EQ(reader.element_names(message).value(), names);
  EXPECT_TRUE(reader.shape(message).value().empty());
}

TEST(RosMessages, ArraysKeepTheirShape) {
  const ChannelReader reader = reader_of("std_msgs/msg/Float32MultiArray");
  for (const std::vector<std::size_t>& shape :
       {std::vector<std::size_t>{2, 3}, {1, 6}, {3, 1, 2}}) {
    const std::vector<float> values{1, 2, 3, 4, 5, 6};
    const std::string message = float_array_message(shape, values);
    EXPECT_EQ(values_in(reader, message), Values(values.begin(), values.end()));
    EXPECT_EQ(reader.shape(message).value(), shape);
    EXPECT_TRUE(reader.element_names(message).value().empty());
  }
}

TEST(RosMessages, DefinitionsOfFramesAreKnown) {
  EXPECT_TRUE(standard_definition("std_msgs/msg/Float64MultiArray"));
  EXPECT_FALSE(standard_definition("geometry_msgs/msg/Wrench"));
}

}  // namespace
}  // namespace somato
