#include "recordings/bags/inspect_bag.h"

#include <gtest/gtest.h>

#include <string>

#include "base/support/temporary_folder.h"
#include "recordings/bags/made_bag.h"
#include "recordings/file/ros_messages.h"

namespace somato {
namespace {

TEST(InspectBag, EveryTopicHasChannelsOrAReason) {
  const TemporaryFolder folder;
  MadeBag made(folder.file("a.mcap"));
  const auto joints =
      made.topic("/joints", "sensor_msgs/msg/JointState", joint_state_schema().data);
  const auto text = made.topic("/text", "std_msgs/msg/String", "string data\n");
  const auto own = made.topic("/own", "a/msg/X", "float64[] x\n");
  for (int i = 0; i < 5; ++i) {
    made.add(joints, 10 * i, joint_state_message(0, {"a"}, std::vector<double>{0.5}));
  }
  made.add(text, 50, text_message("a")).add(own, 60, numbers_message({1}));
  made.add(own, 260, numbers_message({1})).add(own, 200, numbers_message({1})).finish();
  const auto summary = inspect_bag(find_bags(folder.path()).value()[0]);
  ASSERT_TRUE(summary) << to_string(summary.error());
  ASSERT_EQ(summary->topics.size(), 3U);
  EXPECT_FALSE(summary->damage);
  const TopicSummary& states = summary->topics[0];
  ASSERT_EQ(states.channels.size(), 1U);  // Velocities and efforts are empty.
  EXPECT_EQ(states.channels[0].name, "joints");
  EXPECT_EQ(states.channels[0].unit, "rad");
  EXPECT_EQ(states.messages, 5U);
  EXPECT_DOUBLE_EQ(states.rate(), 100.0);
  EXPECT_EQ(summary->topics[1].reason, "its messages hold no numbers");
  EXPECT_EQ(summary->topics[1].rate(), 0.0);
  EXPECT_EQ(summary->topics[2].reason, "a/msg/X is not a known type; its numbers: x[*]");
  EXPECT_EQ(summary->topics[2].set_back, 1U);
  EXPECT_EQ(summary->topics[2].longest_gap, 200'000'000);
}

}  // namespace
}  // namespace somato
