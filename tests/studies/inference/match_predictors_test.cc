#include "studies/inference/match_predictors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "somato/core/random.h"

namespace somato {
namespace {

TEST(PlacesAmongDraws, AreSharesOfSmallerValues) {
  const Matrix<double> statistics(4, 2, {1e9, -3, 1e12, -3, 2e9, -3, 1e9, -3});
  const MatchPredictors found = places_among_draws(statistics, std::vector{1.5e9, -3.0});
  EXPECT_DOUBLE_EQ(found.of_draws(0, 0), 0.25) << "half of two equal ones";
  EXPECT_DOUBLE_EQ(found.of_draws(3, 0), 0.25);
  EXPECT_DOUBLE_EQ(found.of_draws(2, 0), 0.625);
  EXPECT_DOUBLE_EQ(found.of_draws(1, 0), 0.875);
  EXPECT_DOUBLE_EQ(found.observed[0], 0.4375) << "in the middle of 0.25 and 0.625";
  EXPECT_DOUBLE_EQ(found.of_draws(1, 1), 0.5);
  EXPECT_DOUBLE_EQ(found.observed[1], 0.5);
}

TEST(PlacesAmongDraws, OfObservedValuesDoNotLeaveTheDraws) {
  const Matrix<double> statistics(2, 2, {0, 5, 1, 5});
  const MatchPredictors found = places_among_draws(statistics, std::vector{-1e300, 7.0});
  EXPECT_DOUBLE_EQ(found.observed[0], 0.25);
  EXPECT_DOUBLE_EQ(found.observed[1], 0.5);
}

// A statistic that depends on the place, one that does not, one that only depends on the group, and
// a constant one.
TEST(ExplainedShares, AreThoseOfLeftOutGroups) {
  Random random(3);
  constexpr std::size_t kDraws = 80;
  Matrix<double> places(kDraws, 1);
  Matrix<double> predictors(kDraws, 4, 1.0);
  std::vector<std::size_t> groups;
  for (std::size_t i = 0; i < kDraws; ++i) {
    groups.push_back(i * 4 / kDraws);
    places(i, 0) = random.uniform();
    predictors(i, 0) = 3.0 * places(i, 0);
    predictors(i, 1) = random.normal();
    predictors(i, 2) = static_cast<double>(groups.back());
  }
  const std::vector<double> shares = explained_shares(predictors, places, groups);
  EXPECT_GT(shares[0], 0.99);
  EXPECT_LT(shares[1], 0.1);
  EXPECT_LT(shares[2], 0.1);
  EXPECT_EQ(shares[3], 0.0);
}

// The posterior of a normal linear model with a wide prior: the mean of four measurements with
// the noise 0.2 has the standard deviation 0.1 around the place.
TEST(PredictedPlaces, HaveTheErrorOfALinearModel) {
  Random random(4);
  Matrix<double> places(400, 2);
  MatchPredictors predictors{Matrix<double>(400, 4), {0.4, 0.4, 0.4, 0.4}};
  for (std::size_t i = 0; i < 400; ++i) {
    places(i, 0) = random.uniform();
    places(i, 1) = random.uniform();
    for (std::size_t c = 0; c < 4; ++c)
      predictors.of_draws(i, c) = places(i, 0) + 0.2 * random.normal();
  }
  const auto found = predicted_places(predictors, places, {});
  // The linear prediction with the least error shrinks to the mean: by 1/12 / (1/12 + 0.01).
  const double kept = (1.0 / 12.0) / (1.0 / 12.0 + 0.01);
  EXPECT_NEAR(found[0].of_given, 0.5 - 0.1 * kept, 0.01);
  EXPECT_NEAR(found[0].error, 0.1 * std::sqrt(kept), 0.01);
  // Nothing predicts the second place.
  EXPECT_NEAR(found[1].error, std::sqrt(1.0 / 12.0), 0.015);
  EXPECT_NEAR(found[1].of_given, 0.5, 0.05);
}

TEST(PredictedPlaces, AreMeansWithoutPredictors) {
  const MatchPredictors nothing{Matrix<double>(4, 0), {}};
  const Matrix<double> places(4, 1, {0.0, 0.2, 0.4, 1.0});
  const RidgePrediction found = predicted_places(nothing, places, {})[0];
  EXPECT_DOUBLE_EQ(found.of_given, 0.4);
  for (const double place : found.of_rows) EXPECT_DOUBLE_EQ(place, 0.4);
  EXPECT_FALSE(is_outside(found));
}

TEST(PredictedPlaces, AreOutsideBeyondAllDrawsByMoreThanTheError) {
  RidgePrediction prediction{{0.2, 0.7}, 0.75, 0.1, 1.0};
  EXPECT_FALSE(is_outside(prediction));
  prediction.of_given = 0.81;
  EXPECT_TRUE(is_outside(prediction));
  prediction.of_given = 0.09;
  EXPECT_TRUE(is_outside(prediction));
}

}  // namespace
}  // namespace somato
