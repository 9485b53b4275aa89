#include "studies/fold_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "somato/maps/areas.h"
#include "somato/maps/som_training.h"
#include "somato/studies/wrong_groupings.h"
#include "support/made_recording.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

constexpr std::size_t kSamples = 12;

StudyDescription small_study() {
  StudyDescription description;
  description.study.name = "small";
  description.vector.channels = {"joints"};
  description.map.rows = 4;
  description.map.columns = 3;
  description.map.iterations = 150;
  return description;
}

// Classes that overlap, so that maps make mistakes and areas tear.
Recording recording() {
  return testing::objects_apart(3, kSamples / 3, 150.0, 7);
}

Question question_of(const Recording& asked) {
  return make_question(small_study(), asked).value();
}

std::vector<PreparedFold> prepared(const Question& question, Protocol protocol) {
  return prepare_folds(question, small_study().vector, protocol).value();
}

SomParameters parameters() {
  return resolve(small_study().map, kSamples, 3).value();
}

std::vector<float> values_of(const Samples& samples, std::size_t index) {
  std::vector<float> values(samples.size());
  write_dense(samples[index], values);
  return values;
}

// What a fold is to give, put together step by step from the map.
class Recomputed {
 public:
  Recomputed(const PreparedFold& prepared, const Numbers& classes)
      : prepared_(prepared),
        som_(train_som(parameters(), prepared.samples.subset(prepared.fold.training)).value()) {
    for (const std::size_t i : prepared.fold.training) ++votes_[winner(i)][classes[i]];
  }

  std::size_t winner(std::size_t sample) { return som_.winner(at(sample), workspace_); }

  double distance(std::size_t sample) {
    return som_.distance(at(sample), winner(sample), workspace_);
  }

  bool torn(std::size_t sample) {
    const Winners winners = som_.winners(at(sample), workspace_);
    return !som_.grid().adjacent(winners.first, winners.second);
  }

  // The class of the nearest neuron that won a training sample.
  std::size_t prediction(std::size_t sample) {
    std::size_t nearest = votes_.begin()->first;
    for (const auto& [neuron, votes] : votes_) {
      if (som_.distance(at(sample), neuron, workspace_) <
          som_.distance(at(sample), nearest, workspace_)) {
        nearest = neuron;
      }
    }
    std::size_t named = votes_[nearest].begin()->first;
    for (const auto& [its_class, votes] : votes_[nearest]) {
      if (votes > votes_[nearest][named]) named = its_class;
    }
    return named;
  }

  const Grid& grid() const { return som_.grid(); }

 private:
  SignalView at(std::size_t sample) const { return prepared_.samples[sample]; }

  const PreparedFold& prepared_;
  Som som_;
  SomWorkspace workspace_;
  std::map<std::size_t, std::map<std::size_t, std::size_t>> votes_;
};

void compare(const PreparedFold& fold, const Question& question) {
  const Numbers& classes = question.classes.of_sample;
  const auto wrong = wrong_groupings(classes, question.individuals, 25, 1);
  const FoldOutcome outcome = run_fold(parameters(), fold, classes, wrong).value();
  Recomputed expected(fold, classes);
  double distance = 0.0;
  double torn = 0.0;
  ASSERT_EQ(outcome.winners.size(), fold.fold.test.size());
  for (std::size_t i = 0; i < fold.fold.test.size(); ++i) {
    const std::size_t sample = fold.fold.test[i];
    EXPECT_EQ(outcome.winners[i], expected.winner(sample));
    EXPECT_EQ(outcome.predictions[i], expected.prediction(sample));
    distance += expected.distance(sample);
    torn += expected.torn(sample) ? 1.0 : 0.0;
  }
  EXPECT_NEAR(outcome.summed_distance, distance, 1e-9 * distance);
  EXPECT_NEAR(outcome.torn, torn, 1e-9);
  Numbers winners;
  for (std::size_t sample = 0; sample < kSamples; ++sample) {
    winners.push_back(expected.winner(sample));
  }
  const WinnerAreas areas(expected.grid(), winners);
  EXPECT_EQ(outcome.apart, individuals_apart(winners, classes));
  EXPECT_EQ(outcome.connected, areas.connected(classes));
  const auto connected = std::count_if(wrong.begin(), wrong.end(),
                                       [&](const Numbers& w) { return areas.connected(w); });
  EXPECT_NEAR(outcome.connected_wrong, static_cast<double>(connected) / 25.0, 1e-12);
}

