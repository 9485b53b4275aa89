#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/support/temporary_folder.h"
#include "recordings/support/made_recording.h"
#include "studies/support/made_study.h"
#include "studies/support/study_results.h"

namespace somato {
namespace {

using testing::json_of;
using testing::objects_apart;
using testing::outcome_of;
using testing::small_study;

// With everything that a journal keeps.
StudyDescription journal_study() {
  StudyDescription description = small_study();
  description.altered = {{.name = "noisy", .noisy = {"joints"}}};
  return description;
}

Recording journal_recording() {
  return objects_apart(3, 4, 150.0, 2);
}

std::ptrdiff_t lines_of(const std::string& path) {
  const std::string bytes = bytes_of(path);
  return std::count(bytes.begin(), bytes.end(), '\n');
}

class StudyJournal : public ::testing::Test {
 protected:
  std::string path() const { return folder_.file("journal"); }

  StudyOptions options(std::size_t threads = 1) const {
    StudyOptions options;
    options.threads = threads;
    options.journal = path();
    return options;
  }

  // Stops a study when `trainings` are done.
  void interrupt(std::uint64_t trainings, std::size_t threads = 1) const {
    StudyOptions interrupted = options(threads);
    interrupted.progress = [=](std::uint64_t done, std::uint64_t) { return done < trainings; };
    const auto outcome = run_study(journal_study(), journal_recording(), interrupted);
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().kind, ErrorKind::kInterrupted);
  }

  TemporaryFolder folder_;
};

// train_is_test has a training beside that of the model, leave_one_out twelve a seed.
constexpr std::uint64_t kTrainings = 1 + 2 * 12 + 1;

TEST_F(StudyJournal, ResumesWithTheSameResults) {
  const std::string expected = json_of(outcome_of(journal_study(), journal_recording()));
  for (const std::uint64_t trainings : {1U, 2U, 14U, 25U}) {
    interrupt(trainings);
    EXPECT_EQ(lines_of(path()), static_cast<std::ptrdiff_t>(1 + trainings));
    EXPECT_EQ(json_of(outcome_of(journal_study(), journal_recording(), options())), expected);
    // All but that of the model, which is made at the end; what was done was not done again.
    EXPECT_EQ(lines_of(path()), static_cast<std::ptrdiff_t>(kTrainings));
    std::filesystem::remove(path());
  }
}

TEST_F(StudyJournal, ResumesWithTheSameResultsOnThreads) {
  const std::string expected = json_of(outcome_of(journal_study(), journal_recording()));
  for (const std::size_t threads : {2U, 4U}) {
    interrupt(9, threads);
    EXPECT_EQ(json_of(outcome_of(journal_study(), journal_recording(), options(threads))),
              expected);
    EXPECT_EQ(lines_of(path()), static_cast<std::ptrdiff_t>(kTrainings));
    std::filesystem::remove(path());
  }
}

TEST_F(StudyJournal, DoesNotRepeatWhatIsDone) {
  outcome_of(journal_study(), journal_recording(), options());
  const std::string whole = bytes_of(path());
  std::vector<std::uint64_t> reported;
  StudyOptions again = options();
  again.progress = [&](std::uint64_t done, std::uint64_t total) {
    EXPECT_EQ(total, 1U);  // that of the model, which no journal keeps
    reported.push_back(done);
    return true;
  };
  outcome_of(journal_study(), journal_recording(), again);
  ASSERT_FALSE(reported.empty());
  EXPECT_EQ(reported.back(), 1U);
  EXPECT_TRUE(bytes_of(path()) == whole);
}

TEST_F(StudyJournal, ServesAnyNumberOfSeeds) {
  interrupt(20);
  const auto kept = lines_of(path());
  StudyDescription more = journal_study();
  more.study.seeds = 3;
  const StudyOutcome outcome = outcome_of(more, journal_recording(), options());
  EXPECT_EQ(json_of(outcome), json_of(outcome_of(more, journal_recording())));
  EXPECT_EQ(lines_of(path()), 1 + 2 + 3 * 12);
  EXPECT_LT(kept, lines_of(path()));
  StudyDescription fewer = journal_study();
  fewer.study.seeds = 1;
  EXPECT_EQ(json_of(outcome_of(fewer, journal_recording(), options())),
            json_of(outcome_of(fewer, journal_recording())));
}

void expect_other_study(const StudyDescription& description, const Recording& recording,
                        const StudyOptions& options) {
  const auto outcome = run_study(description, recording, options);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(outcome.error().where, options.journal);
  EXPECT_NE(outcome.error().what.find("other settings or data"), std::string::npos);
}

TEST_F(StudyJournal, OfOtherSettingsOrDataIsRefused) {
  interrupt(3);
  StudyDescription other = journal_study();
  other.study.first_seed = 6;
  expect_other_study(other, journal_recording(), options());
  other = journal_study();
  other.study.protocols = {Protocol::kLeaveOneOut, Protocol::kTrainIsTest};
  expect_other_study(other, journal_recording(), options());
  other = journal_study();
  other.study.wrong_groupings = 3;
  expect_other_study(other, journal_recording(), options());
  expect_other_study(small_study("constant_columns = 'zero'\n"), journal_recording(), options());
  expect_other_study(journal_study(), objects_apart(3, 4, 150.0, 3), options());
}

// Another one, none, and the same explorations divided elsewhere.
TEST_F(StudyJournal, OfOtherTestDataIsRefused) {
  Recording first = journal_recording();
  Recording second = objects_apart(3, 2, 150.0, 8);
  StudyOptions with = options();
  with.test_data = &second;
  with.progress = [](std::uint64_t done, std::uint64_t) { return done < 3; };
  ASSERT_FALSE(run_study(journal_study(), first, with));
  with.progress = {};
  const Recording third = objects_apart(3, 2, 150.0, 9);
  with.test_data = &third;
  expect_other_study(journal_study(), first, with);
  with.test_data = &second;
  expect_other_study(journal_study(), first, options());
  first.explorations.push_back(second.explorations.front());
  second.explorations.erase(second.explorations.begin());
  expect_other_study(journal_study(), first, with);
}

TEST_F(StudyJournal, IsNotMadeByAStudyThatCannotBegin) {
  Recording constant = journal_recording();
  for (Exploration& exploration : constant.explorations) {
    exploration.channels[0].frames(0, 1) = 5.0F;
  }
  ASSERT_FALSE(run_study(journal_study(), constant, options()));
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(StudyJournal, ThatCannotBeWrittenStopsTheStudy) {
  StudyOptions nowhere;
  nowhere.journal = folder_.file("missing/journal");
  const auto outcome = run_study(journal_study(), journal_recording(), nowhere);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::kSystem);
  EXPECT_EQ(outcome.error().where, nowhere.journal);
}

}  // namespace
}  // namespace somato
