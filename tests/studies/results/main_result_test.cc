#include "studies/results/main_result.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

ProtocolResults protocol(const std::string& name, double accuracy, double baseline) {
  ProtocolResults results;
  results.protocol = name;
  results.label = "object";
  results.samples = 4;
  results.metrics = {{"accuracy", {accuracy}, {}}, {"baseline_accuracy", {baseline}, {}}};
  results.runs = {{1, {0, 0, 0, 0}, {"a", "a", "b", "c"}, {"a", "b", "b", "b"}, {}, {}}};
  return results;
}

// The classes have 2/4, 1/4 and 1/4 of the samples, and 1/4, 3/4 and none of the predictions.
TEST(MainResult, TheChanceIsThatOfPredictionsInRandomOrder) {
  EXPECT_DOUBLE_EQ(*accuracy_by_chance(protocol("k_folds", 0.5, 0.5)), 2.0 / 16 + 3.0 / 16);
  EXPECT_FALSE(accuracy_by_chance({}));
}

TEST(MainResult, IsTheLowestAccuracyOfSamplesThatWereHeldOut) {
  PartResults part;
  part.protocols = {protocol("train_is_test", 0.1, 1.0), protocol("k_folds", 0.9, 0.8),
                    protocol("leave_one_out", 0.7, 0.6)};
  const auto result = main_result(part);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->protocol, 2U);
  EXPECT_EQ(result->accuracy, 0.7);
  EXPECT_EQ(result->baseline, 0.6);
  EXPECT_EQ(result->deviation, 0.0);
  part.protocols.resize(1);
  EXPECT_EQ(main_result(part)->accuracy, 0.1);
  part.protocols[0].metrics.clear();
  EXPECT_FALSE(main_result(part));
}

TEST(MainResult, IsFarBelowTheBaselineByMoreThanFivePoints) {
  EXPECT_NEAR(*far_below_baseline(protocol("k_folds", 0.7, 0.76)), 0.06, 1e-12);
  EXPECT_FALSE(far_below_baseline(protocol("k_folds", 0.7, 0.74)));
  EXPECT_FALSE(far_below_baseline(protocol("train_is_test", 0.7, 1.0)));
}

TEST(MainResult, StatesTheDistanceFromTheBestNeighbour) {
  ProtocolResults one = protocol("k_folds", 0.7, 0.6);
  EXPECT_EQ(best_neighbour_sentence(one), "");
  one.metrics.push_back({"best_neighbour_accuracy", {0.764}, {}});
  EXPECT_NEAR(*above_best_neighbour(one), -0.064, 1e-12);
  EXPECT_NEAR(*far_below_baseline(one), 0.064, 1e-12);
  EXPECT_EQ(best_neighbour_sentence(one),
            "The map is 6.4 points below the best nearest neighbour, 0.764.");
  one.chosen_neighbours = {{"euclidean, raw", 2}, {"manhattan, standardized", 3}};
  EXPECT_EQ(best_neighbour_sentence(one),
            "The map is 6.4 points below the best nearest neighbour, 0.764 (manhattan, "
            "standardized in 3 of 5 folds; euclidean, raw in 2 of 5 folds).");
  one.chosen_neighbours = {{"manhattan, raw", 5}};
  one.metrics.back().values = {0.6504};
  EXPECT_EQ(best_neighbour_sentence(one),
            "The map is 5.0 points above the best nearest neighbour, 0.650 (manhattan, raw).");
  one.metrics.back().values = {0.7};
  EXPECT_EQ(best_neighbour_sentence(one),
            "The map is as accurate as the best nearest neighbour, 0.700 (manhattan, raw).");
  one.protocol = "train_is_test";
  EXPECT_EQ(best_neighbour_sentence(one), "");
}

// One winner for the classes a, b and c; then two in another run, and as many as classes.
TEST(MainResult, AMapCollapsesWithFewerWinnersThanClasses) {
  ProtocolResults results = protocol("k_folds", 0.5, 0.5);
  results.runs.push_back({2, {0, 1, 1, 0}, {"a", "a", "b", "c"}, {"a", "a", "b", "b"}, {}, {}});
  ASSERT_TRUE(collapsed_map(results));
  EXPECT_EQ(collapsed_map(results)->winners, 1U);
  EXPECT_EQ(collapsed_map(results)->classes, 3U);
  results.runs.erase(results.runs.begin());
  EXPECT_EQ(collapsed_map(results)->winners, 2U);
  results.runs.front().winners = {5, 1, 1, 9};
  EXPECT_FALSE(collapsed_map(results));
  results.runs.front().winners = {0, 0, 0, 0};
  results.metrics.clear();
  EXPECT_FALSE(collapsed_map(results));
}

TEST(MainResult, ConfusionsAreCountedOverAllRuns) {
  ProtocolResults results = protocol("k_folds", 0.5, 0.5);
  results.runs.push_back({2, {0, 0, 0, 0}, {"a", "a", "b", "c"}, {"a", "a", "b", "b"}, {}, {}});
  const auto found = confusions(results, 3);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].label, "c");
  EXPECT_EQ(found[0].predicted, "b");
  EXPECT_EQ(found[0].count, 2U);
  EXPECT_EQ(found[0].of, 2U);
  EXPECT_EQ(found[1].label, "a");
  EXPECT_EQ(found[1].count, 1U);
  EXPECT_EQ(found[1].of, 4U);
  EXPECT_EQ(confusions(results, 1).size(), 1U);
}

}  // namespace
}  // namespace somato
