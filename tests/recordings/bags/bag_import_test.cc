#include "recordings/bags/bag_import.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/support/temporary_folder.h"
#include "recordings/bags/made_bag.h"
#include "recordings/bags/made_sqlite_bag.h"
#include "recordings/explorations/collected_explorations.h"
#include "recordings/file/ros_messages.h"

namespace somato {
namespace {

namespace fs = std::filesystem;

// The explorations of an import.
struct Imported {
  Result<BagImportReport> report;
  std::vector<Exploration> explorations;

  std::string refusal() const { return report ? "imported" : to_string(report.error()); }
};

Imported imported(const std::string& path, const BagImport& description) {
  std::vector<Exploration> explorations;
  CollectedExplorations collected([&](Exploration exploration) {
    explorations.push_back(std::move(exploration));
    return Result<void>();
  });
  auto report = import_bags(path, description, collected, [] { return true; });
  return {std::move(report), std::move(explorations)};
}

// Ten frames of /x, one each 100 ms with its number as value; two events name objects.
class BagImportTest : public ::testing::Test {
 protected:
  BagImportTest() {
    MadeBag made(path_);
    const auto x = made.topic("/x", "a/msg/X", "float64[] x\n");
    const auto event = made.topic("/object", "std_msgs/msg/String", "string data\n");
    for (int i = 0; i < 10; ++i) {
      if (i == 2) made.add(event, 150, text_message("cup"));
      if (i == 5) made.add(event, 450, text_message("ball"));
      if (i == 8) made.add(event, 750, text_message(""));
      made.add(x, 100 * i, numbers_message({static_cast<double>(i), 10.0 * i}));
    }
    made.finish();
    description_.channels.push_back({"touch", "N", "/x", {"x"}, "", {}, 1.0});
  }

