#include "studies/folds/metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "studies/support/known_metrics.h"
#include "studies/support/prepared_study.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;
using Values = std::vector<double>;

constexpr std::size_t kWrongGroupings = 50;

Numbers first_numbers(std::size_t count) {
  Numbers numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(i);
  return numbers;
}

// Diagonal neighbours do not touch, so the classes tear; dealt in either other way they do not.
// All samples at one neuron are never apart, and one of the classes has no neuron.
const Grid kSquare(2, 2, Lattice::kRectangular, Topology::kPlane);

// All samples for both, in one training a seed.
FoldOutcome tested_on_itself(const Numbers& winners) {
  FoldOutcome outcome;
  outcome.map.grid = kSquare;
  outcome.training_winners = winners;
  outcome.winners = winners;
  outcome.named_by = winners;
  outcome.nearest = {first_numbers(winners.size()), first_numbers(winners.size())};
  return outcome;
}

class Metrics : public ::testing::Test {
 protected:
  // One value a seed; throws where there is no such metric.
  Values values(const std::string& name) const {
    const auto found = std::find_if(metrics_.begin(), metrics_.end(),
                                    [&](const Metric& metric) { return metric.name == name; });
    return found == metrics_.end() ? throw std::out_of_range(name) : found->values;
  }
  std::vector<Distribution> of_each(const std::string& name) const {
    const auto found = std::find_if(metrics_.begin(), metrics_.end(),
                                    [&](const Metric& metric) { return metric.name == name; });
    return found == metrics_.end() ? throw std::out_of_range(name) : found->of_each;
  }
  bool has(const std::string& name) const {
    return std::any_of(metrics_.begin(), metrics_.end(),
                       [&](const Metric& metric) { return metric.name == name; });
  }

  // `outcomes` hold the folds of the first seed, then those of the next.
  void measure(const PreparedStudy& prepared, Protocol protocol, const std::vector<Fold>& folds,
               const std::vector<FoldOutcome>& outcomes,
               std::size_t wrong_groupings = kWrongGroupings) {
    StudyParameters study;
    study.wrong_groupings = wrong_groupings;
    std::vector<SeedOutcome> seeds;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      if (i % folds.size() == 0) seeds.push_back({i, {}});
      seeds.back().folds.push_back(&outcomes[i]);
    }
    metrics_ = metrics_of({study, prepared, protocol, folds}, seeds);
    testing::expect_known_metrics(metrics_);
  }

  std::vector<Metric> metrics_;
};

TEST_F(Metrics, OfAreasAreComparedWithChance) {
  const PreparedStudy prepared = testing::study_of({testing::letter_label("object", "ABBA")});
  const std::vector<Fold> folds{{first_numbers(4), first_numbers(4)}};
  measure(prepared, Protocol::kTrainIsTest, folds,
          {tested_on_itself({0, 1, 2, 3}), tested_on_itself({0, 0, 0, 0}),
           tested_on_itself({0, 1, 1, 0})});
  EXPECT_EQ(values("individuals_apart"), (Values{1, 0, 1}));
  EXPECT_EQ(values("individuals_apart_chance"), (Values{1, 0, 0}));
  EXPECT_EQ(values("areas_connected"), (Values{0, 0, 1}));
  EXPECT_EQ(values("areas_connected_chance"), (Values{1, 0, 0}));
  EXPECT_EQ(of_each("areas_connected_chance"),
            (std::vector<Distribution>{{{1, 50}}, {{0, 50}}, {{0, 50}}}));
  EXPECT_TRUE(of_each("areas_connected").empty());
}

TEST_F(Metrics, OfAreasAreMeansOverFolds) {
  const PreparedStudy prepared = testing::study_of({testing::letter_label("object", "ABBA")});
  std::vector<FoldOutcome> outcomes(2);
  outcomes[0].training_winners = {1, 2};
  outcomes[0].winners = {0, 3};
  outcomes[1].training_winners = {0, 0};
  outcomes[1].winners = {0, 0};
  for (FoldOutcome& outcome : outcomes) {
    outcome.map.grid = kSquare;
    outcome.named_by = {outcome.training_winners[0], outcome.training_winners[0]};
    outcome.nearest = {{1, 1}, {1, 1}};
  }
  measure(prepared, Protocol::kFolds, {{{1, 2}, {0, 3}}, {{0, 3}, {1, 2}}}, outcomes);
  EXPECT_EQ(values("individuals_apart"), (Values{0.5}));
  EXPECT_EQ(values("individuals_apart_chance"), (Values{0.5}));
  EXPECT_EQ(values("areas_connected"), (Values{0}));
  EXPECT_EQ(values("areas_connected_chance"), (Values{0.5}));
  EXPECT_EQ(of_each("areas_connected_chance"), (std::vector<Distribution>{{{0.5, 50}}}));
}

TEST_F(Metrics, AreOfBothRecordingsOnlyUnderTestData) {
  PreparedStudy prepared = testing::study_of({testing::letter_label("object", "ABBA")});
  prepared.samples.samples = 2;
  prepared.samples.test_samples = 2;
  FoldOutcome outcome;
  outcome.map.grid = kSquare;
  outcome.training_winners = {0, 1};
  outcome.winners = {2, 3};
  outcome.named_by = {0, 1};
  outcome.nearest = {{0, 1}, {1, 0}};
  measure(prepared, Protocol::kTestData, {{{0, 1}, {2, 3}}}, {outcome});
  EXPECT_EQ(values("areas_connected"), (Values{0}));
  EXPECT_EQ(values("areas_connected_chance"), (Values{1}));
  // With A and B there are no other groupings, regardless of the test samples.
  measure(prepared, Protocol::kTrainIsTest, {{{0, 1}, {0, 1}}}, {tested_on_itself({0, 1})});
  EXPECT_EQ(values("areas_connected"), (Values{1}));
  EXPECT_FALSE(has("areas_connected_chance"));
}

