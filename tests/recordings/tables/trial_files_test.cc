#include "recordings/tables/trial_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

class FindTrialFiles : public ::testing::Test {
 protected:
  Result<std::vector<TrialFile>> find(const char* pattern, bool pass_over_others = false) const {
    return find_trial_files(folder_.path(), NamePattern::parse(pattern).value(), pass_over_others);
  }

  void expect_refused(const char* pattern, const std::string& where,
                      const std::string& what) const {
    const auto trials = find(pattern);
    ASSERT_FALSE(trials) << what;
    EXPECT_EQ(trials.error().kind, ErrorKind::kData);
    EXPECT_EQ(trials.error().where, where);
    EXPECT_EQ(trials.error().what, what);
    EXPECT_FALSE(trials.error().advice.empty());
  }

  TemporaryFolder folder_;
};

TEST_F(FindTrialFiles, ComeInNaturalOrderWithTheirLabels) {
  for (const char* name : {"a_10.csv", "b_1.csv", "a_2.csv", "notes.txt"}) folder_.with(name, "");
  const auto trials = find("{object}_{trial}.csv").value();
  ASSERT_EQ(trials.size(), 3U);
  EXPECT_EQ(trials[0].path, folder_.file("a_2.csv"));
  EXPECT_EQ(trials[0].name, "a_2.csv");
  EXPECT_EQ(trials[0].labels, (std::vector<Label>{{"object", "a"}, {"trial", "2"}}));
  EXPECT_EQ(trials[1].path, folder_.file("a_10.csv"));
  EXPECT_EQ(trials[2].path, folder_.file("b_1.csv"));
}

TEST_F(FindTrialFiles, MayBeOneFile) {
  std::filesystem::create_directory(folder_.file("day 2"));
  const std::string file = folder_.with("day 2/a_1.csv", "");
  const auto in = [&](const char* pattern) {
    return find_trial_files(file, NamePattern::parse(pattern).value(), false);
  };
  EXPECT_EQ(in("{day}/{object}_1.csv")->at(0).labels,
            (std::vector<Label>{{"day", "day 2"}, {"object", "a"}}));
  EXPECT_EQ(in("{object}_1.csv")->at(0).name, "a_1.csv");
  EXPECT_EQ(in("{object}_1.csv")->at(0).path, file);
  EXPECT_EQ(in("b_{trial}.csv").error().what,
            "the file name does not match the pattern \"b_{trial}.csv\"");
}

TEST_F(FindTrialFiles, RefuseOthersUnlessTheyMayBePassedOver) {
  folder_.with("a_1.csv", "");
  folder_.with("summary.CSV", "");
  expect_refused("{object}_{trial}.csv", folder_.file("summary.CSV"),
                 "the file name does not match the pattern \"{object}_{trial}.csv\"");
  EXPECT_EQ(find("{object}_{trial}.csv", true)->size(), 1U);
}

TEST_F(FindTrialFiles, RefuseAnEmptyFolder) {
  expect_refused("{a}.csv", folder_.path(), "there are no files \"{a}.csv\"");
}

TEST_F(FindTrialFiles, RefuseAFolderWithoutMatchingFiles) {
  folder_.with("a_1.txt", "");
  expect_refused("{a}.csv", folder_.path(), "there are no files \"{a}.csv\"");
}

TEST_F(FindTrialFiles, RefuseTwoFilesWithTheSameLabels) {
  std::filesystem::create_directory(folder_.file("copy"));
  folder_.with("a_1.csv", "");
  folder_.with("copy/a_1.csv", "");
  expect_refused("{object}_{trial}.csv", folder_.file("copy/a_1.csv"),
                 "the file has the same labels as " + folder_.file("a_1.csv"));
}

TEST_F(FindTrialFiles, RefuseANameWithTwoReadings) {
  folder_.with("a_b_1.csv", "");
  expect_refused(
      "{object}_{trial}.csv", folder_.file("a_b_1.csv"),
      "the name can be read in more than one way: object = 'a', trial = 'b_1'; or object "
      "= 'a_b', trial = '1'");
}

TEST_F(FindTrialFiles, RefuseALabelThatIsNoText) {
  folder_.with("a\xFF.csv", "");
  expect_refused("{object}.csv", folder_.file("a\xFF.csv"),
                 "the label 'object' in the file name is not UTF-8 text");
}

}  // namespace
}  // namespace somato
