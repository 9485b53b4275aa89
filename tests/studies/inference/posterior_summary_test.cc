#include "studies/inference/posterior_summary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "somato/core/check.h"

namespace somato {
namespace {

TEST(PosteriorSummary, QuantilesFollowTheWeights) {
  const std::vector<double> values{3, 1, 2};
  const std::vector<double> weights{0.5, 0.25, 0.25};
  EXPECT_EQ(weighted_quantile(values, weights, 0.05), 1.0);
  EXPECT_EQ(weighted_quantile(values, weights, 0.25), 1.0);
  EXPECT_EQ(weighted_quantile(values, weights, 0.5), 2.0);
  EXPECT_EQ(weighted_quantile(values, weights, 0.51), 3.0);
  EXPECT_EQ(weighted_quantile(values, weights, 1.0), 3.0);
  EXPECT_THROW((void)weighted_quantile({}, {}, 0.5), InvalidArgument);
}

TEST(PosteriorSummary, RanksDivideTheWeightOfEqualValues) {
  const std::vector<double> values{1, 2, 2, 4};
  const std::vector<double> weights{0.1, 0.2, 0.3, 0.4};
  EXPECT_NEAR(weighted_rank(values, weights, 2.0, 0.0), 0.1, 1e-15);
  EXPECT_NEAR(weighted_rank(values, weights, 2.0, 1.0), 0.6, 1e-15);
  EXPECT_NEAR(weighted_rank(values, weights, 3.0, 0.7), 0.6, 1e-15);
  EXPECT_EQ(weighted_rank(values, weights, 0.0, 0.5), 0.0);
}

TEST(PosteriorSummary, HasWeightedMeansDeviationsAndCorrelations) {
  Posterior posterior{
      {0, 1, 2}, {0.25, 0.5, 0.25}, Matrix<double>(3, 3, {0, 1, 0.5, 0.5, 0.5, 0.5, 1, 0, 0.5})};
  const PlaceSummary found = summary_of(posterior, 0);
  EXPECT_DOUBLE_EQ(found.mean, 0.5);
  EXPECT_DOUBLE_EQ(found.deviation, std::sqrt(0.125));
  EXPECT_EQ(found.median, 0.5);
  const Matrix<double> correlations = correlations_of(posterior);
  EXPECT_NEAR(correlations(0, 0), 1.0, 1e-15);
  EXPECT_NEAR(correlations(0, 1), -1.0, 1e-15);
  EXPECT_EQ(correlations(0, 2), 0.0) << "it does not vary";
}

}  // namespace
}  // namespace somato
