#include "recordings/imports/mcap_trials.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/support/temporary_folder.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

Exploration touched(std::vector<Label> labels, float value, std::string source = {}) {
  Channel touch{"touch", "counts", {"a", "b"}, Matrix<float>(2, 2, {value, 1, 2, 3}), {0, 0.5}};
  return {std::move(labels), std::move(source), {std::move(touch)}};
}

class ImportMcapTrials : public ::testing::Test {
 protected:
  void save(const char* name, std::vector<Exploration> explorations) const {
    ASSERT_TRUE(write_recording(folder_.file(name), {std::move(explorations)}));
  }

  Result<Recording> import(const char* files = "{object}_{trial:number}.mcap",
                           bool pass_over_others = false) const {
    return import_mcap_trials(folder_.path(), files, pass_over_others);
  }

  // The refusal, without the folder.
  std::string refusal() const {
    const auto recording = import();
    if (recording) return "none";
    EXPECT_EQ(recording.error().kind, ErrorKind::kData);
    const std::string text = to_string(recording.error());
    const std::size_t folder = text.find(folder_.path());
    return folder == 0 ? text.substr(folder_.path().size() + 1) : text;
  }

  TemporaryFolder folder_;
};

TEST_F(ImportMcapTrials, AddsTheLabelsOfTheNamesInNaturalOrder) {
  save("cup_10.mcap", {touched({{"day", "1"}}, 10)});
  save("cup_9.mcap", {touched({{"day", "2"}}, 9, "rig"), touched({{"day", "3"}}, 8)});
  const std::string path = folder_.file("cup_");
  const auto labels = [](const char* day, const char* trial) {
    return std::vector<Label>{{"day", day}, {"object", "cup"}, {"trial", trial}};
  };
  EXPECT_EQ(import()->explorations,
            (std::vector<Exploration>{touched(labels("2", "9"), 9, "rig"),
                                      touched(labels("3", "9"), 8, path + "9.mcap"),
                                      touched(labels("1", "10"), 10, path + "10.mcap")}));
}

TEST_F(ImportMcapTrials, TakesALabelThatBothGiveOnce) {
  save("cup_1.mcap", {touched({{"trial", "1"}, {"object", "cup"}}, 1)});
  EXPECT_EQ(import()->explorations[0].labels,
            (std::vector<Label>{{"trial", "1"}, {"object", "cup"}}));
}

TEST_F(ImportMcapTrials, RefusesALabelWithTwoValues) {
  save("cup_1.mcap", {touched({{"object", "mug"}}, 1)});
  EXPECT_EQ(refusal(),
            "cup_1.mcap: label 'object' is 'mug' in the recording, but 'cup' in the file name; "
            "rename the file, or rename the label in its name");
}

TEST_F(ImportMcapTrials, RefusesOtherChannelsAndLabelsWithFileAndName) {
  save("a_1.mcap", {touched({}, 1)});
  Exploration other = touched({}, 1);
  other.channels[0].name = "force";
  save("b_1.mcap", {other});
  EXPECT_EQ(refusal(),
            "b_1.mcap: its channels are 'force', but those of the first exploration are 'touch'; "
            "record them separately, or leave the exploration out");
  other = touched({}, 1);
  other.channels[0].unit = "N";
  save("b_1.mcap", {other});
  EXPECT_EQ(refusal(),
            "b_1.mcap: channel 'touch' is in 'N', but in 'counts' in the first exploration; "
            "convert one of them");
  save("b_1.mcap", {touched({{"day", "1"}}, 1)});
  EXPECT_EQ(refusal(),
            "b_1.mcap: its labels are 'day, object, trial', but those of the first exploration are "
            "'object, trial'; record them separately, or leave the exploration out");
}

TEST_F(ImportMcapTrials, RefusesFilesThatDoNotFitUnlessTheyArePassedOver) {
  save("cup_1.mcap", {touched({}, 1)});
  save("summary.mcap", {touched({}, 1)});
  folder_.with("notes.txt", "");
  EXPECT_EQ(refusal(),
            "summary.mcap: the file name does not match the pattern "
            "\"{object}_{trial:number}.mcap\"; rename it, remove it from the folder, or correct "
            "the pattern");
  EXPECT_EQ(import("{object}_{trial:number}.mcap", true)->explorations.size(), 1U);
}

TEST_F(ImportMcapTrials, RefusesAFolderWithoutMatchingFiles) {
  folder_.with("notes.txt", "");
  EXPECT_EQ(import().error().what, "there are no files \"{object}_{trial:number}.mcap\"");
  EXPECT_EQ(import_mcap_trials(folder_.file("nowhere"), "{a}.mcap", false).error().kind,
            ErrorKind::kSystem);
}

TEST_F(ImportMcapTrials, RefusesWhatIsNoRecording) {
  save("cup_1.mcap", {touched({}, 1)});
  folder_.with("cup_2.mcap", "time,x\n0,1\n");
  EXPECT_TRUE(refusal().starts_with("cup_2.mcap")) << refusal();
  const std::string whole = bytes_of(folder_.file("cup_1.mcap"));
  folder_.with("cup_2.mcap", whole.substr(0, whole.size() / 2));
  EXPECT_TRUE(refusal().starts_with("cup_2.mcap")) << refusal();
}

TEST_F(ImportMcapTrials, RefusesAPipe) {
  save("cup_1.mcap", {touched({}, 1)});
  ASSERT_EQ(::mkfifo(folder_.file("cup_2.mcap").c_str(), 0600), 0);
  EXPECT_EQ(refusal(), "cup_2.mcap: it is not a regular file; remove it from the folder");
}

TEST_F(ImportMcapTrials, RefusesAPatternWithoutLabels) {
  for (const char* files : {"", "all.mcap"}) {
    const auto recording = import(files);
    ASSERT_FALSE(recording);
    EXPECT_EQ(recording.error().kind, ErrorKind::kUsage);
    EXPECT_EQ(recording.error().what, "'files': the pattern has no labels");
  }
}

}  // namespace
}  // namespace somato
