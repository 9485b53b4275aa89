#include "recordings/tables/csv_windows.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "base/support/temporary_folder.h"
#include "recordings/support/csv_channel.h"
#include "somato/core/random.h"
#include "somato/recording/csv_import.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

class ImportWindows : public ::testing::Test {
 protected:
  ImportWindows() {
    plan_.trials.files = "{run}.csv";
    plan_.trials.window = 3;
    plan_.channels = {channel_of("x", {"x"})};
  }

  Result<Recording> import() { return import_csv_trials(folder_.path(), plan_, &report_); }

  // The error, without the folder.
  std::string refusal() {
    const auto recording = import();
    if (recording) return "none";
    const std::string text = to_string(recording.error());
    return text.starts_with(folder_.path()) ? text.substr(folder_.path().size() + 1) : text;
  }

  // "labels: values of the channel x" of each exploration.
  Names imported() {
    const auto recording = import();
    if (!recording) return {to_string(recording.error())};
    EXPECT_TRUE(validate(*recording));
    Names all;
    for (const Exploration& exploration : recording->explorations) {
      std::string text;
      for (const Label& label : exploration.labels) text += label.value + " ";
      for (const float value : exploration.channels[0].frames.values())
        text += fmt::format("{}", value);
      all.push_back(std::move(text));
    }
    return all;
  }

  // A file with the numbers from 0 on as its rows.
  void count(const char* name, int rows) const {
    std::string text = "x\n";
    for (int i = 0; i < rows; ++i) text += fmt::format("{}\n", i);
    folder_.with(name, text);
  }

  TemporaryFolder folder_;
  CsvImport plan_;
  CsvImportReport report_;
};

TEST_F(ImportWindows, CutsFilesAndCountsWhatIsLeft) {
  count("a.csv", 8);
  count("b.csv", 3);
  count("c.csv", 2);
  EXPECT_EQ(imported(), (Names{"a a.csv 1 012", "a a.csv 2 345", "b b.csv 1 012"}));
  EXPECT_EQ(report_.rows_left_out, 4U);
  EXPECT_EQ(report_.files_left_out, 1U);
  EXPECT_EQ(import()->explorations[1].source, folder_.file("a.csv"));
  EXPECT_EQ(import()->explorations[0].labels,
            (std::vector<Label>{{"run", "a"}, {"file", "a.csv"}, {"window", "1"}}));
}

TEST_F(ImportWindows, Overlap) {
  count("a.csv", 8);
  plan_.trials.overlap = 2;
  EXPECT_EQ(imported(), (Names{"a a.csv 1 012", "a a.csv 2 123", "a a.csv 3 234", "a a.csv 4 345",
                               "a a.csv 5 456", "a a.csv 6 567"}));
  EXPECT_EQ(report_.rows_left_out, 0U);
  plan_.trials.overlap = 1;
  EXPECT_EQ(imported(), (Names{"a a.csv 1 012", "a a.csv 2 234", "a a.csv 3 456"}));
  EXPECT_EQ(report_.rows_left_out, 1U);
}

TEST_F(ImportWindows, AnIncompleteOneIsKeptOnRequest) {
  plan_.trials.incomplete = IncompleteWindow::kKeep;
  count("a.csv", 8);
  count("b.csv", 2);
  count("c.csv", 3);
  EXPECT_EQ(imported(), (Names{"a a.csv 1 012", "a a.csv 2 345", "a a.csv 3 67", "b b.csv 1 01",
                               "c c.csv 1 012"}));
  EXPECT_EQ(report_.rows_left_out, 0U);
  plan_.trials.overlap = 2;
  EXPECT_EQ(imported().back(), "c c.csv 1 012");
  plan_.trials.overlap = 1;
  EXPECT_EQ(imported()[3], "a a.csv 4 67");
  plan_.trials.overlap = 0;
  plan_.trials.window.reset();
  EXPECT_EQ(refusal(),
            "[import]: 'incomplete' has no effect without 'window'; write for example "
            "window = 500");
}

TEST_F(ImportWindows, DoNotCrossAChangeOfLabel) {
  plan_.trials.labels = {"what", "day"};
  folder_.with("a.csv",
               "x,what,day\n0,up,1\n1,up,1\n2,up,1\n3,up,1\n4,down,1\n5,down,2\n6,down,2\n"
               "7,down,2\n8,up,2\n");
  EXPECT_EQ(imported(), (Names{"a up 1 a.csv 1 012", "a down 2 a.csv 2 567"}));
  EXPECT_EQ(report_.rows_left_out, 3U);
  EXPECT_EQ(import()->explorations[0].labels,
            (std::vector<Label>{
                {"run", "a"}, {"what", "up"}, {"day", "1"}, {"file", "a.csv"}, {"window", "1"}}));
}

