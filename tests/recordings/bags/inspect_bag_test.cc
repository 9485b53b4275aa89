#include "recordings/bags/inspect_bag.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "base/support/temporary_folder.h"
#include "recordings/bags/made_bag.h"
#include "recordings/file/ros_messages.h"
#include "somato/recording/inspect_recording.h"
#include "somato/recording/recover_recording.h"

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
  made.add(own, 2260, numbers_message({1})).add(own, 2200, numbers_message({1}));
  made.add(own, 1000, numbers_message({1})).finish();
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
  EXPECT_EQ(summary->topics[2].longest_gap, 2'140'000'000);
  EXPECT_EQ(summary->displaced, 1U);
}

TEST(InspectBag, ChannelsAreThoseOfTheFirstMessageWithValues) {
  const TemporaryFolder folder;
  MadeBag made(folder.file("a.mcap"));
  const auto joints =
      made.topic("/joints", "sensor_msgs/msg/JointState", joint_state_schema().data);
  const auto empty = made.topic("/empty", "sensor_msgs/msg/JointState", joint_state_schema().data);
  for (int i = 0; i < 3; ++i) {
    made.add(joints, 10 * i, joint_state_message(0, {"a"}, std::vector<double>(i == 0 ? 0U : 1U)));
    made.add(empty, 10 * i, joint_state_message(0, {}, std::vector<double>()));
  }
  made.finish();
  const auto summary = inspect_bag(find_bags(folder.path()).value()[0]);
  ASSERT_TRUE(summary) << to_string(summary.error());
  ASSERT_EQ(summary->topics[0].channels.size(), 1U);
  EXPECT_EQ(summary->topics[0].reason, "");
  EXPECT_EQ(summary->topics[1].reason, "its messages hold no values");
}

// The rate of a clock that is set back is that of its two parts.
TEST(InspectBag, TheRateIsThatOfTheClockWhileItGoesForward) {
  const TemporaryFolder folder;
  MadeBag made(folder.file("a.mcap"));
  const auto own = made.topic("/own", "a/msg/X", "float64[] x\n");
  for (const int begin : {50000, 10000}) {
    for (int i = 0; i < 11; ++i) made.add(own, begin + 100 * i, numbers_message({1}));
  }
  made.finish();
  const auto summary = inspect_bag(find_bags(folder.path()).value()[0]);
  ASSERT_TRUE(summary) << to_string(summary.error());
  EXPECT_EQ(summary->topics[0].set_back, 1U);
  EXPECT_DOUBLE_EQ(summary->topics[0].rate(), 10.0);
}

// Messages that are in another file than the description says are compared by file: the order of
// their times does not tell which file they are in.
TEST(InspectBag, NumbersOfMessagesAreComparedByFile) {
  const TemporaryFolder folder;
  for (const int file : {0, 1}) {
    MadeBag made(folder.file(file == 0 ? "b_0.mcap" : "b_1.mcap"));
    const auto own = made.topic("/own", "a/msg/X", "float64[] x\n");
    for (int i = 0; i < 3; ++i) made.add(own, 10 * i + 5 * file, numbers_message({1}));
    made.finish();
  }
  const auto remarks = [&](const std::string& counts) {
    std::ofstream(folder.file("metadata.yaml"))
        << "rosbag2_bagfile_information:\n  relative_file_paths:\n    - b_0.mcap\n    - b_1.mcap\n"
        << counts;
    return inspect_bag(find_bags(folder.path()).value()[0]).value().remarks;
  };
  const std::string files =
      "  files:\n    - path: b_0.mcap\n      message_count: 3\n    - path: b_1";
  EXPECT_EQ(remarks(files + ".mcap\n      message_count: 3\n  message_count: 6\n"),
            std::vector<std::string>());
  EXPECT_EQ(
      remarks(files + ".mcap\n      message_count: 9\n"),
      std::vector<std::string>{"metadata.yaml lists 9 messages in 'b_1.mcap', which holds 3"});
  EXPECT_EQ(remarks("  message_count: 7\n"),
            std::vector<std::string>{"metadata.yaml lists 7 messages, the files hold 6"});
}

// A file that is no recording as it is, because of its order or elements, is not damaged.
TEST(InspectBag, FilesOfOtherProgramsAreNotCalledDamaged) {
  const TemporaryFolder folder;
  const std::vector<double> one{0.5};
  for (const bool has_other_names : {false, true}) {
    const std::string path = folder.file(has_other_names ? "names.mcap" : "order.mcap");
    MadeBag made(path);
    const auto joints =
        made.topic("/joints", "sensor_msgs/msg/JointState", joint_state_schema().data);
    made.add(joints, 100, joint_state_message(0, {"a"}, one));
    made.add(joints, has_other_names ? 110 : 90,
             joint_state_message(0, {has_other_names ? "b" : "a"}, one));
    made.add(joints, 120, joint_state_message(0, {"a"}, one)).finish();
    const auto summary = inspect_recording(path);
    ASSERT_TRUE(summary) << to_string(summary.error());
    EXPECT_FALSE(summary->damage);
    ASSERT_TRUE(summary->unfit);
    EXPECT_NE(summary->unfit->advice.find("somato import bag"), std::string::npos);
    const auto report = recover_recording(path, folder.file("copy.mcap"), {});
    ASSERT_TRUE(report) << to_string(report.error());
    EXPECT_TRUE(report->lossless);
    EXPECT_EQ(report->messages, 3U);
    EXPECT_EQ(inspect_bag(find_bags(folder.file("copy.mcap")).value()[0])->topics[0].messages, 3U);
  }
}

// The second name is that of a standard type of ROS, whose definition is not that of messages in
// JSON.
TEST(InspectBag, TopicsInJsonHaveTheirSchema) {
  for (const char* name : {"sensor_msgs/JointState", "sensor_msgs/msg/JointState"}) {
    const TemporaryFolder folder;
    MadeBag made(folder.file("a.mcap"));
    const McapSchema schema{0, name, "jsonschema",
                            R"({"type": "object", "properties": {"name": {"type": "array", "items":
                                {"type": "string"}}, "position": {"type": "array", "items":
                                {"type": "number"}}}})"};
    const auto joints = made.topic("/joints", schema, "json");
    made.add(joints, 5, R"({"name": ["a", "b"], "position": [1, 2]})").finish();
    const auto summary = inspect_bag(find_bags(folder.path()).value()[0]);
    ASSERT_TRUE(summary) << to_string(summary.error());
    ASSERT_EQ(summary->topics[0].channels.size(), 1U) << summary->topics[0].reason;
    EXPECT_EQ(summary->topics[0].channels[0].elements, 2U);
    const auto recording = inspect_recording(folder.file("a.mcap"));
    ASSERT_TRUE(recording) << to_string(recording.error());
    EXPECT_FALSE(recording->damage || recording->unfit);
    ASSERT_EQ(recording->channels.size(), 1U);
  }
}

}  // namespace
}  // namespace somato
