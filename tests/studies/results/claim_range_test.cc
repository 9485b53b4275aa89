#include "studies/results/claim_range.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Values = std::vector<double>;

Values counted_to(std::size_t count) {
  Values values;
  for (std::size_t i = count; i > 0; --i) values.push_back(static_cast<double>(i));
  return values;
}

// A twentieth of the values at either end, rounded down.
TEST(CentralRange, LeavesOutATwentiethAtEitherEnd) {
  EXPECT_EQ(central_range(counted_to(100)), (ClaimRange{6, 95}));
  EXPECT_EQ(central_range(counted_to(20)), (ClaimRange{2, 19}));
  EXPECT_EQ(central_range(counted_to(39)), (ClaimRange{2, 38}));
  EXPECT_EQ(central_range(counted_to(19)), (ClaimRange{1, 19}));
  EXPECT_EQ(central_range(counted_to(1)), (ClaimRange{1, 1}));
}

TEST(CentralRange, CountsEqualValues) {
  EXPECT_EQ(central_range(Distribution{{0.0, 96}, {1.0, 4}}), (ClaimRange{0, 0}));
  EXPECT_EQ(central_range(Distribution{{0.0, 94}, {1.0, 6}}), (ClaimRange{0, 1}));
  EXPECT_EQ(central_range(Distribution{{-2.0, 3}, {0.0, 3}, {5.0, 94}}), (ClaimRange{0, 5}));
}

TEST(CentralRange, IsNoneWithoutValuesOrWithMissingOnes) {
  EXPECT_FALSE(central_range(Values{}));
  EXPECT_FALSE(central_range(Distribution{}));
  EXPECT_FALSE(central_range(Values{1.0, std::nan("")}));
  EXPECT_FALSE(central_range(Values{1.0, std::numeric_limits<double>::infinity()}));
}

// Means 2 and 4: the deviation is sqrt(2), the error 1, and the quantile of one degree of freedom
// 12.706. The number of values of a recording does not matter.
TEST(IntervalOfMean, IsThatOfTheMeansOfTheRecordings) {
  const auto interval = interval_of_mean({1, 3, 4, 4, 4}, {7, 7, 2, 2, 2});
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->low, 3.0 - 12.7062, 1e-4);
  EXPECT_NEAR(interval->high, 3.0 + 12.7062, 1e-4);
  EXPECT_EQ(interval_of_mean({5, 5, 5}, {0, 1, 2}), (ClaimRange{5, 5}));
}

// The same two means; one recording has a mean as well.
TEST(MeanOfRecordings, CountsEachRecordingOnce) {
  EXPECT_EQ(mean_of_recordings({1, 3, 4, 4, 4}, {7, 7, 2, 2, 2}), 3.0);
  EXPECT_EQ(mean_of_recordings({1, 2, 6}, {4, 4, 4}), 3.0);
  EXPECT_FALSE(mean_of_recordings({}, {}));
  EXPECT_FALSE(mean_of_recordings({1, std::nan("")}, {0, 1}));
  EXPECT_FALSE(mean_of_recordings({1, 2}, {0}));
}

TEST(IntervalOfMean, NeedsTwoRecordingsAndAllValues) {
  EXPECT_FALSE(interval_of_mean({}, {}));
  EXPECT_FALSE(interval_of_mean({1, 2, 3}, {4, 4, 4}));
  EXPECT_FALSE(interval_of_mean({1, std::nan("")}, {0, 1}));
  EXPECT_FALSE(interval_of_mean({1, 2}, {0}));
}

// From printed tables of Student's t.
TEST(TQuantile, IsThatOfTables) {
  EXPECT_NEAR(t_quantile(1), 12.706, 0.0005);
  EXPECT_NEAR(t_quantile(5), 2.571, 0.0005);
  EXPECT_NEAR(t_quantile(30), 2.042, 0.0005);
  EXPECT_NEAR(t_quantile(40), 2.021, 0.0005);
  EXPECT_NEAR(t_quantile(60), 2.000, 0.0005);
  EXPECT_NEAR(t_quantile(120), 1.980, 0.0005);
  EXPECT_NEAR(t_quantile(1000000), 1.960, 0.0005);
  EXPECT_THROW((void)t_quantile(0), InvalidArgument);
}

// The table continues in the expansion.
TEST(TQuantile, FallsSteadily) {
  for (std::size_t degrees = 1; degrees < 60; ++degrees) {
    EXPECT_LT(t_quantile(degrees + 1), t_quantile(degrees)) << degrees;
  }
  EXPECT_NEAR(t_quantile(31), 2.03951, 1e-5);
}

// Six recordings with a common part of their pairs: the interval holds 0 in 95 % of 2000 studies
// (0.005 is the standard deviation of this share); over all pairs as if independent it would not.
TEST(IntervalOfMean, CoversTheMeanOfNormalDraws) {
  Random random(11, Stream::kGroupings);
  std::size_t covered = 0;
  constexpr std::size_t kStudies = 2000;
  for (std::size_t study = 0; study < kStudies; ++study) {
    Values values;
    std::vector<std::size_t> recordings;
    for (std::size_t recording = 0; recording < 6; ++recording) {
      const double common = random.normal();
      for (std::size_t pair = 0; pair < 4; ++pair) {
        values.push_back(common + 0.5 * random.normal());
        recordings.push_back(recording);
      }
    }
    covered += interval_of_mean(values, recordings).value().contains(0.0) ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(covered) / kStudies, 0.95, 0.02);
}

}  // namespace
}  // namespace somato