TEST_F(ImportWindows, KeepTimesRatesMarksAndNamesOfColumns) {
  plan_.trials.window = 2;
  plan_.trials.time = {"t"};
  plan_.trials.time_unit = TimeUnit::kMilliseconds;
  plan_.trials.missing = MissingValues::kMask;
  plan_.channels = {channel_of("xy", {"x", "y"})};
  plan_.channels[0].unit = "N";
  plan_.channels[0].shape = {2, 1};
  folder_.with("a.csv", "t,x,y\n0,1,2\n10,3,4\n25,5,6\n75,nan,8\n");
  const Channel first{"xy",      "N", {"x", "y"}, Matrix<float>(2, 2, {1, 2, 3, 4}),
                      {0, 0.01}, 0,   {2, 1}};
  EXPECT_EQ(import()->explorations[0].channels[0], first);
  const Channel second = import()->explorations[1].channels[0];
  EXPECT_EQ(second.frames, Matrix<float>(2, 2, {5, 6, 0, 8}));
  EXPECT_EQ(second.valid, Matrix<std::uint8_t>(2, 2, {1, 1, 0, 1}));
  ASSERT_EQ(second.times.size(), 2U);
  EXPECT_EQ(second.times[0], 0.0);
  EXPECT_DOUBLE_EQ(second.times[1], 0.05);
  plan_.trials.time.clear();
  plan_.trials.ignore = {"t"};
  plan_.trials.rate = 100.0;
  EXPECT_EQ(import()->explorations[1].channels[0].rate, 100.0);
  EXPECT_TRUE(import()->explorations[1].channels[0].times.empty());
}

TEST_F(ImportWindows, TellFilesOfSeveralFoldersApart) {
  plan_.trials.files = "{day}/{run}.csv";
  std::filesystem::create_directories(folder_.file("1"));
  std::filesystem::create_directories(folder_.file("2"));
  count("1/a.csv", 3);
  count("2/a.csv", 3);
  EXPECT_EQ(imported(), (Names{"1 a 1/a.csv 1 012", "2 a 2/a.csv 1 012"}));
}

TEST_F(ImportWindows, RefuseToBeLongerThanEveryFile) {
  count("a.csv", 2);
  count("b.csv", 1);
  EXPECT_EQ(to_string(import().error()),
            folder_.path() + ": no file has 3 rows; the most are 2; make 'window' smaller");
  plan_.trials.labels = {"what"};
  std::filesystem::remove(folder_.file("b.csv"));
  folder_.with("a.csv", "x,what\n0,a\n1,b\n2,b\n3,a\n");
  EXPECT_EQ(to_string(import().error()),
            folder_.path() +
                ": no file has 3 rows with the same labels one after the other; the most are 2; "
                "make 'window' smaller");
}

TEST_F(ImportWindows, TakeOneFileWithoutPattern) {
  plan_.trials.files.clear();
  count("a.csv", 3);
  const auto one = import_csv_trials(folder_.file("a.csv"), plan_);
  EXPECT_EQ(one.value().explorations[0].labels,
            (std::vector<Label>{{"file", "a.csv"}, {"window", "1"}}));
  EXPECT_EQ(to_string(import().error()),
            folder_.path() +
                ": 'files' is missing, which is required for a folder; write for example files = "
                "\"{object}_{trial:number}.csv\", or import one file");
  plan_.trials.files = "{run}.csv";
  EXPECT_EQ(import_csv_trials(folder_.file("a.csv"), plan_)->explorations[0].labels[0].value, "a");
}

TEST_F(ImportWindows, RefuseAPathThatIsNoLabel) {
  std::filesystem::create_directories(folder_.file("d\xFF"));
  count("d\xFF/a.csv", 3);
  EXPECT_NE(refusal().find("is not 1 to 255 bytes of UTF-8 text"), std::string::npos);
}

class ImportTable : public ImportWindows {
 protected:
  ImportTable() {
    plan_.trials.window.reset();
    plan_.trials.rows = CsvRows::kExplorations;
    plan_.trials.labels = {"object", "grasp"};
  }
};

