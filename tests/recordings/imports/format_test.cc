#include "somato/recording/format.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

struct Example {
  RecordingFormat format;
  const char* file;
};

constexpr Example kExamples[] = {
    {RecordingFormat::kIcubGrasp, "trials/blue_bear_1.txt"},
    {RecordingFormat::kFabricslide, "fabric/Linen_F120_V-100mmps_0.csv"},
    {RecordingFormat::kHkustPressSlide, "data_raw/Material_Wood_raw_1.csv"},
    {RecordingFormat::kAcousticHardness, "phase7/69a186a1-a967.json"},
};

void add(const TemporaryFolder& folder, const std::string& file, const std::string& text = "") {
  std::filesystem::create_directories(std::filesystem::path(folder.file(file)).parent_path());
  folder.with(file, text);
}

TEST(RecognizeFormat, GoesByTheNamesOfFiles) {
  for (const Example& example : kExamples) {
    const TemporaryFolder folder;
    add(folder, example.file);
    for (const char* other : {"README.md", "LICENSE.txt", "ORIGINAL_README.txt", "index.tsv"}) {
      add(folder, other);
    }
    EXPECT_EQ(recognize_format(folder.path()), example.format) << example.file;
  }
}

TEST(RecognizeFormat, SaysWhatWasLookedFor) {
  const TemporaryFolder folder;
  add(folder, "notes.txt");
  const auto format = recognize_format(folder.path());
  ASSERT_FALSE(format);
  EXPECT_EQ(format.error().kind, ErrorKind::kData);
  EXPECT_EQ(format.error().where, folder.path());
  EXPECT_EQ(format.error().what,
            "the folder contains none of the known formats: icub_grasp "
            "({object}_{trial:number}.txt), fabricslide "
            "({fabric}_F{force:number}_V{velocity:number}mmps_{trial:number}.csv), "
            "hkust_press_slide (Material_{material}_raw_{trial:number}.csv), acoustic_hardness "
            "({sample}.json)");
}

TEST(RecognizeFormat, RefusesTwoFormats) {
  const TemporaryFolder folder;
  add(folder, kExamples[0].file);
  add(folder, kExamples[3].file);
  const auto format = recognize_format(folder.path());
  ASSERT_FALSE(format);
  EXPECT_EQ(format.error().what,
            "the folder contains more than one format: icub_grasp ({object}_{trial:number}.txt), "
            "acoustic_hardness ({sample}.json)");
}

TEST(RecognizeFormat, SaysWhatCannotBeRead) {
  const TemporaryFolder folder;
  const auto format = recognize_format(folder.file("nowhere"));
  ASSERT_FALSE(format);
  EXPECT_EQ(format.error().kind, ErrorKind::kSystem);
  EXPECT_EQ(format.error().what, "there is no such file or folder");
}

// The output folder of a study is no data set.
TEST(RecognizeFormat, AdvisesToUseOneOfTheRecordingsInAFolder) {
  const TemporaryFolder folder;
  add(folder, "run/results.json", "{}");
  const auto without = recognize_format(folder.path());
  ASSERT_FALSE(without);
  EXPECT_TRUE(without.error().what.starts_with("the folder contains none of the known formats"));
  add(folder, "run/hand2.mcap");
  const auto format = recognize_format(folder.path());
  ASSERT_FALSE(format);
  EXPECT_EQ(format.error().what, "the folder contains recordings, such as run/hand2.mcap");
}

TEST(LoadRecording, ReadsTheFormatThatIsNamedOrFoundOut) {
  const TemporaryFolder folder;
  add(folder, "Material_Wood_raw_1.csv", "Fx,Fy,Fz\n1,2,3\n");
  for (const RecordingFormat format :
       {RecordingFormat::kAutomatic, RecordingFormat::kHkustPressSlide}) {
    const auto recording = load_recording(format, folder.path());
    ASSERT_TRUE(recording);
    EXPECT_EQ(recording->explorations[0].channels[0].name, "force");
  }
  for (const RecordingFormat format : {RecordingFormat::kIcubGrasp, RecordingFormat::kFabricslide,
                                       RecordingFormat::kAcousticHardness}) {
    EXPECT_FALSE(load_recording(format, folder.path())) << choice_name(format);
  }
}

TEST(LoadRecording, HasAReaderForEveryFormat) {
  const TemporaryFolder folder;
  for (const auto& [format, name] : Choices<RecordingFormat>::all()) {
    const auto recording = load_recording(format, folder.path());
    ASSERT_FALSE(recording);
    EXPECT_NE(recording.error().what, "this recording format cannot be read") << name;
  }
}

}  // namespace
}  // namespace somato
