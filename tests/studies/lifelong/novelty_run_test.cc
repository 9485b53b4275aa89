#include "studies/lifelong/novelty_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "maps/reading/class_whitening.h"
#include "recordings/support/made_recording.h"
#include "somato/graph/answers.h"
#include "somato/graph/system_model.h"
#include "studies/support/made_study.h"
#include "studies/support/study_results.h"

namespace somato {
namespace {

using testing::grasps;
using testing::joints_system;
using testing::json_of;
using testing::outcome_of;
using testing::study_from;
using testing::system_of;
using testing::values_of;
using Numbers = std::vector<std::size_t>;

const Progress kOn = [](std::uint64_t, std::uint64_t) { return true; };

StudyDescription unknown_study(const std::string& settings) {
  return study_from("[study]\nname = 'unknown'\nseeds = 2\n" + settings + joints_system());
}

StudyDescription wary_study() {
  return unknown_study("protocols = ['train_is_test']\nunknown = true\nfalse_alarm_rate = 0.1\n");
}

// A trained fold of the first explorations, and the values of the map for all of them.
struct Trained {
  explicit Trained(std::size_t training)
      : recording(grasps(3, 8, 5)),
        prepared(prepare_study(wary_study(), recording, nullptr, 1).value()) {
    for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
      (i % 8 < training ? fold.training : fold.test).push_back(i);
    }
    outcome = train_fold(wary_study(), prepared, fold, 1, kOn).value();
  }

