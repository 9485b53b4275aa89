#include "recordings/bags/bag_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/support/temporary_folder.h"
#include "recordings/bags/made_bag.h"
#include "recordings/bags/made_sqlite_bag.h"

namespace somato {
namespace {

namespace fs = std::filesystem;

const std::string kTwoFiles =
    "rosbag2_bagfile_information:\n  version: 9\n  relative_file_paths:\n    - b_1.mcap\n    - "
    "\"b_0.mcap\"\n  compression_format: \"\"\n  compression_mode: \"\"\n";

void make_bag(const std::string& path, double value) {
  MadeBag made(path);
  const auto topic = made.topic("/x", "a/msg/X", "float64[] x\n");
  made.add(topic, 1, numbers_message({value})).finish();
}

std::string refusal_of(const Result<std::vector<BagLocation>>& bags) {
  return bags ? "found" : bags.error().what;
}

TEST(BagFiles, AFolderWithMetadataIsOneBag) {
  const TemporaryFolder folder;
  make_bag(folder.file("b_0.mcap"), 1.0);
  make_bag(folder.file("b_1.mcap"), 2.0);
  make_bag(folder.file("old.mcap"), 3.0);
  (void)folder.with("metadata.yaml", kTwoFiles);
  const auto bags = find_bags(folder.path()).value();
  ASSERT_EQ(bags.size(), 1U);
  EXPECT_EQ(bags[0].files,
            (std::vector<std::string>{folder.file("b_1.mcap"), folder.file("b_0.mcap")}));
  const auto source = open_bag(bags[0]).value();
  EXPECT_EQ(source->next().value()->data, numbers_message({2.0}));
  EXPECT_EQ(source->next().value()->data, numbers_message({1.0}));
  EXPECT_FALSE(source->next().value());
  EXPECT_EQ(source->topics().size(), 1U);
}

TEST(BagFiles, WithoutMetadataEachFileIsABag) {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("b"));
  make_bag(folder.file("b/cup_10.mcap"), 1.0);
  make_bag(folder.file("b/cup_2.mcap"), 1.0);
  fs::create_directory(folder.file("a"));
  make_bag(folder.file("a/b_0.mcap"), 1.0);
  make_bag(folder.file("a/b_1.mcap"), 1.0);
  (void)folder.with("a/metadata.yaml", kTwoFiles);
  const auto bags = find_bags(folder.path()).value();
  ASSERT_EQ(bags.size(), 3U);
  EXPECT_EQ(bags[0].name, "a");
  EXPECT_EQ(bags[1].name, "b/cup_2.mcap");
  EXPECT_EQ(bags[2].name, "b/cup_10.mcap");
  EXPECT_EQ(find_bags(folder.file("b/cup_2.mcap")).value()[0].name, "cup_2.mcap");
}

TEST(BagFiles, PartsOfABagWithoutAUsableDescriptionAreInTheOrderOfTheirTimes) {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("run"));
  for (const int part : {0, 1, 2}) {
    MadeBag made(folder.file(fmt::format("run/run_{}.mcap", part)));
    const auto topic = made.topic("/x", "a/msg/X", "float64[] x\n");
    made.add(topic, 100 - part, numbers_message({1.0})).finish();
  }
  for (const bool has_metadata : {false, true}) {
    if (has_metadata) (void)folder.with("run/metadata.yaml", "version: 9\n");
    const auto bags = find_bags(folder.file("run")).value();
    ASSERT_EQ(bags.size(), 1U);
    EXPECT_EQ(bags[0].name, "run");
    ASSERT_EQ(bags[0].files.size(), 3U);
    EXPECT_EQ(bags[0].files[0], folder.file("run/run_2.mcap"));
    EXPECT_EQ(bags[0].files[2], folder.file("run/run_0.mcap"));
    EXPECT_EQ(bags[0].remarks.size(), 1U);
  }
}

TEST(BagFiles, FoldersThatAreNoBagsAreRefused) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal_of(find_bags(folder.path())),
            "there are no bags (*.mcap, *.db3, folders with metadata.yaml)");
  (void)folder.with("metadata.yaml", kTwoFiles);
  EXPECT_EQ(refusal_of(find_bags(folder.path())), "the bag's file 'b_1.mcap' is missing");
  (void)folder.with("metadata.yaml", "version: 9\n");
  EXPECT_EQ(refusal_of(find_bags(folder.path())), "it lists no files in relative_file_paths");
  (void)folder.with("metadata.yaml",
                    "relative_file_paths:\n  - b.db3\ncompression_mode: MESSAGE\n");
  EXPECT_EQ(refusal_of(find_bags(folder.path())),
            "the messages of the bag are compressed one by one");
}

TEST(BagFiles, OtherKindsOfBagsAreRefusedWithAdvice) {
  const TemporaryFolder folder;
  const auto error_of = [&](const std::string& bytes) {
    const auto bags = find_bags(folder.with("a.bag", bytes)).value();
    return to_string(open_bag(bags[0]).error());
  };
  EXPECT_NE(error_of("#ROSBAG V2.0\n").find("rosbags-convert"), std::string::npos);
  EXPECT_NE(error_of("\x28\xB5\x2F\xFD..").find("zstd -d"), std::string::npos);
  EXPECT_NE(error_of("text").find("neither MCAP nor"), std::string::npos);
  EXPECT_NE(error_of("").find("neither MCAP nor"), std::string::npos);
}

TEST(BagFiles, OldBagsTakeDefinitionsFromAFolder) {
  const TemporaryFolder folder;
  {
    const MadeSqliteBag made(folder.file("a.db3"), "/x", "skin/msg/Skin", "");
  }
  fs::create_directories(folder.file("msgs/skin/msg"));
  (void)folder.with("msgs/skin/msg/Skin.msg", "Taxel[] taxels\n");
  (void)folder.with("msgs/skin/msg/Taxel.msg", "int16 z\n");
  const auto bag = find_bags(folder.file("a.db3")).value()[0];
  EXPECT_TRUE(open_bag(bag).value()->topics()[0].encoding.definition.empty());
  const auto source = open_bag(bag, folder.file("msgs")).value();
  const auto messages = compile_topic_messages(source->topics()[0].encoding);
  ASSERT_TRUE(messages) << to_string(messages.error());
  EXPECT_EQ(messages->type->structures.size(), 2U);
  EXPECT_FALSE(open_bag(bag, folder.path() + "/none"));
}

}  // namespace
}  // namespace somato
