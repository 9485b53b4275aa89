#include "studies/inference/acceptance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "somato/core/check.h"
#include "studies/inference/posterior_summary.h"
#include "studies/inference/simulated.h"

namespace somato {
namespace {

constexpr double kNoStatistic = std::numeric_limits<double>::quiet_NaN();

// One unknown, one statistic, each simulation a draw.
Simulations line_of(const std::vector<double>& statistics) {
  Simulations all{Matrix<double>(statistics.size(), 1),
                  Matrix<double>(statistics.size(), 1, statistics),
                  {},
                  {true},
                  {}};
  for (std::size_t i = 0; i < statistics.size(); ++i) {
    all.places(i, 0) = (static_cast<double>(i) + 0.5) / static_cast<double>(statistics.size());
    all.draw.push_back(i);
  }
  return all;
}

TEST(Acceptance, DividesDifferencesByTheirScales) {
  const Observation observed{{1.0, 10.0}, {1.0, 5.0}};
  EXPECT_DOUBLE_EQ(distance_of(std::vector<double>{4.0, 30.0}, observed),
                   std::sqrt((9.0 + 16.0) / 2.0));
  EXPECT_EQ(distance_of(std::vector<double>{kNoStatistic, 10.0}, observed),
            std::numeric_limits<double>::infinity());
}

TEST(Acceptance, TakesTheNearestWithEpanechnikovWeights) {
  const auto posterior = accept_nearest(line_of({5, 1, 0, 4, 2, kNoStatistic, 3, 9, 9, 9}),
                                        {{0.0}, {2.0}}, {0.3, false});
  ASSERT_TRUE(posterior);
  EXPECT_EQ(posterior->simulations, (std::vector<std::size_t>{1, 2, 4}));
  // Distances 0.5, 0, 1 of 1.5, that of the fourth one.
  const double sum = (1 - 1.0 / 9) + 1 + (1 - 4.0 / 9);
  EXPECT_NEAR(posterior->weights[0], (1 - 1.0 / 9) / sum, 1e-15);
  EXPECT_NEAR(posterior->weights[1], 1 / sum, 1e-15);
  EXPECT_NEAR(posterior->weights[2], (1 - 4.0 / 9) / sum, 1e-15);
  EXPECT_DOUBLE_EQ(posterior->places(2, 0), 0.45);
}

TEST(Acceptance, TakesAllAtTheSameDistance) {
  const auto posterior =
      accept_nearest(line_of({1, -1, 1, 2, 2, 5, 5, 5, 5, 5}), {{0.0}, {1.0}}, {0.1, true});
  EXPECT_EQ(posterior->simulations, (std::vector<std::size_t>{0, 1, 2}));
  for (const double weight : posterior->weights) EXPECT_NEAR(weight, 1.0 / 3, 1e-15);
  const auto all = accept_nearest(line_of({7, 7, 7}), {{0.0}, {1.0}}, {1.0, true});
  EXPECT_EQ(all->size(), 3U);
  EXPECT_NEAR(all->places(0, 0), 0.5 / 3, 1e-12) << "a constant statistic adjusts nothing";
}

// Places differ from their predictions by 0.1, -0.1, 0.1 and 0.35; adjusted ones differ likewise
// from the observed prediction, 0.8, and stay in the prior.
TEST(Acceptance, PredictionsAdjustByTheirDifferences) {
  Simulations all = line_of({0.0, 0.35, 0.5, 0.6});
  all.places = Matrix<double>(4, 1, {0.1, 0.25, 0.6, 0.95});
  const AcceptanceRule rule{1.0, true, true};
  const auto found = accept_nearest(all, {{0.8}, {0.1}}, rule);
  ASSERT_EQ(found->size(), 4U);
  EXPECT_TRUE(found->is_adjusted) << "few simulations are sufficient";
  EXPECT_NEAR(found->places(0, 0), 0.9, 1e-12);
  EXPECT_NEAR(found->places(1, 0), 0.7, 1e-12);
  EXPECT_NEAR(found->places(2, 0), 0.9, 1e-12);
  EXPECT_EQ(found->places(3, 0), 1.0);
  EXPECT_EQ(accept_nearest(all, {{0.8}, {0.1}}, {1.0, false, true})->places(0, 0), 0.1);
  all.is_continuous = {false};
  EXPECT_EQ(accept_nearest(all, {{0.8}, {0.1}}, rule)->places(0, 0), 0.1);
  all.statistics = Matrix<double>(4, 2);
  EXPECT_THROW((void)accept_nearest(all, {{0.8, 0.8}, {0.1, 0.1}}, rule), InvalidArgument);
}

TEST(Acceptance, AGroupIsLeftOutTogether) {
  Simulations all = line_of({0, 1, 2, 3});
  all.group = {7, 7, 8, 8};
  const auto posterior = accept_nearest(all, {{0.0}, {1.0}}, {0.5, false}, 7);
  EXPECT_EQ(posterior->simulations, std::vector<std::size_t>{2}) << "half of the other two";
  all.group = {7};
  EXPECT_THROW((void)accept_nearest(all, {{0.0}, {1.0}}, {0.5, false}), InvalidArgument);
}

TEST(Acceptance, FewSimulationsAreNotAdjusted) {
  const Simulations all = test::of_normal_mean(100, 1, 9);
  const auto nine = accept_nearest(all, {{0.0}, {1.0}}, {0.09, true});
  EXPECT_FALSE(nine->is_adjusted);
  for (std::size_t i = 0; i < nine->size(); ++i) {
    EXPECT_EQ(nine->places(i, 0), all.places(nine->simulations[i], 0));
  }
  EXPECT_TRUE(accept_nearest(all, {{0.0}, {1.0}}, {0.1, true})->is_adjusted);
  EXPECT_FALSE(accept_nearest(all, {{0.0}, {1.0}}, {0.1, false})->is_adjusted);
}

TEST(Acceptance, LeavesADrawOut) {
  const auto posterior = accept_nearest(line_of({0, 1, 2}), {{0.0}, {1.0}}, {0.1, false}, 0);
  EXPECT_EQ(posterior->simulations, (std::vector<std::size_t>{1}));
  EXPECT_FALSE(accept_nearest(line_of({kNoStatistic, 1}), {{0.0}, {1.0}}, {0.5, false}, 1));
  EXPECT_FALSE(accept_nearest(line_of({}), {{0.0}, {1.0}}, {0.5, false}));
}

TEST(Acceptance, FindsTheClosedFormOfANormalMean) {
  const Simulations all = test::of_normal_mean(8000, 1, 7);
  for (const double mean : {-1.5, 0.0, 2.0}) {
    const auto posterior = accept_nearest(all, {{mean}, {1.0}}, {0.05, true});
    const PlaceSummary found = summary_of(*posterior, 0);
    // 400 accepted: the error of the mean is 0.5 / sqrt(330) = 0.028; places are a tenth of a unit.
    EXPECT_NEAR(found.mean * 10 - 5, mean, 0.1) << mean;
    EXPECT_NEAR(found.deviation * 10, 0.5, 0.07) << mean;
    EXPECT_NEAR((found.high - found.low) * 10, 2 * 1.645 * 0.5, 0.25) << mean;
    const PlaceSummary other = summary_of(*posterior, 1);
    EXPECT_NEAR(other.mean, 0.5, 0.06);
    EXPECT_NEAR(other.deviation, std::sqrt(1.0 / 12), 0.04) << "nothing is learned about it";
  }
}

// With a wide acceptance only the adjustment recovers the deviation.
TEST(Acceptance, AdjustmentCorrectsAWideAcceptance) {
  const Simulations all = test::of_normal_mean(4000, 1, 8);
  const double plain =
      summary_of(*accept_nearest(all, {{0.5}, {1.0}}, {0.3, false}), 0).deviation * 10;
  const double adjusted =
      summary_of(*accept_nearest(all, {{0.5}, {1.0}}, {0.3, true}), 0).deviation * 10;
  EXPECT_GT(plain, 0.7);
  EXPECT_NEAR(adjusted, 0.5, 0.06);
}

TEST(Acceptance, AdjustsOnlyContinuousUnknowns) {
  Simulations all = test::of_normal_mean(400, 1, 9);
  all.is_continuous = {false, true};
  const auto posterior = accept_nearest(all, {{0.0}, {1.0}}, {0.2, true});
  for (std::size_t i = 0; i < posterior->size(); ++i) {
    EXPECT_EQ(posterior->places(i, 0), all.places(posterior->simulations[i], 0));
    EXPECT_GT(posterior->places(i, 1), 0.0);
    EXPECT_LT(posterior->places(i, 1), 1.0);
  }
}

TEST(Acceptance, RefusesSizesAndRulesThatDoNotAgree) {
  const Simulations all = line_of({0, 1});
  EXPECT_THROW((void)accept_nearest(all, {{0.0, 1.0}, {1.0, 1.0}}, {}), InvalidArgument);
  EXPECT_THROW((void)accept_nearest(all, {{0.0}, {0.0}}, {}), InvalidArgument);
  EXPECT_THROW((void)accept_nearest(all, {{0.0}, {1.0}}, {0.0, true}), InvalidArgument);
  EXPECT_THROW((void)accept_nearest(all, {{0.0}, {1.0}}, {1.5, true}), InvalidArgument);
}

}  // namespace
}  // namespace somato
