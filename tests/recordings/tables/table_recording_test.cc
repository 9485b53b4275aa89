#include "recordings/tables/table_recording.h"

#include <gtest/gtest.h>

#include "base/support/temporary_folder.h"
#include "somato/files/npy.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

std::string refusal(const Result<Recording>& recording) {
  return recording ? std::string() : to_string(recording.error());
}

void expect_refused(const Result<Recording>& recording, const std::string& part) {
  EXPECT_NE(refusal(recording).find(part), std::string::npos) << refusal(recording);
}

TEST(TableRecording, EachRowIsAnExplorationOfOneFrame) {
  const TemporaryFolder folder;
  const std::string path = folder.with("t.csv", "width,kind,depth\n1.5,cup,2\n3,can,4\n");
  const Recording recording = load_recording({.label_column = "kind"}, path).value();
  ASSERT_EQ(recording.explorations.size(), 2U);
  ASSERT_TRUE(validate(recording));
  const Exploration& second = recording.explorations[1];
  EXPECT_EQ(second.labels, (std::vector<Label>{{"kind", "can"}, {"row", "2"}}));
  ASSERT_EQ(second.channels.size(), 1U);
  EXPECT_EQ(second.channels[0].name, "columns");
  EXPECT_EQ(second.channels[0].element_names, (Names{"width", "depth"}));
  EXPECT_EQ(second.channels[0].frames, Matrix<float>(1, 2, {3, 4}));
  EXPECT_TRUE(second.channels[0].valid.empty());
}

TEST(TableRecording, MissingValuesAreMarkedOrRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.with("t.csv", "a,b\n1,2\n,4\n");
  expect_refused(load_recording(RecordingParameters{}, path), "t.csv:3:1");
  const Recording recording = load_recording({.missing = MissingValues::kMask}, path).value();
  ASSERT_TRUE(validate(recording));
  const Channel& first = recording.explorations[0].channels[0];
  const Channel& second = recording.explorations[1].channels[0];
  EXPECT_EQ(first.valid, Matrix<std::uint8_t>(1, 2, {1, 1}));
  EXPECT_EQ(second.valid, Matrix<std::uint8_t>(1, 2, {0, 1}));
  EXPECT_EQ(second.frames, Matrix<float>(1, 2, {0, 4}));
}

TEST(TableRecording, RowsAndColumnsWithoutAKnownValueAreRefused) {
  const TemporaryFolder folder;
  const RecordingParameters mask{.missing = MissingValues::kMask};
  expect_refused(load_recording(mask, folder.with("t.csv", "a,b\n1,2\n,NA\n")),
                 "row 2 has no known value");
  const std::string column = folder.with("c.csv", "a,b\n1,\n2,NA\n");
  expect_refused(load_recording(mask, column), "column 2 ('b') has no known value");
  RecordingParameters for_system = mask;
  for_system.for_system = true;
  EXPECT_TRUE(load_recording(for_system, column));
}

TEST(TableRecording, ASystemNeedsNoLabels) {
  const TemporaryFolder folder;
  RecordingParameters trained{.label_column = "3", .for_system = true};
  const std::string bare = folder.with("bare.csv", "1,2\n3,4\n");
  EXPECT_EQ(load_recording(trained, bare).value().explorations[1].labels,
            (std::vector<Label>{{"row", "2"}}));
  const std::string some = folder.with("some.csv", "1,2,cup\n3,4,\n");
  const Recording recording = load_recording(trained, some).value();
  EXPECT_EQ(recording.explorations[0].labels[0], (Label{"label", "cup"}));
  EXPECT_EQ(recording.explorations[1].labels[0], (Label{"label", "unknown"}));
  trained.for_system = false;
  expect_refused(load_recording(trained, some), "the label is empty");
  trained = {.label_column = "row", .for_system = true, .features = {"a"}};
  const std::string named = folder.with("named.csv", "a\n1\n2\n");
  EXPECT_TRUE(load_recording(trained, named).value().explorations[0].labels.empty());
}

