#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "studies/folds/fold_run.h"
#include "studies/folds/metrics.h"
#include "studies/support/study_results.h"
#include "studies/support/two_senses.h"

namespace somato {
namespace {

using testing::outcome_of;
using testing::system_of;
using testing::two_senses;
using testing::two_senses_study;
using testing::values_of;

const Fold kLastTrials{{0, 1, 3, 4, 6, 7}, {2, 5, 8}};

// Replaces a channel of the tested explorations by something without meaning.
Recording spoilt(std::size_t channel) {
  Recording recording = two_senses(3, 3, 4);
  for (const std::size_t test : kLastTrials.test) {
    for (float& value : recording.explorations[test].channels[channel].frames.values()) {
      value = 100.0F;
    }
  }
  return recording;
}

FoldOutcome outcome_with(const StudyDescription& description, const Recording& recording) {
  const PreparedStudy prepared = prepare_study(description, recording, nullptr, 1).value();
  const TrainedFold trained = train_fold(description, prepared, kLastTrials, 6, {}).value();
  return test_fold(trained, prepared, kLastTrials,
                   nearest_neighbours(trained.vectors, prepared, kLastTrials));
}

// The neuron that names is the strongest of the activity called up among those that training
// samples won, each step computed from the system's outputs.
TEST(Recall, NamesByTheStrongestNeuronThatWasWon) {
  const StudyDescription description =
      testing::study_from("[study]\nname = 'senses'\nmap = 'felt'\nrecall = 'called'\n" +
                          testing::two_senses_system(9));
  const Recording recording = two_senses(3, 3, 4);
  const PreparedStudy prepared = prepare_study(description, recording, nullptr, 1).value();
  const TrainedFold trained = train_fold(description, prepared, kLastTrials, 6, {}).value();
  const FoldOutcome outcome = test_fold(trained, prepared, kLastTrials, {});
  Activations activations(trained.system.modules().size(), recording.explorations.size());
  const std::size_t called = *trained.system.find("called");
  ASSERT_TRUE(evaluate(trained.system, recording, kLastTrials.test, {called}, 1, activations));
  const auto& won = outcome.training_winners;
  for (std::size_t i = 0; i < kLastTrials.test.size(); ++i) {
    const std::span<const float> activity =
        activations.find(called, kLastTrials.test[i])->values[0].values;
    std::size_t naming = 81;
    for (std::size_t neuron = 0; neuron < 81; ++neuron) {
      if (std::count(won.begin(), won.end(), neuron) == 0) continue;
      if (naming == 81 || activity[neuron] > activity[naming]) naming = neuron;
    }
    EXPECT_EQ(outcome.named_by[i], naming);
    EXPECT_EQ(outcome.recalled[i],
              std::max_element(activity.begin(), activity.end()) - activity.begin());
  }
  EXPECT_NE(outcome.named_by, outcome.recalled);  // an unlabelled neuron was the strongest
}

TEST(Recall, DependsOnTheSenseThatCallsUpAndNotOnTheOther) {
  const FoldOutcome whole = outcome_with(two_senses_study(), two_senses(3, 3, 4));
  const FoldOutcome without_felt = outcome_with(two_senses_study(), spoilt(1));
  EXPECT_EQ(without_felt.named_by, whole.named_by);
  EXPECT_EQ(without_felt.nearest, whole.nearest);
  EXPECT_NE(outcome_with(two_senses_study(), spoilt(0)).named_by, whole.named_by);
  const FoldOutcome own = outcome_with(two_senses_study(""), two_senses(3, 3, 4));
  EXPECT_NE(outcome_with(two_senses_study(""), spoilt(1)).named_by, own.named_by);
}

TEST(Recall, IsMeasuredByTheClassesItNames) {
  StudyDescription description = two_senses_study();
  description.study.protocols = {Protocol::kLeaveOneOut};
  const StudyOutcome outcome = outcome_of(description, two_senses(3, 6, 4));
  const ProtocolResults& results = system_of(outcome, "leave_one_out");
  const auto& predictions = results.runs.front().predictions;
  const auto& labels = results.runs.front().labels;
  double right = 0.0;
  double chance = 0.0;
  std::map<std::string, double> named;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    right += predictions[i] == labels[i] ? 1.0 / 18.0 : 0.0;
    chance += 6.0 * 1.0 / (18.0 * 18.0);  // six of each object
  }
  EXPECT_NEAR(values_of(results, "accuracy").at(0), right, 1e-12);
  EXPECT_NEAR(values_of(results, "accuracy_chance").at(0), chance, 1e-12);
  EXPECT_GT(right, 0.6);
  // Nothing is said about the map on its own sense.
  for (const char* left_out :
       {"quantization_error", "topographic_error", "areas_connected", "individuals_apart"}) {
    EXPECT_TRUE(values_of(results, left_out).empty()) << left_out;
  }
}

TEST(Recall, OfASumOfTheMapAndTheAssociationComparesBothSenses) {
  StudyDescription description = testing::study_from(
      "[study]\nname = 'senses'\nmap = 'felt'\nrecall = 'both'\n" + testing::two_senses_system() +
      "[module.both]\ntype = 'sum'\ninputs = ['felt', 'called']\n");
  const PreparedStudy prepared =
      prepare_study(description, two_senses(3, 3, 4), nullptr, 1).value();
  ASSERT_TRUE(prepared.fixed_vectors);
  EXPECT_EQ(prepared.fixed_vectors->samples.size(), 5U);
}

}  // namespace
}  // namespace somato
