#include "studies/folds/prediction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "studies/folds/fold_run.h"
#include "studies/folds/metrics.h"
#include "studies/support/known_metrics.h"
#include "studies/support/two_senses.h"

namespace somato {
namespace {

using Plane = std::vector<float>;
using testing::study_from;
using testing::two_senses;
using testing::two_senses_study;
using testing::two_senses_system;

constexpr double kNear = 1e-12;

const Fold kFold{{0, 1, 3, 4, 6, 7}, {2, 5, 8}};  // the last of three trials of three objects

std::string study(const std::string& predictions) {
  return "[study]\nname = 'senses'\nmap = 'felt'\nprotocols = ['leave_group_out']\n"
         "groups = ['trial']\npredictions = " +
         predictions + "\n";
}

// A system trained on kFold, with its comparisons.
struct Compared {
  StudyDescription description;
  Recording recording;
  PreparedStudy prepared;
  TrainedFold trained;

  explicit Compared(StudyDescription described)
      : description(std::move(described)),
        recording(two_senses(3, 3, 4)),
        prepared(prepare_study(description, recording, nullptr, 1).value()),
        trained(train_fold(description, prepared, kFold, 6, {}).value()) {}

  std::vector<Plane> outputs(const std::string& name, std::size_t exploration) const {
    const std::size_t module = *trained.system.find(name);
    Activations activations(trained.system.modules().size(), recording.explorations.size());
    const std::vector<std::size_t> one{exploration};
    EXPECT_TRUE(evaluate(trained.system, recording, one, {module}, 1, activations));
    const Samples& samples = activations.find(module, exploration)->values;
    std::vector<Plane> values(samples.count(), Plane(samples.size()));
    for (std::size_t i = 0; i < values.size(); ++i) write_dense(samples[i], values[i]);
    return values;
  }
};

std::size_t strongest_of(const Plane& values) {
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

double mean_square(const Plane& a, const Plane& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (static_cast<double>(a[i]) - static_cast<double>(b[i])) *
           (static_cast<double>(a[i]) - static_cast<double>(b[i]));
  }
  return sum / static_cast<double>(a.size());
}

double apart(std::size_t a, std::size_t b) {  // on the map of 3 x 3 neurons
  const double rows = static_cast<double>(a / 3) - static_cast<double>(b / 3);
  const double columns = static_cast<double>(a % 3) - static_cast<double>(b % 3);
  return std::sqrt(rows * rows + columns * columns);
}

TEST(ComparePrediction, SumsOverTheTestExplorations) {
  const Compared compared(study_from(study("['called']") + two_senses_system()));
  double squared = 0.0;
  double right = 0.0;
  double distance = 0.0;
  double chance = 0.0;
  double of_mean = 0.0;
  double of_nearest = 0.0;
  Plane mean(9, 0.0F);
  for (std::size_t neuron = 0; neuron < 9; ++neuron) {
    double sum = 0.0;
    for (const std::size_t i : kFold.training) {
      sum += static_cast<double>(compared.outputs("felt", i)[0][neuron]);
    }
    mean[neuron] = static_cast<float>(sum / 6.0);
  }
  for (const std::size_t test : kFold.test) {
    const Plane called = compared.outputs("called", test)[0];
    const Plane felt = compared.outputs("felt", test)[0];
    squared += mean_square(called, felt);
    of_mean += mean_square(mean, felt);
    right += strongest_of(called) == strongest_of(felt) ? 1.0 : 0.0;
    distance += apart(strongest_of(called), strongest_of(felt));
    for (const std::size_t other : kFold.test) {
      chance += apart(strongest_of(compared.outputs("called", other)[0]), strongest_of(felt)) / 3.0;
    }
    const auto by_seen = [&](std::size_t a, std::size_t b) {
      const Plane seen = compared.outputs("seen_last", test)[0];
      return mean_square(compared.outputs("seen_last", a)[0], seen) <
             mean_square(compared.outputs("seen_last", b)[0], seen);
    };
    const std::size_t nearest =
        *std::min_element(kFold.training.begin(), kFold.training.end(), by_seen);
    of_nearest += mean_square(compared.outputs("felt", nearest)[0], felt);
  }
  const PredictionOutcome& outcome = compared.trained.predictions.at(0);
  EXPECT_EQ(outcome.values, 3.0);
  EXPECT_EQ(outcome.explorations, 3.0);
  EXPECT_NEAR(outcome.predicted.squared, squared, kNear);
  EXPECT_NEAR(outcome.predicted.distance, distance, kNear);
  EXPECT_EQ(outcome.predicted.right, right);
  EXPECT_NEAR(outcome.mean.squared, of_mean, kNear);
  EXPECT_NEAR(outcome.nearest.squared, of_nearest, kNear);
  EXPECT_NEAR(outcome.chance.distance, chance, kNear);
  EXPECT_EQ(outcome.preceding.squared, 0.0);
}

// The next frame of a map of frames, from its own activity one frame earlier.
std::string next_frame() {
  return "[module.frames]\ntype = 'som'\ninput = 'feeling'\nrows = 3\ncolumns = 3\n"
         "[module.before]\ntype = 'delay'\ninput = 'frames'\n"
         "[module.next]\ntype = 'association'\ninput = 'before'\ntarget = 'frames'\n";
}

TEST(ComparePrediction, LeavesOutTheFirstFrame) {
  const Compared compared(study_from(study("['next']") + two_senses_system() + next_frame()));
  double right = 0.0;
  double preceding = 0.0;
  double steps = 0.0;
  for (const std::size_t test : kFold.test) {
    const auto next = compared.outputs("next", test);
    const auto frames = compared.outputs("frames", test);
    bool all_right = true;
    for (std::size_t i = 1; i < 4; ++i) {
      const bool is_right = strongest_of(next[i]) == strongest_of(frames[i]);
      right += is_right ? 1.0 : 0.0;
      preceding += strongest_of(frames[i - 1]) == strongest_of(frames[i]) ? 1.0 : 0.0;
      all_right = all_right && is_right;
      steps += all_right ? 1.0 : 0.0;
    }
  }
  const PredictionOutcome& outcome = compared.trained.predictions.at(0);
  EXPECT_EQ(outcome.values, 9.0);
  EXPECT_EQ(outcome.predicted.right, right);
  EXPECT_EQ(outcome.preceding.right, preceding);
  EXPECT_LT(preceding, 9.0);  // the winner changes
  EXPECT_EQ(outcome.steps_right, steps);
  EXPECT_EQ(outcome.nearest.squared, 0.0);
}

std::vector<std::string> names(const std::vector<Metric>& metrics) {
  std::vector<std::string> all;
  all.reserve(metrics.size());
  for (const Metric& metric : metrics) all.push_back(metric.name);
  return all;
}

PredictionOutcome made(double values, double squared, double right) {
  PredictionOutcome outcome;
  outcome.values = values;
  outcome.explorations = 1.0;
  outcome.steps_right = right;
  outcome.predicted = {squared, right, 2.0 * right};
  outcome.mean = {4.0 * squared, 0.0, 0.0};
  outcome.nearest = {9.0 * squared, 1.0, 1.0};
  outcome.nearest_standardized = {squared, 0.0, 3.0};
  return outcome;
}

TEST(PredictionMetrics, DivideTheSumsOverFoldsByTheValues) {
  Prediction prediction{"called", 0, 1, Rate::kExploration, true, Grid(3, 3, {}, {}), {0}};
  const PredictionOutcome first = made(3.0, 1.0, 2.0);
  const PredictionOutcome second = made(1.0, 35.0, 1.0);
  const auto metrics = prediction_metrics(prediction, {{&first, &second}});
  testing::expect_known_metrics(metrics);
  EXPECT_EQ(names(metrics),
            (std::vector<std::string>{"called.prediction_error", "called.prediction_error_of_mean",
                                      "called.prediction_error_of_nearest",
                                      "called.strongest_right", "called.strongest_right_of_nearest",
                                      "called.strongest_right_chance", "called.strongest_distance",
                                      "called.strongest_distance_of_nearest",
                                      "called.strongest_distance_chance"}));
  const std::vector<double> expected{3.0, 6.0, 3.0, 0.75, 0.5, 0.0, 1.5, 0.5, 0.0};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(metrics[i].values, std::vector{expected[i]}) << metrics[i].name;
  }
}

TEST(PredictionMetrics, OfAQuantityAreErrorsOnly) {
  const Prediction prediction{"aperture", 0, 1, Rate::kExploration, false, {}, {0}};
  const PredictionOutcome outcome = made(4.0, 16.0, 0.0);
  const auto metrics = prediction_metrics(prediction, {{&outcome}});
  EXPECT_EQ(metrics.size(), 3U);
  EXPECT_EQ(metrics.at(0).values, std::vector{2.0});
}

TEST(PredictionMetrics, OfFramesCountTheStepsThatAreRight) {
  const Prediction prediction{"next", 0, 1, Rate::kFrame, true, {}, {}};
  const PredictionOutcome outcome = made(4.0, 16.0, 3.0);
  const auto metrics = prediction_metrics(prediction, {{&outcome, &outcome}});
  testing::expect_known_metrics(metrics);
  EXPECT_EQ(metrics.back().name, "next.steps_right");
  EXPECT_EQ(metrics.back().values, std::vector{3.0});
}

TEST(FindPredictions, RefusesWhatIsNoAssociation) {
  const auto refused = prepare_study(study_from(study("['felt']") + two_senses_system()),
                                     two_senses(3, 3, 4), nullptr, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(to_string(refused.error()),
            "study.toml:1: 'felt' is not an association; name modules of type association in "
            "'predictions'");
}

}  // namespace
}  // namespace somato
