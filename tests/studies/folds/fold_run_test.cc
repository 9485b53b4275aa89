#include "studies/folds/fold_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "base/support/temporary_folder.h"
#include "maps/grid/areas.h"
#include "recordings/support/made_recording.h"
#include "somato/codes/standardization.h"
#include "somato/graph/system_model.h"
#include "somato/maps/som_training.h"
#include "studies/folds/metrics.h"
#include "studies/measures/wrong_groupings.h"
#include "studies/support/made_study.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;
using testing::learning_study;
using testing::small_study;

constexpr std::size_t kSamples = 12;
constexpr std::uint64_t kSeed = 9;
constexpr std::size_t kGroupings = 25;

// Classes that overlap, so that maps make mistakes and areas tear.
Recording fold_recording() {
  return testing::objects_apart(3, kSamples / 3, 150.0, 7);
}

PreparedStudy question_of(const Recording& recording,
                          const StudyDescription& description = small_study()) {
  return prepare_study(description, recording, nullptr, 1).value();
}

TrainedFold trained_on(const PreparedStudy& prepared, const Fold& fold,
                       const StudyDescription& description = small_study()) {
  return train_fold(description, prepared, fold, kSeed, {}).value();
}

std::vector<Fold> folds_of(const PreparedStudy& prepared, Protocol protocol) {
  const bool groups = protocol == Protocol::kLeaveGroupOut;
  return folds(protocol, prepared.divided_by(groups ? prepared.groups.begin()->first : ""));
}

// The map's inputs, put together by hand: joints of the last frame, standardized.
Samples seen_by_hand(const Fold& fold) {
  Matrix<float> joints(kSamples, 3);
  const Recording recording = fold_recording();
  for (std::size_t i = 0; i < kSamples; ++i) {
    for (std::size_t joint = 0; joint < 3; ++joint) {
      joints(i, joint) = recording.explorations[i].channels[0].frames(0, joint);
    }
  }
  const Samples raw(std::move(joints));
  return Standardization::fit(raw.subset(fold.training))->apply(raw);
}

SomParameters parameters(std::uint64_t seed) {
  SomParameters parameters;
  parameters.rows = 5;
  parameters.columns = 5;
  parameters.iterations = 300;
  parameters.seed = seed;
  return parameters;
}

std::vector<float> input_of(const TrainedFold& trained, std::size_t exploration) {
  const Samples& samples = trained.inputs.samples;
  std::vector<float> values(samples.size());
  write_dense(samples[trained.inputs.places_of(std::vector{exploration}).front()], values);
  return values;
}

// The expected results of a fold, put together step by step from the map.
class Recomputed {
 public:
  Recomputed(const Fold& fold, const Numbers& classes, std::uint64_t seed)
      : samples_(seen_by_hand(fold)),
        som_(train_som(parameters(seed), samples_.subset(fold.training)).value()) {
    for (const std::size_t i : fold.training) ++votes_[winner(i)][classes[i]];
  }

  std::size_t winner(std::size_t sample) { return som_.winner(at(sample), workspace_); }

  double distance(std::size_t sample) {
    return som_.distance(at(sample), winner(sample), workspace_);
  }

