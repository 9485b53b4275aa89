#include "somato/maps/novelty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Values = std::vector<double>;

// The mean is 3: class 0 has (1 + 3 + 3) / 3, class 1 (3 + 5 + 3) / 3, class 2 the mean only.
TEST(Novelty, ScalesAreMeansWithOneMoreSample) {
  const auto scales = class_scales({0, 1, 0, 1}, {1.0, 3.0, 3.0, 5.0}, 3);
  ASSERT_TRUE(scales);
  EXPECT_EQ(*scales, (Values{7.0 / 3.0, 11.0 / 3.0, 3.0}));
}

// The distance of a class with one sample is that from other classes. The mean of the others is 2.
TEST(Novelty, ScalesLeaveOutTheOnlySampleOfAClass) {
  EXPECT_EQ(class_scales({0, 1, 0}, {1.0, 50.0, 3.0}, 3).value(), (Values{2.0, 2.0, 2.0}));
  const auto singles = class_scales({0, 1}, {1.0, 2.0}, 2);
  ASSERT_FALSE(singles);
  EXPECT_EQ(singles.error().kind, ErrorKind::kData);
  EXPECT_NE(singles.error().what.find("no class has two"), std::string::npos);
}

TEST(Novelty, ScalesNeedADistance) {
  EXPECT_EQ(class_scales({0, 0}, {0.0, 0.0}, 2).error().kind, ErrorKind::kData);
  EXPECT_THROW((void)class_scales({}, {}, 1), InvalidArgument);
  EXPECT_THROW((void)class_scales({0}, {1.0, 2.0}, 1), InvalidArgument);
  EXPECT_THROW((void)class_scales({0, 1}, {1.0, 1.0}, 1), InvalidArgument);
}

TEST(Novelty, IsOneAtTheThreshold) {
  const Novelty novelty{0.05, 20, 1.5, {2.0, 4.0}};
  EXPECT_EQ(novelty.of(0, 3.0), 1.0);
  EXPECT_EQ(novelty.of(1, 3.0), 0.5);
  EXPECT_FALSE(is_unknown(1.0));
  EXPECT_TRUE(is_unknown(novelty.of(0, 3.01)));
}

TEST(Novelty, LaterClassesHaveTheMeanScale) {
  Novelty novelty{0.05, 20, 1.5, {2.0, 4.0}};
  novelty.add_classes(4);
  EXPECT_EQ(novelty.scales, (Values{2.0, 4.0, 3.0, 3.0}));
  novelty.add_classes(2);
  EXPECT_EQ(novelty.scales.size(), 4U);
  EXPECT_THROW(Novelty{}.add_classes(1), InvalidArgument);
}

// Of 19 scores the greatest, of 20 still the greatest, of 39 the second greatest.
TEST(Novelty, ThresholdHasTheRankOfConformalPrediction) {
  for (const auto& [count, expected] : {std::pair{19, 19.0}, {20, 20.0}, {38, 38.0}, {39, 38.0}}) {
    Values scores;
    for (int i = count; i > 0; --i) scores.push_back(i);
    EXPECT_EQ(conformal_threshold(scores, 0.05).value(), expected) << count;
  }
}

TEST(Novelty, ThresholdNeedsEnoughScores) {
  const auto few = conformal_threshold(Values(18, 1.0), 0.05);
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error().kind, ErrorKind::kData);
  EXPECT_NE(few.error().advice.find("at least 19 explorations"), std::string::npos);
  EXPECT_FALSE(check_scores(1, 0.5));
  EXPECT_TRUE(check_scores(2, 0.5));
  EXPECT_EQ(conformal_threshold(Values(30, 0.0), 0.05).error().kind, ErrorKind::kData);
  EXPECT_THROW((void)conformal_threshold({1.0}, 0.0), InvalidArgument);
  EXPECT_THROW((void)conformal_threshold({1.0}, 1.0), InvalidArgument);
}

// Quantiles of beta distributions of SciPy 1.17, scipy.stats.beta.ppf([0.025, 0.975], a, n + 1 -
// a), and, for a = 1, 1 - (1 - p)^(1 / n).
TEST(Novelty, TheIntervalOfAThresholdHasTheQuantilesOfABetaDistribution) {
  const FalseAlarmInterval of_19 = false_alarm_interval(19, 0.05);
  EXPECT_NEAR(of_19.low, 1.0 - std::pow(0.975, 1.0 / 19.0), 1e-12);
  EXPECT_NEAR(of_19.high, 1.0 - std::pow(0.025, 1.0 / 19.0), 1e-12);
  const FalseAlarmInterval of_100 = false_alarm_interval(100, 0.05);
  EXPECT_NEAR(of_100.low, 0.016431879182052155, 1e-9);
  EXPECT_NEAR(of_100.high, 0.09925715671265992, 1e-9);
  const FalseAlarmInterval of_5000 = false_alarm_interval(5000, 0.3);
  EXPECT_NEAR(of_5000.low, 0.28731774301219815, 1e-9);
  EXPECT_NEAR(of_5000.high, 0.31271384070766217, 1e-9);
  EXPECT_THROW((void)false_alarm_interval(18, 0.05), InvalidArgument);
}

// Over 2000 drawings of 25 scores, a further one is above the threshold in at most that share.
TEST(Novelty, ThresholdIsExceededAtMostAtTheRate) {
  for (const double rate : {0.05, 0.1, 0.3}) {
    Random random(7);
    double above = 0.0;
    constexpr int kDrawings = 2000;
    for (int drawing = 0; drawing < kDrawings; ++drawing) {
      Values scores(25);
      for (double& score : scores) score = 0.01 + random.uniform();
      above += 0.01 + random.uniform() > conformal_threshold(scores, rate).value() ? 1.0 : 0.0;
    }
    EXPECT_LE(above / kDrawings, rate + 0.015);  // two and a half deviations of the mean at 0.1
    EXPECT_GE(above / kDrawings, rate - 1.0 / 26.0 - 0.02);
  }
}

}  // namespace
}  // namespace somato
