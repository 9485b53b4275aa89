#include "recordings/imports/yarp_dumps.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

class YarpDumps : public ::testing::Test {
 protected:
  void dump(const std::string& name, const std::string& data, const std::string& info = {}) const {
    std::filesystem::create_directories(folder_.file(name));
    folder_.with(name + "/data.log", data);
    if (!info.empty()) folder_.with(name + "/info.log", info);
  }

  Result<YarpImport> import(const std::string& files = {}, bool pass_over_others = false) const {
    return import_yarp_dumps(folder_.path(), files, pass_over_others);
  }

  // The error, without the folder.
  std::string refusal(const std::string& files = {}) const {
    const auto read = import(files);
    if (read) return "none";
    const std::string text = to_string(read.error());
    return text.starts_with(folder_.path() + "/") ? text.substr(folder_.path().size() + 1) : text;
  }

  TemporaryFolder folder_;
};

TEST_F(YarpDumps, AFolderOfDumpsIsOneExploration) {
  dump("skin", "7 1594736418.250000 (1 2.5) 3\n8 1594736418.500001 (-4 5e-1) 6\n\n",
       "Type: Bottle;\nStamp: rx;\n[1594736418.0] /skin [connected]\n");
  dump("arm/state", "3 1594736418.000000 1594736418.9 10\n4 1594736419.000000 1594736419.9 20\n",
       "Type: Bottle;\nStamp: tx+rx;\n");
  dump("camera", "1 1594736418.0 00000000.ppm [rgb]\n", "Type: Image;\nStamp: rx;\n");
  dump("names", "1 1594736418.0 cup\n2 1594736418.5 ball\n");
  const YarpImport read = import().value();
  ASSERT_EQ(read.recording.explorations.size(), 1U);
  const Channel arm{"arm/state", "", {}, Matrix<float>(2, 1, std::vector<float>{10, 20}), {0, 1}};
  const Channel skin{"skin",
                     "",
                     {},
                     Matrix<float>(2, 3, std::vector<float>{1, 2.5, 3, -4, 0.5, 6}),
                     {0.25, 0.500001}};
  EXPECT_EQ(read.recording.explorations[0].channels, (std::vector<Channel>{arm, skin}));
  EXPECT_TRUE(read.recording.explorations[0].labels.empty());
  EXPECT_EQ(read.left_out, (std::vector<std::string>{folder_.file("camera") + ": images",
                                                     folder_.file("names") + ": text"}));
  EXPECT_TRUE(validate(read.recording));
}

TEST_F(YarpDumps, FoldersOfExplorationsHaveLabels) {
  dump("cup/10/skin", "0 5.0 1\n");
  dump("cup/2/skin", "0 6.0 2\n");
  dump("notes", "0 6.0 2\n");
  EXPECT_EQ(refusal("{object}/{trial:number}").substr(0, 27), "notes: the folder does not ");
  const YarpImport read = import("{object}/{trial:number}", true).value();
  ASSERT_EQ(read.recording.explorations.size(), 2U);
  const Exploration& first = read.recording.explorations[0];
  EXPECT_EQ(first.labels, (std::vector<Label>{{"object", "cup"}, {"trial", "2"}}));
  EXPECT_EQ(first.source, folder_.file("cup/2"));
  EXPECT_EQ(first.channels.at(0).name, "skin");
  EXPECT_EQ(first.channels.at(0).times, std::vector<double>{0});
  dump("cup/2/arm", "0 6.0 2\n");
  std::filesystem::remove_all(folder_.file("notes"));
  EXPECT_TRUE(refusal("{object}/{trial:number}").starts_with("cup/10: "));
}

TEST_F(YarpDumps, ValuesWithNamesArePlacedByThem) {
  dump("1/arm", "0 1.0 (shoulder 1) (hand 2 3)\n1 2.0 (hand 5 6) (shoulder 4)\n");
  dump("2/arm", "0 1.0 hand 8 9 shoulder 7\n");
  const YarpImport read = import("{trial}").value();
  const Channel& first = read.recording.explorations.at(0).channels.at(0);
  EXPECT_EQ(first.element_names, (std::vector<std::string>{"shoulder", "hand[0]", "hand[1]"}));
  EXPECT_EQ(first.frames, (Matrix<float>(2, 3, std::vector<float>{1, 2, 3, 4, 5, 6})));
  EXPECT_EQ(read.recording.explorations.at(1).channels.at(0).frames,
            (Matrix<float>(1, 3, std::vector<float>{7, 8, 9})));
  dump("1/arm", "0 1.0 shoulder 1 elbow 2\n1 2.0 shoulder 1 wrist 2\n");
  EXPECT_NE(refusal("{trial}").find("'shoulder', 'wrist'; those of the first frame are 'shoulder', "
                                    "'elbow'"),
            std::string::npos)
      << refusal("{trial}");
}

TEST_F(YarpDumps, RefusesAClockThatWasNotSet) {
  dump("arm", "0 12.5 1\n1 13.5 2\n");
  dump("skin", "0 1594736418.25 1\n");
  const std::string says = "arm: 2 of 3 times of the dumps are before the year 2000, first '12.5'";
  EXPECT_TRUE(refusal().starts_with(says)) << refusal();
  dump("skin", "0 12.5 1\n");
  EXPECT_EQ(refusal(), "none");
}

TEST_F(YarpDumps, RefusesDamagedLines) {
  EXPECT_NE(refusal().find("there are no dumps of YARP"), std::string::npos);
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "skin/data.log:0: there are no lines"},
      {"0 1.0 1\n1 2.0\n", "skin/data.log:2: the line has 2 words, and none for values"},
      {"0 one 1\n", "skin/data.log:1: 'one' is not a time stamp"},
      {"0 2.0 1\n1 1.5 1\n", "skin/data.log:2: the time stamp precedes"},
      {"0 1.0 1 2\n1 2.0 1\n", "skin/data.log:2: the line has 1 values, the first one 2"},
      {"0 1.0 1\n1 2.0 x\n", "skin/data.log:2: 'x' is not a finite number"},
      {"0 1.0 1\n1 2.0 1e39\n", "skin/data.log:2: '1e39' is not a finite number"},
      {"0 1.0 cup\n", "no dump contains numbers"},
      {"0 1.0 nan 1\n", "no dump contains numbers"},
      {"0 1.0 a 1\n1 2.0 2 a\n", "skin/data.log:2: the line has values without names"}};
  for (const auto& [data, says] : cases) {
    dump("skin", data);
    EXPECT_NE(refusal().find(says), std::string::npos) << refusal();
  }
}

}  // namespace
}  // namespace somato
