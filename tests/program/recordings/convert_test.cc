#include <string>

#include "program/support/program_test.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

class Convert : public ProgramTest {
 protected:
  Convert() {
    Recording recording;
    for (const char* object : {"cup", "ball"}) {
      Channel touch{"touch", "N", {}, Matrix<float>(2, 3, 0.1F), {0.0, 0.5}, 0.0};
      recording.explorations.push_back({{{"object", object}}, "", {touch}});
    }
    EXPECT_TRUE(write_recording(path("a.mcap"), recording));
  }

  // The recording in a file, without the sources of the explorations and the names of elements.
  Recording recording(const std::string& name) const {
    Recording recording = read_recording(path(name)).value();
    for (Exploration& exploration : recording.explorations) {
      exploration.source.clear();
      for (Channel& channel : exploration.channels) channel.element_names.clear();
    }
    return recording;
  }
};

TEST_F(Convert, TablesAndBagsAreImportedAgain) {
  EXPECT_EQ(output_of({"convert", "a.mcap", "-o", "a_csv"}), "a_csv: 2 explorations\n");
  output_of(
      {"import", "csv", "a_csv/touch.csv", "-o", "b.mcap", "--description", "a_csv/touch.toml"});
  EXPECT_TRUE(recording("b.mcap") == recording("a.mcap"));
  EXPECT_EQ(output_of({"convert", "a.mcap", "-o", "rosbag", "--format", "bag"}),
            "rosbag: 2 explorations\n");
  output_of({"import", "bag", "rosbag", "-o", "c.mcap", "--description", "rosbag/import.toml"});
  EXPECT_TRUE(recording("c.mcap") == recording("a.mcap"));
}

TEST_F(Convert, HandsAreShownInFoxglove) {
  write(
      "tubes.toml",
      "[object]\ntube = { shape = 'cylinder', diameter = 62, height = 121, material = 'wood' }\n");
  write("short.toml", "[plan]\ngrasps = 2\n");
  output_of({"explore", "--body", "lucs2", "--objects", "tubes.toml", "--settings", "short.toml",
             "--explorations", "2", "-o", "hand.mcap"});
  EXPECT_EQ(output_of({"convert", "hand.mcap", "-o", "hand_foxglove"}),
            "hand_foxglove: 2 explorations\n");
  EXPECT_NE(read("hand_foxglove/foxglove_layout.json").find("\"/taxels\""), std::string::npos);
  const std::string topics = output_of({"inspect", "hand_foxglove"});
  EXPECT_NE(topics.find("\"/tf\": tf2_msgs/msg/TFMessage"), std::string::npos) << topics;
}

TEST_F(Convert, DataSetsAreConverted) {
  output_of({"convert", kTrials, "-o", "grasps.npz"});
  EXPECT_TRUE(read("grasps.npz").starts_with("PK\3\4"));
}

TEST_F(Convert, WhatIsRefusedLeavesNothingBehind) {
  const std::string whole = read("a.mcap");
  write("damaged.mcap", whole.substr(0, whole.size() / 2));
  write("there_csv", "");
  expect_refused(2, {{{"convert", "a.mcap", "-o", "b.mcap"}, {"b.mcap", "--format"}},
                     {{"convert", "a.mcap", "-o", "b", "--format", "xls"}, {"--format", "xls"}},
                     {{"convert", "a.mcap", "-o", "a.mcap", "--format", "npz"}, {"a.mcap"}}});
  expect_refused(1, {{{"convert", "damaged.mcap", "-o", "b_csv"}, {"damaged.mcap"}},
                     {{"convert", "damaged.mcap", "-o", "b_bag"}, {"damaged.mcap"}},
                     {{"convert", "damaged.mcap", "-o", "b.npz"}, {"damaged.mcap"}},
                     {{"convert", "a.mcap", "-o", "there_csv"}, {"there_csv", "exists"}},
                     {{"convert", "a.mcap", "-o", "no/b_csv"}, {"no/b_csv"}},
                     {{"convert", "none.mcap", "-o", "b.npz"}, {"none.mcap"}}});
}

}  // namespace
}  // namespace somato