  static std::vector<float> first_values(const Exploration& exploration) {
    std::vector<float> values;
    const Matrix<float>& frames = exploration.channels[0].frames;
    for (std::size_t i = 0; i < frames.rows(); ++i) values.push_back(frames(i, 0));
    return values;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("a.mcap");
  BagImport description_;
};

using FloatValues = std::vector<float>;

TEST_F(BagImportTest, ABagIsOneExploration) {
  description_.labels.push_back({"hand", "LEAP", "", ""});
  description_.channels[0].factor = 0.5;
  const Imported result = imported(path_, description_);
  ASSERT_TRUE(result.report) << result.refusal();
  ASSERT_EQ(result.explorations.size(), 1U);
  const Exploration& exploration = result.explorations[0];
  EXPECT_EQ(exploration.labels, (std::vector<Label>{{"hand", "LEAP"}}));
  EXPECT_EQ(exploration.channels[0].unit, "N");
  EXPECT_EQ(exploration.channels[0].element_names, (std::vector<std::string>{"x[0]", "x[1]"}));
  EXPECT_EQ(exploration.channels[0].frames.rows(), 10U);
  EXPECT_EQ(exploration.channels[0].frames(9, 1), 45.0F);
  EXPECT_DOUBLE_EQ(exploration.channels[0].times[9], 0.9);
  ASSERT_EQ(result.report->left_out.size(), 1U);
  EXPECT_EQ(result.report->left_out[0].topic, "/object");
  EXPECT_EQ(result.report->left_out[0].messages, 3U);
}

TEST_F(BagImportTest, EventsCutAndNameExplorations) {
  description_.trials.events = "/object:data";
  description_.labels.push_back({"object", "", "/object", "data"});
  const Imported result = imported(path_, description_);
  ASSERT_TRUE(result.report) << result.refusal();
  ASSERT_EQ(result.explorations.size(), 2U);
  EXPECT_EQ(result.explorations[0].labels, (std::vector<Label>{{"object", "cup"}}));
  EXPECT_EQ(result.explorations[1].labels, (std::vector<Label>{{"object", "ball"}}));
  EXPECT_EQ(first_values(result.explorations[0]), (FloatValues{2, 3, 4}));
  EXPECT_EQ(first_values(result.explorations[1]), (FloatValues{5, 6, 7}));
  EXPECT_EQ(result.explorations[1].channels[0].times[0], 0.0);
  EXPECT_EQ(result.report->frames_outside, 4U);
  EXPECT_TRUE(result.report->left_out.empty());
}

TEST_F(BagImportTest, SpansCutAndNameExplorations) {
  description_.trials.spans =
      folder_.with("spans.csv", "begin,end,object\n0.1,0.3,cup\n0.3,0.35,ball\n0.8,9,jar\n");
  const Imported result = imported(path_, description_);
  ASSERT_TRUE(result.report) << result.refusal();
  ASSERT_EQ(result.explorations.size(), 3U);
  EXPECT_EQ(first_values(result.explorations[0]), (FloatValues{1, 2}));
  EXPECT_EQ(first_values(result.explorations[1]), (FloatValues{3}));
  EXPECT_EQ(first_values(result.explorations[2]), (FloatValues{8, 9}));
  EXPECT_EQ(result.explorations[2].labels, (std::vector<Label>{{"object", "jar"}}));
}

TEST_F(BagImportTest, GapsCutExplorations) {
  MadeBag made(path_);
  const auto x = made.topic("/x", "a/msg/X", "float64[] x\n");
  const auto label = made.topic("/object", "std_msgs/msg/String", "string data\n");
  made.add(label, 0, text_message("cup")).add(x, 0, numbers_message({0}));
  made.add(x, 100, numbers_message({1})).add(label, 2000, text_message("ball"));
  made.add(x, 2100, numbers_message({2})).finish();
  description_.trials.gap = 1.0;
  description_.labels.push_back({"object", "", "/object", "data"});
  const Imported result = imported(path_, description_);
  ASSERT_TRUE(result.report) << result.refusal();
  ASSERT_EQ(result.explorations.size(), 2U);
  EXPECT_EQ(first_values(result.explorations[0]), (FloatValues{0, 1}));
  EXPECT_EQ(result.explorations[0].labels[0].value, "cup");
  EXPECT_EQ(result.explorations[1].labels[0].value, "ball");
}

TEST_F(BagImportTest, NamesOfBagsGiveLabels) {
  fs::create_directory(folder_.file("all"));
  fs::copy(path_, folder_.file("all/cup_2.mcap"));
  fs::copy(path_, folder_.file("all/cup_10.mcap"));
  description_.trials.files = "{object}_{trial:number}.mcap";
  const Imported result = imported(folder_.file("all"), description_);
  ASSERT_TRUE(result.report) << result.refusal();
  ASSERT_EQ(result.explorations.size(), 2U);
  EXPECT_EQ(result.explorations[1].labels,
            (std::vector<Label>{{"object", "cup"}, {"trial", "10"}}));
  fs::copy(path_, folder_.file("all/other.mcap"));
  EXPECT_FALSE(imported(folder_.file("all"), description_).report);
  description_.trials.other_files = Unmentioned::kIgnore;
  EXPECT_EQ(imported(folder_.file("all"), description_).explorations.size(), 2U);
}

TEST_F(BagImportTest, FramesMayHaveTheTimeOfTheirHeader) {
  MadeBag made(path_);
  const auto x = made.topic("/x", "a/msg/X",
                            "std_msgs/Header header\nfloat64[] x\n===\nMSG: std_msgs/Header\n"
                            "builtin_interfaces/Time stamp\nstring frame_id\n");
  made.add(x, 1, stamped_message(70, {1})).add(x, 2, stamped_message(72, {2}));
  made.add(x, 3, stamped_message(71, {3})).finish();
  EXPECT_EQ(imported(path_, description_).explorations[0].channels[0].times[2], 0.002);
  description_.trials.clock = BagClock::kHeader;
  EXPECT_NE(imported(path_, description_).refusal().find("the clock of 'touch' is set back by 1 s"),
            std::string::npos);
  description_.trials.jumps = ClockJumps::kCut;
  const Imported result = imported(path_, description_);
  ASSERT_EQ(result.explorations.size(), 2U) << result.refusal();
  EXPECT_EQ(result.explorations[0].channels[0].times, (std::vector<double>{0.0, 2.0}));
  EXPECT_EQ(first_values(result.explorations[1]), (FloatValues{3}));
}

TEST_F(BagImportTest, WithoutADescriptionKnownTypesAreChannels) {
  MadeBag made(path_);
  const auto joints =
      made.topic("/joints", "sensor_msgs/msg/JointState", joint_state_schema().data);
  const auto text = made.topic("/text", "std_msgs/msg/String", "string data\n");
  made.add(text, 0, text_message("a"));
  made.add(joints, 0, joint_state_message(0, {"a"}, std::vector<double>{0.5})).finish();
  const Imported result = imported(path_, {});
  ASSERT_TRUE(result.report) << result.refusal();
  ASSERT_EQ(result.explorations[0].channels.size(), 1U);
  EXPECT_EQ(result.explorations[0].channels[0].name, "joints");
  EXPECT_EQ(result.explorations[0].channels[0].unit, "rad");
  EXPECT_EQ(result.explorations[0].channels[0].element_names, (std::vector<std::string>{"a"}));
  EXPECT_EQ(result.report->left_out[0].reason, "its messages hold no numbers");
}

TEST_F(BagImportTest, MistakesAreNamedWithTheirPlace) {
  const auto refusal = [&](BagImport description) {
    return imported(path_, description).refusal();
  };
  BagImport other = description_;
  other.channels[0].topic = "/xx";
  EXPECT_NE(refusal(other).find("/x"), std::string::npos);
  EXPECT_FALSE(imported(path_, other).report);
  other = description_;
  other.channels[0].fields = {"x[0..2]"};
  EXPECT_NE(refusal(other).find("topic /x at 0.000000 s"), std::string::npos) << refusal(other);
  other = description_;
  other.channels[0].shape = {3};
  EXPECT_NE(refusal(other).find("do not fill its shape"), std::string::npos);
  other = description_;
  other.labels.push_back({"object", "", "/nothing", "data"});
  EXPECT_NE(refusal(other).find("no message of /nothing"), std::string::npos);
  other = description_;
  other.trials.spans = folder_.with("late.csv", "begin,end\n50,60\n");
  EXPECT_NE(refusal(other).find("there are no explorations"), std::string::npos);
}

TEST_F(BagImportTest, FramesOfAnotherLengthAreRefused) {
  MadeBag made(path_);
  const auto x = made.topic("/x", "a/msg/X", "float64[] x\n");
  made.add(x, 0, numbers_message({1, 2})).add(x, 10, numbers_message({1})).finish();
  EXPECT_NE(imported(path_, description_).refusal().find("has 1 elements, the first one 2"),
            std::string::npos);
}

// Messages of /joints, each of the joints with these names; the position of a joint is that of its
// letter in the alphabet plus the number of the message / 100.
// A bag in SQLite lists its topics at its start, used or not, such as /rosout.
TEST_F(BagImportTest, UnusedTopicsAtTheEndAreCountedAsEmpty) {
  const std::string path = folder_.file("b.db3");
  {
    MadeSqliteBag made(path, "/x", "a/msg/X", "float64[] x\n");
    made.add_unused_topic("/rosout", "a/msg/Log");
    for (int i = 0; i < 3; ++i) made.add(1'000'000 * i, numbers_message({1.0 * i, 2.0}));
  }
  const Imported result = imported(path, description_);
  ASSERT_TRUE(result.report) << to_string(result.report.error());
  ASSERT_EQ(result.report->left_out.size(), 1U);
  EXPECT_EQ(result.report->left_out[0].topic, "/rosout");
  EXPECT_EQ(result.report->left_out[0].messages, 0U);
}

class NamedJointsTest : public ::testing::Test {
 protected:
  struct Sent {
    std::int64_t time;  // ms
    std::vector<std::string> names;
  };

