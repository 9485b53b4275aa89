#include <gtest/gtest.h>

#include <algorithm>

#include "somato/studies/study.h"
#include "studies/results/fold_comparison.h"
#include "studies/support/made_study.h"

namespace somato {
namespace {

constexpr std::size_t kDriftTrials = 12;

// Explorations of three objects whose readings drift so far that only neighbours are alike.
Recording drifting(std::uint64_t seed) {
  Random random(seed);
  Recording recording;
  for (std::size_t object = 0; object < 3; ++object) {
    double x = 0.0;
    double y = 0.0;
    for (std::size_t trial = 0; trial < kDriftTrials; ++trial) {
      if (trial % 4 == 0) {
        x = 100.0 * random.uniform();
        y = 100.0 * random.uniform();
      }
      const Matrix<float> frame(
          1, 2,
          {static_cast<float>(x + random.uniform()), static_cast<float>(y + random.uniform())});
      recording.explorations.push_back({{{"object", "object " + std::to_string(object)}},
                                        {},
                                        {{"joints", "deg", {}, frame, {}}}});
    }
  }
  return recording;
}

StudyDescription folds_study(FoldChoice choice, Protocol protocol = Protocol::kFolds) {
  StudyDescription description = testing::small_study();
  description.study.protocols = {protocol};
  description.study.folds = 3;
  description.study.fold_choice = choice;
  return description;
}

PartResults results_of(const StudyDescription& description, const Recording& recording) {
  return run_study(description, recording).value().results;
}

// The share of right predictions of the first seed, by a study of that seed only.
double accuracy_of_first_seed(StudyDescription description, const Recording& recording) {
  description.study.seeds = 1;
  StudyOptions options;
  options.compare_folds = false;
  const auto outcome = run_study(description, recording, options);
  const Run run = outcome.value().results.protocols.front().runs.front();
  std::size_t right = 0;
  for (std::size_t i = 0; i < run.labels.size(); ++i)
    right += run.labels[i] == run.predictions[i] ? 1 : 0;
  return static_cast<double>(right) / static_cast<double>(run.labels.size());
}

void expect_both_accuracies(const StudyDescription& description, const Recording& recording) {
  const PartResults results = results_of(description, recording);
  const FoldComparison& comparison = *results.protocols.front().fold_comparison;
  EXPECT_EQ(comparison.choice, choice_name(description.study.fold_choice));
  EXPECT_EQ(comparison.samples, recording.explorations.size());
  for (const auto& [choice, name] : Choices<FoldChoice>::all()) {
    StudyDescription own = description;
    own.study.fold_choice = choice;
    EXPECT_DOUBLE_EQ(*accuracy_by(name, comparison), accuracy_of_first_seed(own, recording));
  }
}

TEST(StudyOfFolds, ComparesWithAStudyOfTheOtherChoice) {
  for (const auto& [choice, name] : Choices<FoldChoice>::all()) {
    expect_both_accuracies(folds_study(choice), drifting(1));
  }
}

TEST(StudyOfFolds, ComparesObjectsThatAreLearnedOneAfterAnother) {
  StudyDescription description = folds_study(FoldChoice::kBlocks, Protocol::kObjectAfterObject);
  description.study.seeds = 1;
  description.study.folds = 2;
  expect_both_accuracies(description, testing::grasps(2, 4, 3));
}

TEST(StudyOfFolds, SaysThatNeighboursLeak) {
  const PartResults results = results_of(folds_study(FoldChoice::kBlocks), drifting(1));
  const FoldComparison& comparison = *results.protocols.front().fold_comparison;
  EXPECT_TRUE(neighbours_leak(comparison)) << sentence_of(comparison);
}

TEST(StudyOfFolds, SaysNothingOfTheKindAboutExplorationsInRandomOrder) {
  const PartResults results =
      results_of(folds_study(FoldChoice::kBlocks), testing::grasps(3, 12, 7));
  EXPECT_FALSE(neighbours_leak(*results.protocols.front().fold_comparison));
}

TEST(StudyOfFolds, DoesNotChangeTheStudy) {
  const Recording recording = drifting(2);
  StudyOptions without;
  without.compare_folds = false;
  PartResults compared = results_of(folds_study(FoldChoice::kBlocks), recording);
  const PartResults uncompared =
      run_study(folds_study(FoldChoice::kBlocks), recording, without).value().results;
  EXPECT_FALSE(uncompared.protocols.front().fold_comparison);
  compared.protocols.front().fold_comparison.reset();
  EXPECT_EQ(to_json({{compared}, {}, {}}), to_json({{uncompared}, {}, {}}));
}

TEST(StudyOfFolds, AreNotComparedWhereBlocksAreSingleExplorations) {
  StudyDescription description = folds_study(FoldChoice::kBlocks);
  description.study.folds = 4;
  const PartResults results = results_of(description, testing::grasps(3, 3, 1));
  const FoldComparison& comparison = *results.protocols.front().fold_comparison;
  EXPECT_EQ(comparison.largest_block, 1U);
  EXPECT_EQ(comparison.samples, 0U);
}

TEST(StudyOfFolds, AreNotComparedByOtherProtocols) {
  StudyDescription description = folds_study(FoldChoice::kBlocks, Protocol::kLeaveOneOut);
  EXPECT_FALSE(results_of(description, testing::grasps(2, 4, 1)).protocols.front().fold_comparison);
  description.study.protocols = {Protocol::kFolds};
  description.study.test_last = 1;
  EXPECT_FALSE(results_of(description, testing::grasps(2, 4, 1)).protocols.front().fold_comparison);
}

TEST(StudyOfFolds, HaveTheBestNeighbourUnderEveryProtocol) {
  StudyDescription description = testing::small_study();
  description.study.protocols = {Protocol::kTrainIsTest, Protocol::kLeaveOneOut, Protocol::kFolds,
                                 Protocol::kLeaveGroupOut, Protocol::kObjectAfterObject};
  description.study.groups = {"trial"};
  description.study.folds = 2;
  const Recording recording = testing::grasps(2, 4, 1);
  const Recording more = testing::grasps(2, 2, 9);
  StudyOptions options;
  options.test_data = &more;
  const PartResults results = run_study(description, recording, options).value().results;
  ASSERT_EQ(results.protocols.size(), 6U);
  for (const ProtocolResults& protocol : results.protocols) {
    const Metric* best = protocol.find_metric("best_neighbour_accuracy");
    ASSERT_NE(best, nullptr) << protocol.protocol;
    EXPECT_EQ(best->values.size(), 2U);
    std::size_t folds = 0;
    for (const auto& [kind, count] : protocol.chosen_neighbours) folds += count;
    EXPECT_GE(folds, 2U);
    if (protocol.protocol == "train_is_test") {
      EXPECT_EQ(best->mean(), 1.0);
    }
  }
}

}  // namespace
}  // namespace somato