TEST_F(Metrics, ByChanceAreLeftOutIfThereAreNone) {
  const PreparedStudy prepared = testing::study_of(
      {testing::letter_label("object", "ABBA"), testing::letter_label("all", "CCCC")});
  const std::vector<Fold> folds{{first_numbers(4), first_numbers(4)}};
  measure(prepared, Protocol::kTrainIsTest, folds, {tested_on_itself({0, 1, 2, 3})}, 0);
  EXPECT_FALSE(has("areas_connected_chance"));
  EXPECT_FALSE(has("individuals_apart_chance"));
  measure(prepared, Protocol::kTrainIsTest, folds, {tested_on_itself({0, 1, 2, 3})});
  EXPECT_TRUE(has("areas_connected_chance"));
  EXPECT_TRUE(has("all.areas_connected"));
  EXPECT_FALSE(has("all.areas_connected_chance"));
}

// Four individuals, each left out in turn: its own name was never learned, that of its shape was.
class MetricsOfLabels : public Metrics {
 protected:
  MetricsOfLabels() {
    const std::vector<Numbers> training{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
    const Numbers named_by{1, 2, 3, 0};
    const Numbers raw{1, 0, 0, 1};
    const Numbers standardized{1, 0, 3, 0};
    std::vector<Fold> folds;
    std::vector<FoldOutcome> outcomes;
    for (std::size_t i = 0; i < 4; ++i) {
      folds.push_back({training[i], {i}});
      FoldOutcome outcome;
      outcome.map.grid = kSquare;
      outcome.training_winners = training[i];  // sample i at neuron i
      outcome.winners = {i};
      outcome.named_by = {named_by[i]};
      outcome.nearest = {{raw[i]}, {standardized[i]}};
      outcome.summed_distance = static_cast<double>(i);
      outcome.topographic_errors = i == 2 ? 1.0 : 0.0;
      outcomes.push_back(outcome);
    }
    const PreparedStudy prepared = testing::study_of({testing::letter_label("object", "abcd"),
                                                      testing::letter_label("shape", "rrss"),
                                                      testing::letter_label("colour", "xyxy")});
    measure(prepared, Protocol::kLeaveGroupOut, folds, outcomes);
  }
};

TEST_F(MetricsOfLabels, NameNothingThatNoFoldLearned) {
  for (const char* name : {"accuracy", "baseline_accuracy", "baseline_accuracy_raw",
                           "baseline_accuracy_standardized"}) {
    EXPECT_FALSE(has(name)) << name;
  }
  EXPECT_TRUE(has("individuals_apart"));
}

// Named after samples 1, 2, 3, 0: r, s, s, r for r, r, s, s; and y, x, y, x for x, y, x, y.
TEST_F(MetricsOfLabels, AreMadeOfEachLabel) {
  EXPECT_EQ(values("shape.accuracy"), (Values{0.5}));
  EXPECT_EQ(values("colour.accuracy"), (Values{0}));
}

// Raw: r, r, r, r and y, x, x, y. Standardized: r, r, s, r and y, x, y, x.
TEST_F(MetricsOfLabels, TakeTheBetterBaselineOfEachLabel) {
  EXPECT_EQ(values("shape.baseline_accuracy_raw"), (Values{0.5}));
  EXPECT_EQ(values("shape.baseline_accuracy_standardized"), (Values{0.75}));
  EXPECT_EQ(values("shape.baseline_accuracy"), (Values{0.75}));
  EXPECT_EQ(values("colour.baseline_accuracy_raw"), (Values{0.5}));
  EXPECT_EQ(values("colour.baseline_accuracy_standardized"), (Values{0}));
  EXPECT_EQ(values("colour.baseline_accuracy"), (Values{0.5}));
}

TEST_F(MetricsOfLabels, OfTheMapsErrorsAreMeansOverTestedSamples) {
  EXPECT_EQ(values("quantization_error"), (Values{1.5}));
  EXPECT_EQ(values("topographic_error"), (Values{0.25}));
  EXPECT_FALSE(has("shape.quantization_error"));
}

// In the order that the reference has them, and nothing of a single map.
TEST_F(MetricsOfLabels, KeepTheirOrder) {
  std::vector<std::string> names;
  for (const Metric& metric : metrics_) {
    if (!metric.name.starts_with("colour.")) names.push_back(metric.name);
  }
  // An object with a single individual has no other grouping.
  EXPECT_EQ(names, (std::vector<std::string>{
                       "individuals_apart", "areas_connected", "shape.accuracy",
                       "shape.baseline_accuracy", "shape.baseline_accuracy_raw",
                       "shape.baseline_accuracy_standardized", "shape.individuals_apart",
                       "shape.individuals_apart_chance", "shape.areas_connected",
                       "shape.areas_connected_chance", "quantization_error", "topographic_error"}));
}

TEST(Predictions, AreTheMajorityAtTheNeuronThatNames) {
  const Classes classes{{"a", "b"}, {1, 0, 0, 1, 1, 0, 1}};
  const Fold fold{{0, 1, 2, 3, 4, 5}, {6, 0, 1}};
  FoldOutcome outcome;
  outcome.training_winners = {5, 5, 5, 2, 7, 7};  // b a a, b, and b a: in a tie the first
  outcome.named_by = {5, 2, 7};
  EXPECT_EQ(predictions(classes, fold, outcome), (Numbers{0, 1, 0}));
}

}  // namespace
}  // namespace somato
