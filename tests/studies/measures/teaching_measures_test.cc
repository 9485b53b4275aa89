#include "studies/measures/teaching_measures.h"

#include <gtest/gtest.h>

#include "somato/core/check.h"

namespace somato {
namespace {

TeachingOutcome outcome(std::size_t factor) {
  TeachingOutcome one;
  one.stages = {
      {{0, 0, 0}, {5 * factor, 6 * factor, 7 * factor}, 0},
      {{1 * factor, 2 * factor, 3 * factor}, {4 * factor, 5 * factor, 8 * factor}, 2 * factor}};
  one.taught_tested = 4 * factor;
  one.known_tested = 10 * factor;
  one.names = factor;
  one.refused = factor - 1;
  return one;
}

double value(const std::vector<Metric>& metrics, const std::string& name, std::size_t seed) {
  for (const Metric& metric : metrics) {
    if (metric.name == name) return metric.values.at(seed);
  }
  ADD_FAILURE() << "no metric " << name;
  return -1.0;
}

TEST(TeachingMeasures, AreSharesOfTheTestedExplorations) {
  const auto metrics = teaching_metrics({outcome(1), outcome(2)});
  EXPECT_EQ(metrics.size(), 3U + 2 * 3U + 1U + 1U);
  for (std::size_t seed = 0; seed < 2; ++seed) {
    EXPECT_EQ(value(metrics, "taught_accuracy_after_1", seed), 0.25);
    EXPECT_EQ(value(metrics, "taught_accuracy_of_nearest_after_1", seed), 0.5);
    EXPECT_EQ(value(metrics, "baseline_taught_accuracy_after_1", seed), 0.75);
    EXPECT_EQ(value(metrics, "known_accuracy_after_0", seed), 0.5);
    EXPECT_EQ(value(metrics, "known_accuracy_after_1", seed), 0.4);
    EXPECT_EQ(value(metrics, "known_accuracy_of_nearest_after_0", seed), 0.6);
    EXPECT_EQ(value(metrics, "baseline_known_accuracy_after_1", seed), 0.8);
    EXPECT_EQ(value(metrics, "known_changed_after_1", seed), 0.2);
  }
  EXPECT_EQ(value(metrics, "names_refused", 0), 0.0);
  EXPECT_EQ(value(metrics, "names_refused", 1), 0.5);
}

TEST(TeachingMeasures, AddUp) {
  TeachingOutcome sum;
  sum.add(outcome(1));
  sum.add(outcome(2));
  TeachingOutcome expected = outcome(3);
  expected.refused = 1;
  EXPECT_EQ(sum, expected);
}

TEST(TeachingMeasures, NeedTestedExplorations) {
  TeachingOutcome empty = outcome(1);
  empty.taught_tested = 0;
  EXPECT_THROW(teaching_metrics({empty}), InvalidArgument);
}

}  // namespace
}  // namespace somato