TEST_F(ImportTable, MakesEachRowAnExploration) {
  folder_.with("t.csv", "object,x,grasp\n\"red, cup\",1.5,1\nnone,2,01\ncup,3,1.0\n");
  EXPECT_EQ(imported(),
            (Names{"t red, cup 1 t.csv 1 1.5", "t none 01 t.csv 2 2", "t cup 1.0 t.csv 3 3"}));
  EXPECT_EQ(report_.rows_left_out, 0U);
  EXPECT_EQ(import()->explorations[0].labels[4], (Label{"row", "1"}));
}

TEST_F(ImportTable, MakesAChannelOfALabelOfEachRow) {
  plan_.channels.push_back(channel_of("grasp", {}));
  plan_.channels[1].from_label = "grasp";
  folder_.with("t.csv", "object,x,grasp\na,1,7\nb,2,8.5\n");
  EXPECT_EQ(import()->explorations[0].channels[1].frames, Matrix<float>(1, 1, 7.0F));
  EXPECT_EQ(import()->explorations[1].channels[1].frames, Matrix<float>(1, 1, 8.5F));
}

TEST_F(ImportTable, RefusesLabelsThatAreMissing) {
  for (const char* cell : {"", "NaN", "NA", "null", "None", "?"}) {
    folder_.with("t.csv", fmt::format("object,x,grasp\na,1,1\nb,2,{}\n", cell));
    EXPECT_EQ(refusal(), fmt::format("t.csv:3:5: the label 'grasp' is missing: '{}'; fill it in, "
                                     "remove the row, or leave the label out",
                                     cell));
  }
  folder_.with("t.csv", "object,x\na,1\n");
  EXPECT_EQ(refusal(), "t.csv:1: there is no column 'grasp'; known are: object, x");
  folder_.with("t.csv", "objects,x,grasp\na,1,1\n");
  EXPECT_EQ(refusal(), "t.csv:1: there is no column 'object'; did you mean 'objects'?");
}

TEST_F(ImportTable, RefusesLabelsThatAreNoNames) {
  folder_.with("t.csv", "object,x,grasp\na,1," + std::string(256, 'g') + "\n");
  EXPECT_TRUE(refusal().starts_with("t.csv:2:5: the label 'grasp' is not 1 to 255 bytes of text"));
}

TEST_F(ImportTable, RefusesMissingNumbersAndTwoColumnsOfOneName) {
  folder_.with("t.csv", "object,x,grasp\na,nan,1\n");
  EXPECT_TRUE(refusal().starts_with("t.csv:2:3: 'nan' is not a finite number")) << refusal();
  folder_.with("t.csv", "object,x,grasp,object\na,1,1,b\n");
  EXPECT_EQ(refusal(), "t.csv:1:16: there are two columns 'object'; rename one of them");
}

TEST_F(ImportTable, RefusesLabelsThatChangeInAWholeFile) {
  plan_.trials.rows = CsvRows::kFrames;
  folder_.with("t.csv", "object,x,grasp\na,1,1\na,2,1\n");
  EXPECT_EQ(imported(), (Names{"t a 1 12"}));
  folder_.with("t.csv", "object,x,grasp\na,1,1\na,2,2\n");
  EXPECT_EQ(refusal(),
            "t.csv:3: the label 'grasp' changes within the file; divide it where the label "
            "changes: exploration = \"grasp\"; or into windows: window = 500; or into rows: rows = "
            "\"explorations\"");
}

TEST_F(ImportTable, AColumnOfExplorationsDividesFiles) {
  plan_.trials.rows = CsvRows::kFrames;
  plan_.trials.labels = {"object"};
  plan_.trials.exploration = "grasp";
  plan_.trials.time = {"t"};
  folder_.with("t.csv", "t,object,x,grasp\n5,a,1,1\n6,a,2,1\n1,a,3,2\n4,a,4,2\n2,b,5,3\n");
  const Recording recording = import().value();
  ASSERT_EQ(recording.explorations.size(), 3U);
  const std::vector<std::vector<double>> times{{0, 1}, {0, 3}, {0}};
  const std::vector<std::vector<float>> values{{1, 2}, {3, 4}, {5}};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Exploration& exploration = recording.explorations[i];
    EXPECT_EQ(exploration.labels.back(), (Label{"object", i < 2 ? "a" : "b"}));
    EXPECT_EQ(exploration.channels.at(0).times, times[i]);
    const auto found = exploration.channels.at(0).frames.values();
    EXPECT_EQ(std::vector<float>(found.begin(), found.end()), values[i]);
  }
  folder_.with("t.csv", "t,object,x,grasp\n0,a,1,1\n1,b,2,1\n");
  EXPECT_TRUE(refusal().starts_with("t.csv:3: the label 'object' changes within an exploration"))
      << refusal();
  folder_.with("t.csv", "t,object,x,grasp\n1,a,1,1\n0,a,2,1\n");
  EXPECT_TRUE(refusal().starts_with("t.csv:3:1: the time decreases")) << refusal();
  plan_.trials.window = 1;
  EXPECT_NE(refusal().find("both 'exploration' and 'window'"), std::string::npos) << refusal();
}