  void make(const std::string& path, const std::vector<Sent>& sent) {
    MadeBag made(path);
    const auto joints =
        made.topic("/joints", "sensor_msgs/msg/JointState", joint_state_schema().data);
    for (std::size_t i = 0; i < sent.size(); ++i) {
      std::vector<double> positions;
      for (const std::string& name : sent[i].names) {
        positions.push_back(name[0] - 'a' + 0.01 * static_cast<double>(i));
      }
      made.add(joints, sent[i].time, joint_state_message(0, sent[i].names, positions));
    }
    made.finish();
  }

  Imported of(const std::vector<Sent>& sent, const std::string& channels = {}) {
    make(path_, sent);
    BagImport description;
    if (!channels.empty()) description.channels = parse_bag_channels(channels).value();
    return imported(path_, description);
  }

  static FloatValues row(const Exploration& exploration, std::size_t channel, std::size_t frame) {
    FloatValues rounded;
    for (const float value : exploration.channels[channel].frames.row(frame)) {
      rounded.push_back(std::floor(value));
    }
    return rounded;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("a.mcap");
};

TEST_F(NamedJointsTest, ValuesArePlacedByTheirNames) {
  const Imported result = of({{0, {"b", "a", "c"}}, {10, {"a", "b", "c"}}, {20, {"c", "b", "a"}}});
  ASSERT_TRUE(result.report) << result.refusal();
  const Channel& channel = result.explorations[0].channels[0];
  EXPECT_EQ(channel.element_names, (std::vector<std::string>{"b", "a", "c"}));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(row(result.explorations[0], 0, i), (FloatValues{1, 0, 2})) << i;
  }
}

TEST_F(NamedJointsTest, TheOrderIsTheSameInAllBags) {
  make(folder_.file("1.mcap"), {{0, {"a", "b"}}});
  make(folder_.file("2.mcap"), {{0, {"b", "a"}}});
  const Imported result = imported(folder_.path(), {});
  ASSERT_TRUE(result.report) << result.refusal();
  EXPECT_EQ(row(result.explorations[1], 0, 0), (FloatValues{0, 1}));
}

TEST_F(NamedJointsTest, OtherNamesAreRefusedWithTopicTimeAndBothLists) {
  const std::string refusal = of({{0, {"a", "b"}}, {2500, {"c", "d"}}}).refusal();
  EXPECT_NE(refusal.find("topic /joints at 2.500000 s"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("'c', 'd'; those of the first frame are 'a', 'b'"), std::string::npos);
  EXPECT_NE(refusal.find("position[a,b]"), std::string::npos) << refusal;
  const std::string by_number =
      of({{0, {"a", "b"}}, {10, {"c", "d"}}}, "arm=/joints:position[0]").refusal();
  EXPECT_NE(by_number.find("'c'; those of the first frame are 'a'"), std::string::npos);
}

TEST_F(NamedJointsTest, SelectedElementsAreReadAndOtherMessagesCounted) {
  const Imported result = of({{0, {"f"}}, {10, {"a", "b", "c"}}, {20, {"f"}}, {30, {"c", "a"}}},
                             "arm:rad=/joints:position[c,a],grip:rad=/joints:position[f]");
  ASSERT_TRUE(result.report) << result.refusal();
  const Exploration& exploration = result.explorations[0];
  EXPECT_EQ(exploration.channels[0].element_names, (std::vector<std::string>{"c", "a"}));
  ASSERT_EQ(exploration.channels[0].frames.rows(), 2U);
  EXPECT_EQ(row(exploration, 0, 0), (FloatValues{2, 0}));
  EXPECT_EQ(row(exploration, 0, 1), (FloatValues{2, 0}));
  EXPECT_EQ(exploration.channels[1].frames.rows(), 2U);
  ASSERT_EQ(result.report->left_out.size(), 2U);
  EXPECT_EQ(result.report->left_out[0].messages, 2U);
  EXPECT_EQ(result.report->left_out[0].reason, "without all elements of channel 'arm'");
  const std::string refusal =
      of({{0, {"aa", "b"}}, {10, {"f"}}}, "arm=/joints:position[ab]").refusal();
  EXPECT_NE(refusal.find("unknown element 'ab'"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("aa"), std::string::npos) << refusal;
}

TEST_F(NamedJointsTest, MessagesWithoutValuesAreCounted) {
  const Imported result = of({{0, {}}, {10, {"a", "b"}}, {20, {}}, {30, {"b", "a"}}});
  ASSERT_TRUE(result.report) << result.refusal();
  EXPECT_EQ(result.explorations[0].channels[0].frames.rows(), 2U);
  ASSERT_EQ(result.report->left_out.size(), 1U);  // Not the velocities, which no message has.
  EXPECT_EQ(result.report->left_out[0].messages, 2U);
  EXPECT_EQ(result.report->left_out[0].reason, "without values of channel 'joints'");
}

TEST_F(NamedJointsTest, PaddedElementsArePlacedByTheirNames) {
  const std::string padded = "arm=/joints:position[*:4]";
  const Imported result = of({{0, {"b", "a"}}, {10, {"a", "b"}}}, padded);
  ASSERT_TRUE(result.report) << result.refusal();
  const Channel& channel = result.explorations[0].channels[0];
  EXPECT_EQ(channel.element_names,
            (std::vector<std::string>{"b", "a", "position[2]", "position[3]"}));
  EXPECT_EQ(row(result.explorations[0], 0, 0), (FloatValues{1, 0, 0, 0}));
  EXPECT_EQ(row(result.explorations[0], 0, 1), (FloatValues{1, 0, 0, 0}));
  const std::string refusal = of({{0, {"a", "b"}}, {10, {"b"}}}, padded).refusal();
  EXPECT_NE(refusal.find("position[a,b]"), std::string::npos) << refusal;
}

TEST_F(NamedJointsTest, MessagesOutOfOrderAreSortedByTime) {
  const Imported result = of({{20, {"a"}}, {0, {"a"}}, {10, {"a"}}});
  ASSERT_TRUE(result.report) << result.refusal();
  EXPECT_EQ(result.explorations[0].channels[0].times, (std::vector<double>{0.0, 0.01, 0.02}));
  EXPECT_FLOAT_EQ(result.explorations[0].channels[0].frames(0, 0), 0.01F);
}

TEST_F(NamedJointsTest, TimesBeforeTheYear2000BesideOthersAreRefusedOrCut) {
  const std::vector<Sent> sent{
      {5000, {"a"}}, {5010, {"a"}}, {1'700'000'000'000, {"a"}}, {1'700'000'000'010, {"a"}}};
  const std::string refusal = of(sent).refusal();
  EXPECT_NE(refusal.find("has the time 2023-11-14 22:13:20 UTC, and the exploration begins at 5 s"),
            std::string::npos)
      << refusal;
  BagImport cut;
  cut.trials.jumps = ClockJumps::kCut;
  const Imported result = imported(path_, cut);
  ASSERT_TRUE(result.report) << result.refusal();
  EXPECT_EQ(result.explorations.size(), 2U);
  EXPECT_TRUE(of({{5000, {"a"}}, {5010, {"a"}}}).report);
}

TEST_F(NamedJointsTest, DifferencesFromTheDescriptionOfTheBagAreRemarks) {
  make(folder_.file("b_0.mcap"), {{0, {"a"}}, {10, {"a"}}});
  make(folder_.file("b_1.mcap"), {{20, {"a"}}});
  (void)folder_.with("metadata.yaml",
                     "topics_with_message_count:\n  - topic_metadata:\n      name: /joints\n    "
                     "message_count: 3\nrelative_file_paths:\n  - b_0.mcap\n");
  const Imported result = imported(folder_.path(), {});
  ASSERT_TRUE(result.report) << result.refusal();
  ASSERT_EQ(result.report->remarks.size(), 2U);
  EXPECT_NE(result.report->remarks[0].find("does not list 'b_1.mcap'"), std::string::npos);
  EXPECT_NE(result.report->remarks[1].find("lists 3 messages of /joints, the files hold 2"),
            std::string::npos);
}

}  // namespace
}  // namespace somato
