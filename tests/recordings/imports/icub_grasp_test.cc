#include "recordings/imports/icub_grasp.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "base/support/places.h"
#include "somato/codes/standardization.h"

namespace somato {
namespace {

namespace fs = std::filesystem;

// The numbers first, first + 1, ... with the blanks and line end of the data set.
std::string line_of(int count, int first) {
  std::string line;
  for (int i = 0; i < count; ++i) line += fmt::format("{}.5 ", first + i);
  return line + "\r\n";
}

// Joints 0.5 to 8.5, pressures 10.5 to 14.5, taxels 100.5 to 159.5; `more` is added to all.
std::string step_of(int more = 0) {
  std::string text = line_of(9, more) + line_of(5, 10 + more);
  for (int finger = 0; finger < 5; ++finger) text += line_of(12, 100 + 12 * finger + more);
  return text;
}

class ImportIcubGrasp : public ::testing::Test {
 protected:
  ImportIcubGrasp() { fs::create_directories(folder_); }
  ~ImportIcubGrasp() override { fs::remove_all(folder_); }

  void write(const fs::path& name, const std::string& text) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  // The error that a single grasp with this content gives, without the folder.
  std::string error_for(const std::string& text) {
    write("ball_1.txt", text);
    const Result<Recording> recording = import_icub_grasp(folder_);
    if (recording) return "none";
    std::string where = recording.error().where;
    where.erase(0, folder_.string().size() + 1);
    EXPECT_EQ(recording.error().kind, ErrorKind::kData);
    EXPECT_EQ(recording.error().advice, "repair or remove the file");
    return where + ": " + recording.error().what;
  }