// Rows of the same object that follow each other are one exploration.
TEST_F(ImportTable, ALabelDividesFilesWhereItChanges) {
  plan_.trials.rows = CsvRows::kFrames;
  plan_.trials.labels = {"hand", "object"};
  plan_.trials.exploration = "object";
  folder_.with("t.csv", "hand,object,x\nleft,a,1\nleft,a,2\nleft,b,3\nleft,a,4\nleft,a,5\n");
  const Recording recording = import().value();
  ASSERT_EQ(recording.explorations.size(), 3U);
  const std::vector<std::vector<float>> values{{1, 2}, {3}, {4, 5}};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Exploration& exploration = recording.explorations[i];
    EXPECT_EQ(exploration.labels.back(), (Label{"object", i == 1 ? "b" : "a"}));
    const auto found = exploration.channels.at(0).frames.values();
    EXPECT_EQ(std::vector<float>(found.begin(), found.end()), values[i]);
  }
  folder_.with("t.csv", "hand,object,x\nleft,a,1\nright,a,2\n");
  EXPECT_TRUE(refusal().starts_with(
      "t.csv:3: the label 'hand' changes within an exploration, in which 'object' is 'a'; divide"))
      << refusal();
  plan_.trials.labels = {"object", "object"};
  EXPECT_NE(refusal().find("there are two labels 'object'"), std::string::npos) << refusal();
}

// 0.1 and the next float32 number differ by less than their shortest texts state.
TEST_F(ImportTable, ShortestTextsOfSinglePrecisionLoseNothing) {
  plan_.trials.labels = {"object"};
  folder_.with("t.csv", "object,x\na,0.1\na,0.10000001\n");
  const Recording recording = import().value();
  EXPECT_EQ(recording.explorations.at(0).channels.at(0).frames(0, 0), 0.1F);
  EXPECT_EQ(recording.explorations.at(1).channels.at(0).frames(0, 0), std::nextafter(0.1F, 1.0F));
  folder_.with("t.csv", "object,x\na,0.1000000012\na,0.1000000053\n");
  EXPECT_NE(refusal().find("loses precision"), std::string::npos);
}

// By looking at each row whether a window begins there.
std::vector<std::size_t> starts_slowly(const std::vector<std::size_t>& labels, std::size_t window,
                                       std::size_t overlap) {
  std::vector<std::size_t> starts;
  std::size_t part = 0;
  for (std::size_t row = 0; row < labels.size(); ++row) {
    if (row > 0 && labels[row] != labels[row - 1]) part = row;
    if ((row - part) % (window - overlap) != 0 || row + window > labels.size()) continue;
    bool same = true;
    for (std::size_t i = row; i < row + window; ++i) same = same && labels[i] == labels[row];
    if (same) starts.push_back(row);
  }
  return starts;
}

TEST(WindowsOf, AreThoseThatLookingAtEachRowFinds) {
  Random random(5);
  for (int round = 0; round < 500; ++round) {
    std::vector<std::size_t> labels;
    std::vector<LabelledRows> parts;
    while (labels.size() < 40) {
      const std::size_t rows = 1 + random.below(12);
      parts.push_back({labels.size(), rows, {}});
      labels.insert(labels.end(), rows, parts.size());
    }
    CsvTrials trials;
    trials.window = 1 + random.below(6);
    trials.overlap = random.below(*trials.window);
    const CsvWindows found = windows_of(trials, parts);
    std::vector<std::size_t> starts;
    std::vector<bool> covered(labels.size());
    for (const CsvWindow& window : found.windows) {
      starts.push_back(window.first);
      EXPECT_EQ(window.rows, *trials.window);
      EXPECT_EQ(window.part + 1, labels[window.first]);
      for (std::size_t i = 0; i < window.rows; ++i) covered[window.first + i] = true;
    }
    EXPECT_EQ(starts, starts_slowly(labels, *trials.window, trials.overlap));
    EXPECT_EQ(found.left_out,
              static_cast<std::size_t>(std::count(covered.begin(), covered.end(), false)));
  }
}

}  // namespace
}  // namespace somato