  Recording recording;
  PreparedStudy prepared;
  Fold fold;
  TrainedFold outcome;
};

// Every neuron by itself, with weights and distances in double precision.
double plain_distance(const Som& som, const SignalView& input, std::size_t neuron) {
  double sum = 0.0;
  for (std::size_t d = 0; d < som.input_size(); ++d) {
    const double difference = double{input.values[d]} - double{som.weight(neuron, d)};
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

std::size_t plain_nearest(const Som& som, const SignalView& input, const Numbers& neurons) {
  std::size_t nearest = neurons.front();
  for (const std::size_t neuron : neurons) {
    if (plain_distance(som, input, neuron) < plain_distance(som, input, nearest)) nearest = neuron;
  }
  return nearest;
}

TEST(NoveltyRun, ScalesAndNearestNeuronsAreThoseOfPlainLoops) {
  const Trained trained(6);
  const Som& som = *som_of(trained.outcome.system, trained.prepared.map);
  const auto& inputs = trained.outcome.inputs;
  Numbers all(som.neurons());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::map<std::size_t, Numbers> samples_of;  // by winner
  for (const std::size_t one : trained.fold.training) {
    samples_of[plain_nearest(som, inputs.samples[inputs.places_of(Numbers{one}).front()], all)]
        .push_back(one);
  }
  Numbers won;
  for (const auto& [neuron, samples] : samples_of) won.push_back(neuron);
  const auto distance_from = [&](std::size_t one, bool without_own) {
    const SignalView input = inputs.samples[inputs.places_of(Numbers{one}).front()];
    Numbers neurons = won;
    if (without_own) {
      std::erase_if(neurons, [&](std::size_t n) { return samples_of[n] == Numbers{one}; });
    }
    return plain_distance(som, input, plain_nearest(som, input, neurons));
  };
  std::vector<double> distances;
  for (const std::size_t one : trained.fold.training) distances.push_back(distance_from(one, true));
  Numbers classes;
  for (const std::size_t one : trained.fold.training) classes.push_back(one / 8);
  const LabelledMap map =
      labelled_map(trained.outcome, trained.prepared, trained.fold.training, 1.0);
  const auto expected = class_scales(classes, distances, 3).value();
  const auto scales = map.scales().value();
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(scales[c], expected[c], 1e-5) << c;
  const auto nearest = map.nearest(trained.fold.test);
  ASSERT_EQ(nearest.size(), trained.fold.test.size());
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    EXPECT_NEAR(nearest[i].distance, distance_from(trained.fold.test[i], false), 1e-5);
  }
}

// Scales and distances after whitening, again with plain loops.
TEST(NoveltyRun, WhitenedScoresAreThoseOfPlainLoops) {
  const Trained trained(6);
  const Som& som = *som_of(trained.outcome.system, trained.prepared.map);
  const auto& inputs = trained.outcome.inputs;
  const Numbers& training = trained.fold.training;
  Numbers classes;
  for (const std::size_t one : training) classes.push_back(one / 8);
  const Matrix<double> whitening =
      whitening_within_classes(inputs.samples, inputs.places_of(training), classes, 0.3);
  const auto whitened_distance = [&](std::size_t one, std::size_t neuron) {
    const SignalView input = inputs.samples[inputs.places_of(Numbers{one}).front()];
    double squared = 0.0;
    for (std::size_t i = 0; i < som.input_size(); ++i) {
      double sum = 0.0;
      for (std::size_t d = 0; d < som.input_size(); ++d) {
        sum += whitening(i, d) * (double{input.values[d]} - double{som.weight(neuron, d)});
      }
      squared += sum * sum;
    }
    return std::sqrt(squared);
  };
  std::map<std::size_t, Numbers> samples_of;
  Numbers all(som.neurons());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (const std::size_t one : training) {
    const SignalView input = inputs.samples[inputs.places_of(Numbers{one}).front()];
    samples_of[plain_nearest(som, input, all)].push_back(one);
  }
  const auto nearest = [&](std::size_t one, bool without_own) {
    std::pair best{std::numeric_limits<double>::infinity(), std::size_t{0}};
    for (const auto& [neuron, samples] : samples_of) {
      if (without_own && samples == Numbers{one}) continue;
      best = std::min(best, std::pair{whitened_distance(one, neuron), neuron});
    }
    return best;
  };
  std::vector<double> distances;
  for (const std::size_t one : training) distances.push_back(nearest(one, true).first);
  const auto expected = class_scales(classes, distances, 3).value();
  const LabelledMap map = labelled_map(trained.outcome, trained.prepared, training, 0.3);
  const auto scales = map.scales().value();
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(scales[c], expected[c], 1e-6 * expected[c]);
  const auto scores = map.held_out_scores(trained.fold.test).value();
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const auto [distance, neuron] = nearest(trained.fold.test[i], false);
    const double score = distance / expected[*map.labels()[neuron]];
    EXPECT_NEAR(scores[i], score, 1e-6 * score);
  }
}

TEST(NoveltyRun, WhiteningNeedsAEuclideanMap) {
  const std::string text =
      "[study]\nname = 'unknown'\nseeds = 1\nprotocols = ['train_is_test']\nunknown = true\n"
      "false_alarm_rate = 0.1\n";
  std::string manhattan = joints_system();
  manhattan += "similarity = 'manhattan'\n";
  const Recording recording = grasps(3, 8, 5);
  EXPECT_TRUE(run_study(study_from(text + manhattan), recording));
  const auto refused =
      run_study(study_from(text + "whitening_shrinkage = 0.3\n" + manhattan), recording);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
  EXPECT_NE(to_string(refused.error()).find("whitening_shrinkage"), std::string::npos);
}

TEST(NoveltyRun, StatesTheIntervalOfItsThresholds) {
  const StudyDescription study =
      unknown_study("protocols = ['leave_class_out']\nfolds = 4\nfalse_alarm_rate = 0.1\n");
  const StudyOutcome outcome = outcome_of(study, testing::objects_apart(3, 16, 20.0, 3));
  const ProtocolResults& results = system_of(outcome, "leave_class_out");
  const FalseAlarmInterval expected = false_alarm_interval(24, 0.1);  // 3/4 of 32 known ones
  for (const double low : values_of(results, "unknown_false_alarms_low")) {
    EXPECT_NEAR(low, expected.low, 1e-12);
  }
  for (const double high : values_of(results, "unknown_false_alarms_high")) {
    EXPECT_NEAR(high, expected.high, 1e-12);
  }
}

TEST(NoveltyRun, ThresholdDoesNotDependOnTestExplorations) {
  Trained trained(6);
  const auto novelty = [&](const Trained& one) {
    return find_novelty(wary_study(), one.prepared, one.outcome, one.fold.training, 1, kOn).value();
  };
  const Novelty before = novelty(trained);
  EXPECT_EQ(before.samples, 18U);
  EXPECT_EQ(before.false_alarm_rate, 0.1);
  for (const std::size_t one : trained.fold.test) {
    for (float& value : trained.recording.explorations[one].channels[0].frames.values()) {
      value *= 50.0F;
    }
  }
  trained.prepared = prepare_study(wary_study(), trained.recording, nullptr, 1).value();
  trained.outcome = train_fold(wary_study(), trained.prepared, trained.fold, 1, kOn).value();
  EXPECT_EQ(novelty(trained), before);
}

// Parts of two consecutive explorations of each of three classes of eight.
std::vector<double> scores_of_blocks(const Trained& trained) {
  std::vector<double> scores;
  for (std::size_t part = 0; part < 4; ++part) {
    Fold fold;
    for (std::size_t i = 0; i < 24; ++i) {
      (i % 8 / 2 == part ? fold.test : fold.training).push_back(i);
    }
    const TrainedFold without = train_fold(wary_study(), trained.prepared, fold, 1, kOn).value();
    const auto held_out = labelled_map(without, trained.prepared, fold.training, std::nullopt)
                              .held_out_scores(fold.test)
                              .value();
    scores.insert(scores.end(), held_out.begin(), held_out.end());
  }
  std::ranges::sort(scores);
  return scores;
}

// Neighbours are held out together unless the study says otherwise; of 24 scores the rank is
// 25 - floor(2.5).
TEST(NoveltyRun, PartsThatFindAThresholdFollowTheFoldChoice) {
  Trained trained(8);
  StudyDescription description = wary_study();
  description.study.calibration_folds = 4;
  const auto threshold = [&](FoldChoice choice) {
    trained.prepared.samples.choice = choice;
    return find_novelty(description, trained.prepared, trained.outcome, trained.fold.training, 1,
                        kOn)
        ->threshold;
  };
  const double expected = scores_of_blocks(trained)[22];
  EXPECT_EQ(threshold(FoldChoice::kBlocks), expected);
  EXPECT_NE(threshold(FoldChoice::kInterleaved), expected);
}

TEST(NoveltyRun, NeedsEnoughExplorations) {
  const Trained trained(6);
  StudyDescription strict = wary_study();
  strict.study.false_alarm_rate = 0.05;
  const auto novelty =
      find_novelty(strict, trained.prepared, trained.outcome, trained.fold.training, 1, kOn);
  ASSERT_FALSE(novelty);
  EXPECT_EQ(novelty.error().kind, ErrorKind::kData);
}

TEST(NoveltyRun, OnlyASystemThatShouldHasAThreshold) {
  const Recording recording = grasps(3, 8, 5);
  EXPECT_FALSE(outcome_of(unknown_study("protocols = ['train_is_test']\n"), recording)
                   .model.answer->novelty);
  const StudyOutcome outcome = outcome_of(wary_study(), recording);
  ASSERT_TRUE(outcome.model.answer->novelty);
  EXPECT_EQ(outcome.model.answer->novelty->scales.size(), 3U);
  EXPECT_EQ(outcome.model.answer->novelty->samples, 24U);
}

// Where one of an object's two explorations is held out, the other one has no distance within the
// object, and that from other objects must not be taken for it.
TEST(NoveltyRun, KnowsFurtherExplorationsOfObjectsThatWereExploredTwice) {
  const std::string settings = "protocols = ['train_is_test']\nunknown = true\n";
  const StudyOutcome outcome =
      outcome_of(unknown_study(settings), testing::objects_apart(20, 2, 10.0, 3));
  for (const double scale : outcome.model.answer->novelty->scales) EXPECT_LT(scale, 30.0);
  const auto fresh = answers(outcome.model, testing::objects_apart(20, 2, 10.0, 4)).value();
  const auto unknown = std::count_if(fresh.begin(), fresh.end(),
                                     [](const InputAnswer& one) { return one.is_unknown(); });
  EXPECT_LE(unknown, 8);
}

// Two halves, each with one exploration of each object.
TEST(NoveltyRun, NeedsTwoExplorationsOfAClassInEachPart) {
  const StudyDescription halves =
      unknown_study("protocols = ['train_is_test']\nunknown = true\ncalibration_folds = 2\n");
  const auto refused = run_study(halves, testing::objects_apart(20, 2, 10.0, 3));
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.error()).find("calibration_folds"), std::string::npos);
}

