#include "recordings/ros/known_types.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace somato {
namespace {

TEST(KnownTypes, NamesAndSuffixesAreUnique) {
  std::set<std::string_view> names;
  for (const KnownType& type : known_types()) {
    EXPECT_TRUE(names.insert(type.name).second) << type.name;
    std::set<std::string_view> suffixes;
    EXPECT_FALSE(type.channels.empty());
    for (const KnownChannel& channel : type.channels) {
      EXPECT_TRUE(suffixes.insert(channel.suffix).second) << type.name << channel.suffix;
    }
  }
  EXPECT_GE(names.size(), 12U);
}

TEST(KnownTypes, AreFoundByBothFormsOfTheirName) {
  ASSERT_NE(known_type("sensor_msgs/msg/JointState"), nullptr);
  EXPECT_EQ(known_type("sensor_msgs/msg/JointState"), known_type("sensor_msgs/JointState"));
  EXPECT_EQ(known_type("sensor_msgs/msg/JointState")->channels[2].unit, "N*m");
  EXPECT_EQ(known_type("sensor_msgs/msg/Image"), nullptr);
}

}  // namespace
}  // namespace somato