TEST(FoldRun, GivesWhatFollowsFromItsMap) {
  const Question question = question_of(recording());
  for (const Protocol protocol : {Protocol::kTrainIsTest, Protocol::kLeaveOneOut}) {
    for (const PreparedFold& fold : prepared(question, protocol)) compare(fold, question);
  }
}

TEST(FoldRun, WithoutWrongGroupingsHasNoneConnected) {
  const Question question = question_of(recording());
  const auto folds = prepared(question, Protocol::kTrainIsTest);
  EXPECT_EQ(run_fold(parameters(), folds[0], question.classes.of_sample, {})->connected_wrong, 0.0);
}

Recording with_extreme(std::size_t sample) {
  Recording changed = recording();
  for (float& value : changed.explorations[sample].channels[0].frames.values()) {
    value = value * -1e4F + 3e6F;
  }
  return changed;
}

// The outcome for the samples that the fold was trained on: all that can be seen of its map.
FoldOutcome outcome_of_training(PreparedFold fold, const Question& question) {
  fold.fold.test = fold.fold.training;
  return run_fold(parameters(), fold, question.classes.of_sample, {}).value();
}

TEST(HeldOut, NothingIsLearnedFromTheValuesOfTheTestedSample) {
  const Question question = question_of(recording());
  const auto folds = prepared(question, Protocol::kLeaveOneOut);
  for (std::size_t sample = 0; sample < kSamples; ++sample) {
    const Question other = question_of(with_extreme(sample));
    const PreparedFold changed = prepared(other, Protocol::kLeaveOneOut)[sample];
    ASSERT_EQ(changed.fold.test, Numbers{sample});
    for (const std::size_t i : changed.fold.training) {
      EXPECT_EQ(values_of(changed.samples, i), values_of(folds[sample].samples, i));
    }
    EXPECT_NE(values_of(changed.samples, sample), values_of(folds[sample].samples, sample));
    const FoldOutcome before = outcome_of_training(folds[sample], question);
    const FoldOutcome after = outcome_of_training(changed, other);
    EXPECT_EQ(after.winners, before.winners);
    EXPECT_EQ(after.predictions, before.predictions);
    EXPECT_EQ(after.summed_distance, before.summed_distance);
    EXPECT_EQ(after.torn, before.torn);
  }
}

// The same change does reach every fold that trains on the sample: the test above can fail.
TEST(HeldOut, TheOtherFoldsDoLearnFromIt) {
  const auto folds = prepared(question_of(recording()), Protocol::kLeaveOneOut);
  const auto changed = prepared(question_of(with_extreme(0)), Protocol::kLeaveOneOut);
  for (std::size_t fold = 1; fold < kSamples; ++fold) {
    const std::size_t other = fold == 1 ? 2 : 1;
    EXPECT_NE(values_of(changed[fold].samples, other), values_of(folds[fold].samples, other));
  }
}

// Samples 1 to 3 of each object; the first keeps the classes numbered as they are.
TEST(HeldOut, NothingIsLearnedFromTheLabelOfTheTestedSample) {
  const Question question = question_of(recording());
  for (std::size_t sample = 0; sample < kSamples; ++sample) {
    if (sample % 4 == 0) continue;
    for (std::size_t wrong_class = 0; wrong_class < 3; ++wrong_class) {
      Question relabelled = question;
      relabelled.classes.of_sample[sample] = wrong_class;
      const PreparedFold before = prepared(question, Protocol::kLeaveOneOut)[sample];
      const PreparedFold after = prepared(relabelled, Protocol::kLeaveOneOut)[sample];
      EXPECT_EQ(after.raw_baseline, before.raw_baseline);
      EXPECT_EQ(after.standardized_baseline, before.standardized_baseline);
      EXPECT_EQ(run_fold(parameters(), after, relabelled.classes.of_sample, {})->predictions,
                run_fold(parameters(), before, question.classes.of_sample, {})->predictions);
    }
  }
}

}  // namespace
}  // namespace somato