// The only exploration of an object is unknown itself when it is held out.
TEST(NoveltyRun, ThresholdDoesNotDependOnTheOnlyExplorationOfAnObject) {
  Recording recording = grasps(3, 8, 5);
  Exploration far = recording.explorations[0];
  far.labels[0].value = "far";
  for (float& value : far.channels[0].frames.values()) value += 1e4F;
  recording.explorations.push_back(std::move(far));
  const StudyOutcome outcome = outcome_of(wary_study(), recording);
  EXPECT_EQ(outcome.model.answer->novelty->samples, 24U);
}

// Three objects apart from each other: each unknown one is far from all that was learned.
TEST(NoveltyRun, NoticesClassesThatWereLeftOut) {
  const StudyDescription study =
      unknown_study("protocols = ['leave_class_out']\nfolds = 4\nfalse_alarm_rate = 0.1\n");
  const Recording recording = testing::objects_apart(3, 16, 20.0, 3);
  const StudyOutcome outcome = outcome_of(study, recording);
  const ProtocolResults& results = system_of(outcome, "leave_class_out");
  EXPECT_EQ(results.samples, 48U);
  EXPECT_EQ(values_of(results, "unknown_auroc"), (std::vector<double>{1.0, 1.0}));
  EXPECT_EQ(values_of(results, "unknown_noticed"), (std::vector<double>{1.0, 1.0}));
  EXPECT_EQ(values_of(results, "unknown_noticed_at_rate"), (std::vector<double>{1.0, 1.0}));
  EXPECT_EQ(values_of(results, "baseline_unknown_auroc"), (std::vector<double>{1.0, 1.0}));
  for (const double alarms : values_of(results, "unknown_false_alarms")) EXPECT_LE(alarms, 0.35);
  EXPECT_TRUE(values_of(results, "accuracy").empty());
  StudyOptions threads;
  threads.threads = 2;
  EXPECT_EQ(json_of(outcome_of(study, recording, threads)), json_of(outcome));
}

// Noise far greater than what separates the objects: nothing can be noticed but by chance.
TEST(NoveltyRun, NoticesNothingWhereAllIsEqual) {
  const StudyDescription study =
      unknown_study("protocols = ['leave_class_out']\nfolds = 4\nfalse_alarm_rate = 0.1\n");
  const StudyOutcome outcome = outcome_of(study, testing::objects_apart(3, 16, 1e5, 4));
  for (const double area : values_of(system_of(outcome, "leave_class_out"), "unknown_auroc")) {
    EXPECT_NEAR(area, 0.5, 0.2);
  }
}

}  // namespace
}  // namespace somato
