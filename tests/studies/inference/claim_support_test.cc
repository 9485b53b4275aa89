#include "studies/inference/claim_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "studies/inference/inference.h"
#include "studies/inference/inferences.h"

namespace somato {
namespace {

using test::kTarget;
using test::rates_as_accuracies;
using test::targets_of;

// The accuracy is the rate, evenly distributed from 0.1 to 0.9; the first claim is that it is at
// least 0.5.
TEST(ClaimSupport, ComparesThePriorWithThePosterior) {
  std::string text = "[inference]\naccepted = 0.1\n" + kTarget;
  text.replace(text.find("0.5"), 3, "0.8");
  const Targets targets = targets_of(text).value();
  const SweepResults results = rates_as_accuracies(128, targets);
  const Inference found = infer(results, targets).value();
  const ClaimShares shares =
      shares_of(results, 0, found.simulations, found.posterior, targets, {results.sweep, {}});
  EXPECT_NEAR(*shares.prior, 0.5, 0.02);
  EXPECT_EQ(*shares.posterior, 1.0);
  ASSERT_TRUE(shares.values);
  EXPECT_NEAR(shares.values->least, 0.1, 0.05);
  EXPECT_NEAR(shares.values->median, 0.5, 0.05);
  EXPECT_NEAR(shares.values->greatest, 0.9, 0.05);
  EXPECT_FALSE(shares.left_out) << "without its own target there is none";
  EXPECT_FALSE(shares.fresh);
  EXPECT_EQ(shares.draws, 128U);
  EXPECT_EQ(shares.support(), ClaimSupport::kReachable) << "explained only on fresh seeds";
  const ClaimShares fresh =
      shares_of(results, 0, found.simulations, found.posterior, targets, results);
  EXPECT_NEAR(*fresh.fresh, 0.5, 0.02);
}

TEST(ClaimSupport, AClaimIsPredictedFromTheOtherTargets) {
  const Targets targets = targets_of("[inference]\naccepted = 0.1\n" + kTarget +
                                     "[[target]]\ntext = 'Small.'\nsystem = 'press'\nvariation = "
                                     "'small'\nmetric = 'accuracy'\n"
                                     "observed = 0\nscale = 1\n")
                              .value();
  const SweepResults results = rates_as_accuracies(128, targets);
  const Inference found = infer(results, targets).value();
  const ClaimShares shares =
      shares_of(results, 0, found.simulations, found.posterior, targets, {results.sweep, {}});
  // The other target is always met, so that all simulations are as near as each other: the prior.
  EXPECT_NEAR(*shares.left_out, *shares.prior, 1e-9);
}

TEST(ClaimSupport, IsExcludedOnlyByManyDraws) {
  ClaimShares shares;
  EXPECT_EQ(shares.support(), ClaimSupport::kNotDecided);
  shares.prior = 0.009;
  shares.draws = 999;
  EXPECT_EQ(shares.support(), ClaimSupport::kNotDecided);
  shares.draws = 1000;
  EXPECT_EQ(shares.support(), ClaimSupport::kExcluded);
  shares.prior = 0.01;
  EXPECT_EQ(shares.support(), ClaimSupport::kReachable);
  shares.fresh = 0.9;
  shares.fresh_pairs = kLeastPairs - 1;
  EXPECT_EQ(shares.support(), ClaimSupport::kReachable) << "too few pairs";
  shares.fresh_pairs = kLeastPairs;
  EXPECT_EQ(shares.support(), ClaimSupport::kExplained);
  shares.fresh = 0.89;
  EXPECT_EQ(shares.support(), ClaimSupport::kReachable);
  shares.prior = 0.001;
  EXPECT_EQ(shares.support(), ClaimSupport::kReachable) << "the posterior gives it";
  shares.fresh = 0.0;
  EXPECT_EQ(shares.support(), ClaimSupport::kExcluded);
}

TEST(ClaimSupport, ChanceExplainsWhatItReachesAsOften) {
  ClaimShares shares;
  shares.prior = 1.0;
  shares.fresh = 1.0;
  shares.fresh_pairs = kLeastPairs;
  shares.fresh_chance = 0.89;
  EXPECT_EQ(shares.support(), ClaimSupport::kExplained);
  shares.fresh_chance = 0.9;
  EXPECT_EQ(shares.support(), ClaimSupport::kReachable);
  shares.fresh_chance = 0.0;
  shares.chance = 1.0;
  EXPECT_EQ(shares.support(), ClaimSupport::kExplained) << "the chance of the fresh maps counts";
}

TEST(ClaimSupport, TheChanceOfFreshMapsIsThatOfTheirGroupings) {
  const Targets targets = targets_of(kTarget).value();
  const SweepResults results = rates_as_accuracies(128, targets);
  const Inference found = infer(results, targets).value();
  SweepResults fresh = results;
  for (std::size_t i = 0; i < 128; ++i) {
    fresh.points[i].claims[0]->chance_share = i < 32 ? 0.5 : 1.0;
  }
  const ClaimShares shares =
      shares_of(results, 0, found.simulations, found.posterior, targets, fresh);
  EXPECT_FALSE(shares.chance);
  ASSERT_TRUE(shares.fresh_chance);
  EXPECT_NEAR(*shares.fresh_chance, 0.875, 1e-12);
}

TEST(ClaimSupport, FindsClaimsThatExcludeEachOther) {
  constexpr double kUnjudgedClaim = std::numeric_limits<double>::quiet_NaN();
  MetClaims first;
  MetClaims second;
  MetClaims third;
  for (int i = 0; i < 100; ++i) {
    first.push_back(i < 50 ? 1.0 : 0.0);
    second.push_back(i >= 50 ? 1.0 : 0.0);
    third.push_back(i % 2 == 0 ? 1.0 : 0.0);
  }
  first.push_back(kUnjudgedClaim);
  second.push_back(1.0);
  third.push_back(1.0);
  const auto conflicts = conflicts_of({first, second, third}, 1.0, 5.0);
  ASSERT_EQ(conflicts.size(), 1U);
  EXPECT_EQ(conflicts[0].first, 0U);
  EXPECT_EQ(conflicts[0].second, 1U);
  EXPECT_EQ(conflicts[0].together, 0.0);
  EXPECT_EQ(conflicts[0].expected, 25.0);
  // The variance of the hypergeometric distribution, 100 with 50 and 50.
  EXPECT_NEAR(conflicts[0].deviations, -25.0 / std::sqrt(25.0 * 50 * 50 / (100.0 * 99)), 1e-12);
  // Four simulations of each draw have the variance of a quarter as many.
  EXPECT_NEAR(conflicts_of({first, second, third}, 4.0, 5.0)[0].deviations,
              conflicts[0].deviations / 2.0, 1e-12);
  EXPECT_TRUE(conflicts_of({first, second}, 1.0, 26.0).empty());
  EXPECT_TRUE(conflicts_of({MetClaims{1.0}, MetClaims{0.0}}, 1.0, 0.0).empty());
}

TEST(ClaimSupport, SumsTheSharesOfEachBody) {
  SweepResults results = rates_as_accuracies(8, targets_of(kTarget).value(), 0.0);
  results.points[0].claims[0]->values = {0.0, 1.0};
  const auto sums = claims_met(results);
  ASSERT_EQ(sums.size(), 8U);
  EXPECT_DOUBLE_EQ(sums[0], 0.5 + 1.0) << "the small map is always worse";
  for (std::size_t i = 1; i < 8; ++i) {
    const double accuracy = results.points[i].claims[0]->values[0];
    EXPECT_DOUBLE_EQ(sums[i], (accuracy >= 0.5 ? 1.0 : 0.0) + 1.0);
  }
}

TEST(ClaimSupport, PoolsThePairsOfAllBodies) {
  const SweepResults results = rates_as_accuracies(16, targets_of(kTarget).value(), 0.0);
  const auto all = pooled_outcome(results, 0);
  ASSERT_TRUE(all);
  ASSERT_EQ(all->values.size(), 32U);
  EXPECT_EQ(all->values[6], results.points[3].claims[0]->values[0]);
  EXPECT_EQ(all->verdict(), ClaimVerdict::kMostly) << "half of the rates are at least 0.5";
  EXPECT_FALSE(pooled_outcome({results.sweep, {}}, 0));
  const NotFailing counts = not_failing(results);
  EXPECT_EQ(counts.first, 2U);
  EXPECT_EQ(counts.as_written, 2U);
}

// The two sides of a comparison are of the same target.
TEST(ClaimSupport, BothSidesOfAComparisonAreAboutATarget) {
  const Target target = targets_of(kTarget).value().targets[0];
  Claim claim;
  claim.system = "other";
  claim.metric = "accuracy";
  EXPECT_FALSE(is_about(claim, target));
  claim.than_system = "press";
  EXPECT_TRUE(is_about(claim, target));
  claim.than_metric = "baseline_accuracy";
  EXPECT_FALSE(is_about(claim, target));
}

}  // namespace
}  // namespace somato
