#include "studies/results/tested_folds.h"

#include <gtest/gtest.h>

#include "somato/studies/study.h"
#include "studies/folds/prepared_study.h"
#include "studies/support/made_study.h"

namespace somato {
namespace {

std::vector<std::size_t> numbers_of(const std::vector<Fold>& folds, std::size_t samples) {
  std::vector<std::size_t> numbers(samples);
  for (std::size_t fold = 0; fold < folds.size(); ++fold) {
    for (const std::size_t sample : folds[fold].test) numbers[sample] = fold;
  }
  return numbers;
}

void expect_those_of_the_study(FoldChoice choice) {
  StudyDescription description = testing::small_study("none");
  description.study.protocols = {Protocol::kFolds, Protocol::kLeaveGroupOut};
  description.study.groups = {"trial"};
  description.study.folds = 3;
  description.study.fold_choice = choice;
  const Recording recording = testing::grasps(3, 4, 1);
  const PartResults part = run_study(description, recording).value().results;
  const PreparedStudy prepared = prepare_study(description, recording, nullptr, 1).value();
  ASSERT_EQ(part.protocols.size(), 2U);
  EXPECT_EQ(tested_folds(part.protocols[0], 3, choice, {}),
            numbers_of(folds(Protocol::kFolds, prepared.samples), 12));
  std::vector<std::string> trials;
  for (const Exploration& one : recording.explorations) {
    trials.push_back(find_label(one, "trial").value());
  }
  EXPECT_EQ(tested_folds(part.protocols[1], 3, choice, trials),
            numbers_of(folds(Protocol::kLeaveGroupOut, prepared.divided_by("trial")), 12));
  EXPECT_TRUE(tested_folds(part.protocols[1], 3, choice, {}).empty());
}

TEST(TestedFolds, AreThoseOfTheStudy) {
  for (const auto& [choice, name] : Choices<FoldChoice>::all()) expect_those_of_the_study(choice);
}

TEST(TestedFolds, AreEmptyIfOneMapTestsAllOrASampleEach) {
  ProtocolResults one{"leave_one_out", "", "object", 2, {}, {}};
  EXPECT_TRUE(tested_folds(one, 2, FoldChoice::kBlocks, {}).empty());
  one.runs = {{1, {0, 0}, {"a", "b"}, {"a", "b"}, {}, {}}};
  EXPECT_TRUE(tested_folds(one, 2, FoldChoice::kBlocks, {}).empty());
  one.protocol = "k_folds";
  EXPECT_EQ(tested_folds(one, 2, FoldChoice::kBlocks, {}).size(), 2U);
  one.runs[0].map.emplace();
  EXPECT_TRUE(tested_folds(one, 2, FoldChoice::kBlocks, {}).empty());
}

}  // namespace
}  // namespace somato