TEST(TableRecording, ColumnsAreChosenAsByTheMapOfATable) {
  const TemporaryFolder folder;
  const std::string path = folder.with("t.csv", "t1;t2;note\n1,5;2;x\n3;4;y\n");
  const RecordingParameters parameters{.skip = {"note"}, .decimal = DecimalMark::kComma};
  EXPECT_EQ(load_recording(parameters, path).value().explorations[0].channels[0].frames,
            Matrix<float>(1, 2, {1.5, 2}));
}

TEST(TableRecording, ASystemSelectsItsFeaturesByNameWithoutLabels) {
  const TemporaryFolder folder;
  const std::string path = folder.with("t.csv", ",c,b,a\n9,1,2,3\n");
  const RecordingParameters trained{
      .label_column = "kind", .skip = {"date"}, .for_system = true, .features = {"a", "c"}};
  const Exploration row = load_recording(trained, path).value().explorations[0];
  EXPECT_EQ(row.channels[0].element_names, (Names{"a", "c"}));
  EXPECT_EQ(row.channels[0].frames, Matrix<float>(1, 2, {3, 1}));
  EXPECT_EQ(row.labels, (std::vector<Label>{{"row", "1"}}));
  expect_refused(
      load_recording({.label_column = "kind", .for_system = true, .features = {"a", "d"}}, path),
      "'d'");
}

TEST(TableRecording, LabelsOfAFileAreOneForEachRow) {
  const TemporaryFolder folder;
  const std::string path = folder.file("t.npy");
  ASSERT_TRUE(write_npy(path, Matrix<float>(2, 2, {1, 2, 3, 4})));
  const std::string labels = folder.with("labels.txt", "cup\ncan\n");
  const Recording recording = load_recording({.labels = labels}, path).value();
  EXPECT_EQ(recording.explorations[1].labels, (std::vector<Label>{{"label", "can"}, {"row", "2"}}));
  EXPECT_TRUE(recording.explorations[1].channels[0].element_names.empty());
  expect_refused(load_recording({.labels = folder.with("few.txt", "cup\n")}, path),
                 "1 labels for 2 rows");
  const std::string table = folder.with("t.csv", "a,b\n1,cup\n2,can\n");
  expect_refused(load_recording({.label_column = "b", .labels = labels}, table),
                 "labels are given by a column and by a file");
}

TEST(TableRecording, SettingsOfTablesAreRefusedForOtherData) {
  const TemporaryFolder folder;
  const Recording table =
      load_recording(RecordingParameters{}, folder.with("t.csv", "1,2\n3,4\n")).value();
  const std::string path = folder.file("t.mcap");
  ASSERT_TRUE(write_recording(path, table));
  expect_refused(load_recording({.skip = {"a"}}, path), "'skip' is a setting of tables");
  expect_refused(load_recording({.skip = {"a"}}, folder.with("d.mcap", "no recording")),
                 "not an MCAP file");
  expect_refused(load_recording(RecordingParameters{}, folder.with("r.json", "{\"version\": 1}")),
                 "the file is JSON");
  expect_refused(
      load_recording({.format = RecordingFormat::kIcubGrasp}, folder.with("t.csv", "1,2\n3,4\n")),
      "the format is icub_grasp, and the file is not a recording");
}

TEST(TableRecording, ATextThatIsNoTableIsRefusedWithItsPlace) {
  const TemporaryFolder folder;
  expect_refused(load_recording(RecordingParameters{}, folder.with("t.csv", "a,b\n1,2\n3\n")),
                 "t.csv:3");
  expect_refused(load_recording(RecordingParameters{}, folder.with("e.csv", "")), "e.csv");
  expect_refused(
      load_recording(RecordingParameters{}, folder.with("b.csv", std::string("\0\1", 2))), "b.csv");
}

}  // namespace
}  // namespace somato
