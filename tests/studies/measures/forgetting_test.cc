#include "studies/measures/forgetting.h"

#include <gtest/gtest.h>

#include "studies/support/known_metrics.h"

namespace somato {
namespace {

// Three objects with 4, 2 and 2 tested explorations. Object 1: 4/4, 3/4, 1/4; object 2: 1/2, 2/2.
const std::vector<std::size_t> kTested{4, 2, 2};
const LearnerTests kLearner{{{4}, {3, 1}, {1, 2, 2}}, 7};

TEST(Forgetting, IsTheLossSinceTheBestEarlierAccuracy) {
  // (1 - 1/4 + 1/2 - 1) / 2: an object can be named better later.
  EXPECT_DOUBLE_EQ(forgetting(kTested, kLearner), 0.125);
}

TEST(Forgetting, LooksAtTheBestAndNotAtTheFirstAccuracy) {
  EXPECT_DOUBLE_EQ(forgetting({4, 2, 2}, {{{2}, {4, 0}, {1, 0, 0}}, 0}), 0.375);
}

TEST(Forgetting, IsNoneForASingleObject) {
  EXPECT_EQ(forgetting({3}, {{{2}}, 1}), 0.0);
}

TEST(Forgetting, AccuracyIsThatOfAllObjectsSoFar) {
  EXPECT_DOUBLE_EQ(accuracy_after(1, kTested, kLearner), 1.0);
  EXPECT_DOUBLE_EQ(accuracy_after(2, kTested, kLearner), 4.0 / 6.0);
  EXPECT_DOUBLE_EQ(accuracy_after(3, kTested, kLearner), 5.0 / 8.0);
}

// Accuracies of folds are pooled: the best of a mean is not the mean of the best.
TEST(Forgetting, AddsUpFoldsBeforeItComparesAccuracies) {
  ObjectsOutcome one{{1, 1}, std::vector<LearnerTests>(4, {{{1}, {0, 1}}, 10}), 3, 10};
  ObjectsOutcome two{{1, 1}, std::vector<LearnerTests>(4, {{{0}, {1, 1}}, 20}), 3, 20};
  const std::vector<Metric> metrics = continual_metrics({{&one, &two}});
  testing::expect_known_metrics(metrics);
  const auto value = [&](const std::string& name) {
    for (const Metric& metric : metrics) {
      if (metric.name == name) return metric.values.at(0);
    }
    return -1.0;
  };
  EXPECT_DOUBLE_EQ(value("forgetting"), 0.0);  // 1/2 - 1/2
  EXPECT_DOUBLE_EQ(value("accuracy"), 0.75);
  EXPECT_DOUBLE_EQ(value("accuracy_after_1"), 0.5);
  EXPECT_DOUBLE_EQ(value("values_kept"), 45.0);  // 15 vectors of 3 elements
  EXPECT_DOUBLE_EQ(value("neurons"), 15.0);
  EXPECT_DOUBLE_EQ(value("same_memory_accuracy"), 0.75);
}

}  // namespace
}  // namespace somato
