#include "base/core/rank_correlation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "somato/core/check.h"

namespace somato {
namespace {

using Values = std::vector<double>;

TEST(Ranks, CountFromOneAndShareTies) {
  EXPECT_EQ(ranks_of({30, 10, 20}), (Values{3, 1, 2}));
  EXPECT_EQ(ranks_of({5, 1, 5, 9, 5}), (Values{3, 1, 3, 5, 3}));
  EXPECT_EQ(ranks_of({4, 4}), (Values{1.5, 1.5}));
}

TEST(RankCorrelation, DependsOnlyOnOrder) {
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3, 4}, {1, 10, 100, 1000}), 1.0);
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3, 4}, {0, -1, -2, -30}), -1.0);
}

// 1 - 6 sum d^2 / (n (n^2 - 1)), d = 1, -1, 0, 1, -1: 1 - 24 / 120.
TEST(RankCorrelation, IsSpearmans) {
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3, 4, 5}, {2, 1, 3, 5, 4}), 0.8);
}

// Ranks 1.5, 1.5, 3 and 1, 2, 3, less 2: products 0.5, 0, 1; squares 1.5 and 2.
TEST(RankCorrelation, SharesTies) {
  EXPECT_DOUBLE_EQ(rank_correlation({7, 7, 8}, {1, 2, 3}), 1.5 / std::sqrt(3.0));
}

TEST(RankCorrelation, IsNoneWhereNothingDiffers) {
  EXPECT_EQ(rank_correlation({4, 4, 4}, {1, 2, 3}), 0.0);
  EXPECT_EQ(rank_correlation({1, 2, 3}, {0, 0, 0}), 0.0);
  EXPECT_THROW((void)rank_correlation({1, 2}, {1}), InvalidArgument);
}

TEST(CentredRanks, SumToNone) {
  EXPECT_EQ(centred_ranks({30, 10, 20}), (Values{1, -1, 0}));
  EXPECT_EQ(centred_ranks({5, 1, 5, 9}), (Values{0, -1.5, 0, 1.5}));
}

TEST(CentredRanks, GiveTheSameCorrelation) {
  EXPECT_DOUBLE_EQ(correlation_of_centred_ranks({-2, -1, 0, 1, 2}, {-1, -2, 0, 2, 1}), 0.8);
  EXPECT_EQ(correlation_of_centred_ranks({0, 0}, {-0.5, 0.5}), 0.0);
  EXPECT_THROW((void)correlation_of_centred_ranks({0.5, -0.5}, {0}), InvalidArgument);
}

}  // namespace
}  // namespace somato