  bool topographic_errors(std::size_t sample) {
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

  const Som& som() const { return som_; }

 private:
  SignalView at(std::size_t sample) const { return samples_[sample]; }

  Samples samples_;
  Som som_;
  SomWorkspace workspace_;
  std::map<std::size_t, std::map<std::size_t, std::size_t>> votes_;
};

// The results of a training's tests, as test_fold() and nearest_neighbours() give them together.
FoldOutcome outcome_of(const TrainedFold& trained, const PreparedStudy& prepared,
                       const Fold& fold) {
  return test_fold(trained, prepared, fold, nearest_neighbours(trained.vectors, prepared, fold));
}

std::map<std::string, double> metrics_by_name(const PreparedStudy& prepared, const Fold& fold,
                                              const FoldOutcome& outcome) {
  StudyParameters study = small_study().study;
  study.wrong_groupings = kGroupings;
  const std::vector<Fold> folds{fold};
  // The values of one fold of one seed: the whole protocol averages them.
  const MeasuredStudy measured{study, prepared, Protocol::kLeaveOneOut, folds};
  std::map<std::string, double> found;
  for (const Metric& metric : metrics_of(measured, {{kSeed, {&outcome}}})) {
    found[metric.name] = metric.values.at(0);
  }
  return found;
}

void compare_areas(const std::map<std::string, double>& metrics, const PreparedStudy& prepared,
                   const WinnerAreas& areas, const Numbers& winners) {
  const Numbers& classes = prepared.classes().of_sample;
  const auto wrong =
      wrong_groupings(classes, prepared.labels.front().individuals, kGroupings, kSeed);
  EXPECT_EQ(metrics.at("individuals_apart"), individuals_apart(winners, classes) ? 1.0 : 0.0);
  EXPECT_EQ(metrics.at("areas_connected"), areas.connected(classes) ? 1.0 : 0.0);
  double connected = 0.0;
  double apart = 0.0;
  for (const Numbers& grouping : wrong) {
    connected += areas.connected(grouping) ? 1.0 : 0.0;
    apart += individuals_apart(winners, grouping) ? 1.0 : 0.0;
  }
  EXPECT_NEAR(metrics.at("areas_connected_chance"), connected / kGroupings, 1e-12);
  EXPECT_NEAR(metrics.at("individuals_apart_chance"), apart / kGroupings, 1e-12);
}

void compare(const Fold& fold, const PreparedStudy& prepared) {
  const Numbers& classes = prepared.classes().of_sample;
  const TrainedFold trained = trained_on(prepared, fold);
  const FoldOutcome outcome = outcome_of(trained, prepared, fold);
  const Som& som = *som_of(trained.system, prepared.map);
  Recomputed expected(fold, classes, som.parameters().seed);
  EXPECT_EQ(som.weights(), expected.som().weights());
  const Numbers named = predictions(prepared.classes(), fold, outcome);
  double distance = 0.0;
  double topographic_errors = 0.0;
  ASSERT_EQ(outcome.winners.size(), fold.test.size());
  ASSERT_EQ(named.size(), fold.test.size());
  for (std::size_t i = 0; i < fold.test.size(); ++i) {
    const std::size_t sample = fold.test[i];
    EXPECT_EQ(outcome.winners[i], expected.winner(sample));
    EXPECT_EQ(named[i], expected.prediction(sample));
    distance += expected.distance(sample);
    topographic_errors += expected.topographic_errors(sample) ? 1.0 : 0.0;
  }
  EXPECT_NEAR(outcome.summed_distance, distance, 1e-9 * distance);
  EXPECT_NEAR(outcome.topographic_errors, topographic_errors, 1e-9);
  Numbers winners;
  for (std::size_t sample = 0; sample < kSamples; ++sample) {
    winners.push_back(expected.winner(sample));
  }
  ASSERT_EQ(outcome.training_winners.size(), fold.training.size());
  for (std::size_t i = 0; i < fold.training.size(); ++i) {
    EXPECT_EQ(outcome.training_winners[i], winners[fold.training[i]]);
  }
  compare_areas(metrics_by_name(prepared, fold, outcome), prepared,
                WinnerAreas(expected.som().grid(), winners), winners);
}

TEST(FoldRun, GivesWhatFollowsFromItsMap) {
  const PreparedStudy prepared = question_of(fold_recording());
  for (const Protocol protocol : {Protocol::kTrainIsTest, Protocol::kLeaveOneOut}) {
    for (const Fold& fold : folds_of(prepared, protocol)) compare(fold, prepared);
  }
}

// One trial of each object is sparse in elements that the others may not have.
StudyDescription by_products(const std::string& arithmetic) {
  return testing::study_from(
      "[study]\nname = 'products'\nseeds = 2\nfirst_seed = 5\n"
      "[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
      "[module.code]\ntype = 'one_hot'\ninput = 'joints'\nelements = 40\nlow = 0\nhigh = 120\n"
      "[module.memory]\ntype = 'accumulate'\ninput = 'code'\n"
      "[module.map]\ntype = 'som'\ninput = 'memory'\nrows = 5\ncolumns = 5\niterations = 300\n"
      "arithmetic = '" +
      arithmetic + "'\n");
}

void expect_same_but_for_rounding(const FoldOutcome& a, const FoldOutcome& b) {
  EXPECT_EQ(a.training_winners, b.training_winners);
  EXPECT_EQ(a.winners, b.winners);
  EXPECT_EQ(a.named_by, b.named_by);
  EXPECT_EQ(a.nearest, b.nearest);
  EXPECT_NEAR(a.summed_distance, b.summed_distance, 1e-4 * b.summed_distance);
  EXPECT_EQ(a.topographic_errors, b.topographic_errors);
}

// The same values, but not the ones that the map knows.
Samples equal_samples(const Samples& samples) {
  std::vector<std::size_t> all(samples.count());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return samples.subset(all);
}

// The direct way: weights are formed and evaluated.
TEST(FoldRun, InnerProductsAnswerAsTheFormedMapDoes) {
  const Recording recording = testing::grasps(3, 4, 11);
  const StudyDescription description = by_products("inner_products");
  const PreparedStudy prepared = question_of(recording, description);
  for (const Protocol protocol : {Protocol::kTrainIsTest, Protocol::kLeaveOneOut}) {
    for (const Fold& fold : folds_of(prepared, protocol)) {
      TrainedFold trained = trained_on(prepared, fold, description);
      const Som& som = *som_of(trained.system, prepared.map);
      ASSERT_TRUE(som.knows(trained.inputs.samples));
      const FoldOutcome by_inner_products = outcome_of(trained, prepared, fold);
      trained.inputs.samples = equal_samples(trained.inputs.samples);
      ASSERT_FALSE(som.knows(trained.inputs.samples));
      expect_same_but_for_rounding(by_inner_products, outcome_of(trained, prepared, fold));
    }
  }
}

// All folds and seeds find what was computed of the samples.
TEST(FoldRun, FoldsShareTheSamplesProducts) {
  const Recording recording = testing::grasps(3, 4, 11);
  const StudyDescription description = by_products("inner_products");
  const PreparedStudy prepared = question_of(recording, description);
  const auto folds = folds_of(prepared, Protocol::kLeaveOneOut);
  const TrainedFold first = trained_on(prepared, folds[0], description);
  const TrainedFold second = trained_on(prepared, folds[1], description);
  EXPECT_TRUE(first.inputs.samples.is_same_as(second.inputs.samples));
  EXPECT_TRUE(som_of(first.system, prepared.map)->knows(second.inputs.samples));
}

TEST(FoldRun, PlainArithmeticKnowsNoSamples) {
  const Recording recording = testing::grasps(3, 4, 11);
  const StudyDescription description = by_products("plain");
  const PreparedStudy prepared = question_of(recording, description);
  const Fold fold = folds_of(prepared, Protocol::kTrainIsTest).front();
  const TrainedFold trained = trained_on(prepared, fold, description);
  EXPECT_FALSE(som_of(trained.system, prepared.map)->knows(trained.inputs.samples));
  EXPECT_EQ(som_of(trained.system, prepared.map)->neurons(), 25U);
}

// a value of 0 would state that it never occurs by chance.
TEST(FoldRun, WithoutWrongGroupingsSaysNothingAboutChance) {
  const PreparedStudy prepared = question_of(fold_recording());
  const std::vector<Fold> all = folds_of(prepared, Protocol::kTrainIsTest);
  const FoldOutcome outcome = outcome_of(trained_on(prepared, all[0]), prepared, all[0]);
  StudyParameters study = small_study().study;
  study.wrong_groupings = 0;
  const MeasuredStudy measured{study, prepared, Protocol::kTrainIsTest, all};
  const std::vector<Metric> metrics = metrics_of(measured, {{kSeed, {&outcome}}});
  ASSERT_FALSE(metrics.empty());
  for (const Metric& metric : metrics) {
    if (metric.name == "on_border_chance") continue;  // of neurons, not of groupings
    EXPECT_EQ(metric.name.find("_chance"), std::string::npos) << metric.name;
  }
}

Recording with_extreme(Recording changed, const Numbers& samples) {
  for (const std::size_t sample : samples) {
    for (float& value : changed.explorations[sample].channels[0].frames.values()) {
      value = value * -1e4F + 3e6F;
    }
  }
  return changed;
}

// All that a system has learned.
std::string saved_bits(const TrainedFold& trained) {
  const TemporaryFolder folder;
  EXPECT_TRUE(save_system(folder.file("system"), trained.system));
  return bytes_of(folder.file("system"));
}

// All but the areas, which look at what was tested as well.
void expect_same_answers(const FoldOutcome& a, const FoldOutcome& b) {
  EXPECT_EQ(a.training_winners, b.training_winners);
  EXPECT_EQ(a.winners, b.winners);
  EXPECT_EQ(a.named_by, b.named_by);
  EXPECT_EQ(a.nearest, b.nearest);
  EXPECT_EQ(a.summed_distance, b.summed_distance);
  EXPECT_EQ(a.topographic_errors, b.topographic_errors);
}

// Changes every exploration that a fold tests, and expects that nothing learned from them: the same
// saved bits, and the same for all that was learned from.
void expect_nothing_leaks(const StudyDescription& description, const Recording& recording,
                          Protocol protocol) {
  SCOPED_TRACE(choice_name(protocol) + " of " + description.study.name);
  const PreparedStudy prepared = question_of(recording, description);
  for (const Fold& fold : folds_of(prepared, protocol)) {
    const PreparedStudy other = question_of(with_extreme(recording, fold.test), description);
    const TrainedFold before = trained_on(prepared, fold, description);
    const TrainedFold after = trained_on(other, fold, description);
    EXPECT_TRUE(saved_bits(after) == saved_bits(before));
    const Fold learned{fold.training, fold.training};
    expect_same_answers(outcome_of(after, other, learned), outcome_of(before, prepared, learned));
    EXPECT_NE(input_of(after, fold.test.front()), input_of(before, fold.test.front()));
  }
}

TEST(HeldOut, NothingIsLearnedFromTheValuesOfWhatIsTested) {
  StudyDescription description = small_study();
  description.study.protocols = {Protocol::kFolds};
  description.study.folds = 5;
  expect_nothing_leaks(description, fold_recording(), Protocol::kLeaveOneOut);
  expect_nothing_leaks(description, fold_recording(), Protocol::kFolds);
}

// Ranges, a T-MPSOM, a standardization and a map.
TEST(HeldOut, NothingThatLearnsLearnsFromTheValuesOfWhatIsTested) {
  StudyDescription description = learning_study();
  description.study.groups = {"trial"};
  const Recording recording = testing::grasps(3, 3, 4);
  expect_nothing_leaks(description, recording, Protocol::kLeaveGroupOut);
  expect_nothing_leaks(description, recording, Protocol::kLeaveOneOut);
}

// The tested sample is far from the others in one element. If it is scaled by the others only, that
// element decides the nearest neighbour; if scaled by the sample as well, its weight would be
// negligible.
TEST(HeldOut, TheBaselineIsStandardizedByWhatWasLearnedFrom) {
  Recording recording;
  for (const auto& [object, joints] :
       std::vector<std::pair<std::string, std::vector<float>>>{{"x", {1000.0F, 0.0F}},
                                                               {"x", {2.0F, 10.0F}},
                                                               {"y", {0.0F, 0.0F}},
                                                               {"y", {0.5F, 1.0F}},
                                                               {"x", {1.9F, 9.0F}}}) {
    recording.explorations.push_back(testing::exploration_of(object, joints));
  }
  const PreparedStudy prepared = question_of(recording, small_study("none"));
  const Fold first = folds_of(prepared, Protocol::kLeaveOneOut)[0];
  const TrainedFold trained = trained_on(prepared, first, small_study("none"));
  const Neighbours nearest = nearest_neighbours(trained.vectors, prepared, first).front();
  EXPECT_EQ(prepared.classes().of_sample.at(nearest.standardized.at(0)), 0U);
}

// The same change does reach the folds that train on the sample: the tests above can fail.
TEST(HeldOut, TheOtherFoldsDoLearnFromIt) {
  const Recording recording = testing::grasps(3, 3, 4);
  const PreparedStudy prepared = question_of(recording, learning_study());
  const PreparedStudy changed = question_of(with_extreme(recording, {0}), learning_study());
  const auto folds = folds_of(prepared, Protocol::kLeaveOneOut);
  for (std::size_t fold = 1; fold < folds.size(); ++fold) {
    EXPECT_FALSE(saved_bits(trained_on(changed, folds[fold], learning_study())) ==
                 saved_bits(trained_on(prepared, folds[fold], learning_study())));
  }
}

// Samples 1 to 3 of each object; the first keeps the classes numbered as they are.
TEST(HeldOut, NothingIsLearnedFromTheLabelOfTheTestedSample) {
  const PreparedStudy prepared = question_of(fold_recording());
  const auto folds = folds_of(prepared, Protocol::kLeaveOneOut);
  for (std::size_t sample = 0; sample < kSamples; ++sample) {
    if (sample % 4 == 0) continue;
    const TrainedFold trained = trained_on(prepared, folds[sample]);
    const FoldOutcome before = outcome_of(trained, prepared, folds[sample]);
    for (std::size_t wrong_class = 0; wrong_class < 3; ++wrong_class) {
      PreparedStudy relabelled = prepared;
      relabelled.labels.front().classes.of_sample[sample] = wrong_class;
      const FoldOutcome after =
          outcome_of(trained_on(relabelled, folds[sample]), relabelled, folds[sample]);
      EXPECT_EQ(after.nearest, before.nearest);
      EXPECT_EQ(predictions(relabelled.classes(), folds[sample], after),
                predictions(prepared.classes(), folds[sample], before));
    }
  }
}

}  // namespace
}  // namespace somato