  const fs::path folder_ =
      fs::temp_directory_path() /
      fmt::format("somato_{}_{}", getpid(),
                  ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

std::vector<std::string> sources_of(const Recording& recording) {
  std::vector<std::string> names;
  for (const Exploration& exploration : recording.explorations) {
    names.push_back(fs::path(exploration.source).filename().string());
  }
  return names;
}

TEST_F(ImportIcubGrasp, ReadsEveryNumberToItsPlace) {
  write("ball_1.txt", "-10000\r\n" + step_of() + step_of(1000));
  const Result<Recording> recording = import_icub_grasp(folder_);
  ASSERT_TRUE(recording);
  ASSERT_EQ(recording->explorations.size(), 1U);
  const Exploration& grasp = recording->explorations[0];
  ASSERT_EQ(grasp.channels.size(), 3U);
  const std::size_t sizes[] = {9, 5, 60};
  const float starts[] = {0.5F, 10.5F, 100.5F};
  for (std::size_t c = 0; c < 3; ++c) {
    const Matrix<float>& frames = grasp.channels[c].frames;
    ASSERT_EQ(frames.rows(), 2U);
    ASSERT_EQ(frames.columns(), sizes[c]);
    for (std::size_t i = 0; i < sizes[c]; ++i) {
      EXPECT_EQ(frames(0, i), starts[c] + static_cast<float>(i));
      EXPECT_EQ(frames(1, i), starts[c] + static_cast<float>(i) + 1000.0F);
    }
  }
}

TEST_F(ImportIcubGrasp, NamesChannelsUnitsAndElements) {
  write("ball_1.txt", "-10000\n" + step_of());
  const Result<Recording> recording = import_icub_grasp(folder_);
  ASSERT_TRUE(recording);
  EXPECT_TRUE(validate(*recording));
  const std::vector<Channel>& channels = recording->explorations[0].channels;
  EXPECT_EQ(channels[0].name, "joints");
  EXPECT_EQ(channels[0].unit, "deg");
  EXPECT_EQ(channels[0].element_names[1], "thumb_opposition");
  EXPECT_EQ(channels[0].element_names[8], "ring_and_little");
  EXPECT_EQ(channels[1].name, "finger_pressure");
  EXPECT_EQ(channels[1].element_names[4], "little");
  EXPECT_EQ(channels[2].name, "taxels");
  EXPECT_EQ(channels[2].unit, "counts");
  EXPECT_EQ(channels[2].element_names[12], "index_1");
  EXPECT_EQ(channels[2].element_names[59], "little_12");
  EXPECT_TRUE(channels[2].times.empty());
}

TEST_F(ImportIcubGrasp, OrdersByObjectAndTrialNumber) {
  for (const char* name : {"blue_bear_10.txt", "cup_1.txt", "blue_bear_2.txt", "blue_bear_1.txt"}) {
    write(name, "-10000\n" + step_of());
  }
  const Result<Recording> recording = import_icub_grasp(folder_);
  ASSERT_TRUE(recording);
  EXPECT_EQ(sources_of(*recording), (std::vector<std::string>{"blue_bear_1.txt", "blue_bear_2.txt",
                                                              "blue_bear_10.txt", "cup_1.txt"}));
  EXPECT_EQ(recording->explorations[2].labels,
            (std::vector<Label>{{"object", "blue_bear"}, {"trial", "10"}}));
}

TEST_F(ImportIcubGrasp, TakesTheSetsFolderOrItsTrials) {
  write("LICENCE.txt", "not a grasp");
  write("trials/ball_3.txt", "-10000\n" + step_of());
  write("trials/README.md", "not a grasp");
  for (const fs::path& folder : {folder_, folder_ / "trials"}) {
    const Result<Recording> recording = import_icub_grasp(folder);
    ASSERT_TRUE(recording);
    EXPECT_EQ(sources_of(*recording), std::vector<std::string>{"ball_3.txt"});
  }
}

TEST_F(ImportIcubGrasp, ToleratesTheEndOfTheFileAsItComes) {
  const std::string text = "-10000\n" + step_of();
  EXPECT_EQ(error_for(text + "\r\n \n"), "none");
  EXPECT_EQ(error_for(text.substr(0, text.size() - 3)), "none");
}

TEST_F(ImportIcubGrasp, RefusesAFolderThatIsNotThere) {
  const Result<Recording> recording = import_icub_grasp(folder_ / "nowhere");
  ASSERT_FALSE(recording);
  EXPECT_EQ(recording.error().kind, ErrorKind::kSystem);
  EXPECT_EQ(recording.error().where, (folder_ / "nowhere").string());
  EXPECT_EQ(recording.error().what, "the folder cannot be read (No such file or directory)");
}

TEST_F(ImportIcubGrasp, RefusesAFileInPlaceOfAFolder) {
  write("ball_1.txt", "-10000\n" + step_of());
  const Result<Recording> recording = import_icub_grasp(folder_ / "ball_1.txt");
  ASSERT_FALSE(recording);
  EXPECT_EQ(recording.error().kind, ErrorKind::kSystem);
}

TEST_F(ImportIcubGrasp, RefusesAFileThatCannotBeRead) {
  fs::create_directories(folder_ / "ball_1.txt");
  const Result<Recording> recording = import_icub_grasp(folder_);
  ASSERT_FALSE(recording);
  EXPECT_EQ(recording.error().kind, ErrorKind::kSystem);
  EXPECT_EQ(recording.error().what, "cannot read: Is a directory");
  EXPECT_EQ(recording.error().where, (folder_ / "ball_1.txt").string());
}

TEST_F(ImportIcubGrasp, RefusesAFolderWithoutTrials) {
  write("README.md", "nothing here");
  const Result<Recording> recording = import_icub_grasp(folder_);
  ASSERT_FALSE(recording);
  EXPECT_EQ(recording.error().what, "there are no files OBJECT_TRIAL.txt");
  EXPECT_EQ(recording.error().where, folder_.string());
}

TEST_F(ImportIcubGrasp, RefusesFileNamesThatDoNotParse) {
  for (const char* name : {"ball.txt", "_1.txt", "ball_.txt", "ball_x.txt", "ball_1x.txt",
                           "ball_01.txt", "ball_-1.txt", "ball_99999999999.txt"}) {
    write(name, "-10000\n" + step_of());
    const Result<Recording> recording = import_icub_grasp(folder_);
    ASSERT_FALSE(recording) << name;
    EXPECT_EQ(recording.error().what, "the file name is not OBJECT_TRIAL.txt");
    EXPECT_EQ(recording.error().where, (folder_ / name).string());
    fs::remove(folder_ / name);
  }
}

TEST_F(ImportIcubGrasp, RefusesAnEmptyFile) {
  EXPECT_EQ(error_for(""), "ball_1.txt:1: the file is empty");
  EXPECT_EQ(error_for("\r\n \n"), "ball_1.txt:1: the file is empty");
}

TEST_F(ImportIcubGrasp, RefusesAMissingMarker) {
  EXPECT_EQ(error_for(step_of()), "ball_1.txt:1: the first line must be the marker -10000");
}

TEST_F(ImportIcubGrasp, RefusesAGraspWithoutSteps) {
  EXPECT_EQ(error_for("-10000\n"), "ball_1.txt:1: the grasp has no time steps");
}

TEST_F(ImportIcubGrasp, RefusesAnIncompleteStep) {
  EXPECT_EQ(error_for("-10000\n" + step_of() + line_of(9, 0) + line_of(5, 0)),
            "ball_1.txt:10: the last time step has 2 of 7 lines");
}

TEST_F(ImportIcubGrasp, RefusesTheWrongNumberOfFields) {
  const std::string rest = step_of().substr(line_of(9, 0).size());
  EXPECT_EQ(error_for("-10000\n" + line_of(8, 0) + rest),
            "ball_1.txt:2: expected 9 joint angles, found 8 fields");
  EXPECT_EQ(error_for("-10000\n" + line_of(10, 0) + rest),
            "ball_1.txt:2: expected 9 joint angles, found 10 fields");
  EXPECT_EQ(error_for("-10000\n" + step_of() + line_of(9, 0) + line_of(4, 0) +
                      rest.substr(line_of(5, 10).size())),
            "ball_1.txt:10: expected 5 finger pressures, found 4 fields");
  const std::string lacking = step_of().substr(0, step_of().size() - line_of(12, 148).size());
  EXPECT_EQ(error_for("-10000\n" + lacking + line_of(11, 148)),
            "ball_1.txt:8: expected 12 taxels of the little finger, found 11 fields");
}

TEST_F(ImportIcubGrasp, RefusesWhatIsNotAFiniteNumber) {
  for (const char* field : {"abc", "1.5x", "1,5", "nan", "inf", "-inf", "1e99", "--1"}) {
    std::string text = "-10000\n" + step_of();
    text.replace(text.find("2.5 "), 3, field);
    EXPECT_EQ(error_for(text), fmt::format("ball_1.txt:2:9: \"{}\" is not a finite number", field));
  }
}

TEST_F(ImportIcubGrasp, QuotesStrangeFieldsSafelyAndShortly) {
  std::string text = "-10000\n" + step_of();
  text.replace(text.find("0.5 "), 3, "\x1b[31m" + std::string(1000, 'z'));
  EXPECT_EQ(error_for(text),
            "ball_1.txt:2:1: \"\\u001B[31m" + std::string(35, 'z') + "\" is not a finite number");
}

// The shipped example, against what its README says.

Samples last_joints(const Recording& recording) {
  Matrix<float> rows(recording.explorations.size(), 9);
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const Matrix<float>& frames = recording.explorations[i].channels[0].frames;
    for (std::size_t j = 0; j < 9; ++j) rows(i, j) = frames(frames.rows() - 1, j);
  }
  return Samples(std::move(rows));
}

double squared_distance(const SignalView& a, const SignalView& b) {
  return std::transform_reduce(a.values.begin(), a.values.end(), b.values.begin(), 0.0,
                               std::plus<>(), [](double x, double y) { return (x - y) * (x - y); });
}

// The sample that is nearest to sample `left_out`, standardized on all but this one.
std::size_t nearest_other(const Samples& samples, std::size_t left_out) {
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    if (i != left_out) others.push_back(i);
  }
  const Samples standard = Standardization::fit(samples.subset(others)).value().apply(samples);
  std::size_t nearest = others.front();
  for (const std::size_t other : others) {
    if (squared_distance(standard[other], standard[left_out]) <
        squared_distance(standard[nearest], standard[left_out])) {
      nearest = other;
    }
  }
  return nearest;
}

TEST(SyntheticGrasps, AreWhatTheirReadmeSays) {
  const auto recording = import_icub_grasp(source_path("examples/synthetic_grasps"));
  ASSERT_TRUE(recording) << to_string(recording.error());
  EXPECT_TRUE(validate(*recording));
  EXPECT_EQ(recording->explorations.size(), 30U);
  EXPECT_EQ(label_values(*recording, "object"),
            (std::vector<std::string>{"ball_large", "ball_small", "block_large", "block_small",
                                      "cylinder_large", "cylinder_small"}));
  EXPECT_EQ(label_values(*recording, "trial")->size(), 5U);
  for (const Exploration& grasp : recording->explorations) {
    EXPECT_GE(grasp.channels[0].frames.rows(), 11U);
    EXPECT_LE(grasp.channels[0].frames.rows(), 13U);
  }
}

TEST(SyntheticGrasps, AreNeitherTrivialNorHopeless) {
  const auto recording = import_icub_grasp(source_path("examples/synthetic_grasps"));
  ASSERT_TRUE(recording);
  const Samples samples = last_joints(*recording);
  int right = 0;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    const std::size_t nearest = nearest_other(samples, i);
    right += recording->explorations[nearest].labels[0] == recording->explorations[i].labels[0];
  }
  EXPECT_EQ(right, 27);
}

}  // namespace
}  // namespace somato
