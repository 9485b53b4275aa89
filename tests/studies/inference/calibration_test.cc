#include "studies/inference/calibration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/inference/simulated.h"

namespace somato {
namespace {

TEST(Calibration, RanksAreUniformWhereTheModelIsRight) {
  const Simulations all = test::of_normal_mean(600, 2, 21);
  const Calibration found = calibrate(all, {1.0}, {0.05, true}, 100, 5);
  ASSERT_EQ(found.ranks.rows(), 100U);
  for (std::size_t unknown = 0; unknown < 2; ++unknown) {
    EXPECT_GT(found.uniform_p[unknown], 0.01) << unknown;
    EXPECT_NEAR(found.covered[unknown], 0.9, 0.08) << unknown;
  }
}

// The places are a concave function of the statistic, so that an observation in the middle of the
// accepted ones lies above their line.
TEST(Calibration, FindsAnAdjustmentThatIsWrong) {
  Simulations all = test::of_normal_mean(300, 1, 22);
  for (std::size_t i = 0; i < all.draw.size(); ++i)
    all.statistics(i, 0) = std::exp(6.0 * all.places(i, 0));
  EXPECT_LT(calibrate(all, {1.0}, {0.5, true}, 300, 5).uniform_p[0], 0.001);
}

TEST(Calibration, UsesOneSimulationOfADrawAndNotTheOthersOfIt) {
  // Two draws with the same statistics: only the other one can be accepted.
  Simulations all{Matrix<double>(4, 1, {0.25, 0.25, 0.75, 0.75}),
                  Matrix<double>(4, 1, {1, 1, 1, 1}),
                  {0, 0, 1, 1},
                  {true},
                  {}};
  const Calibration found = calibrate(all, {1.0}, {1.0, false}, 10, 1);
  ASSERT_EQ(found.ranks.rows(), 2U);
  EXPECT_DOUBLE_EQ(found.ranks(0, 0) + found.ranks(1, 0), 1.0);
  EXPECT_EQ(std::abs(found.ranks(0, 0) - found.ranks(1, 0)), 1.0);
  EXPECT_DOUBLE_EQ(found.errors[0], 0.5) << "0.25 for 0.75, and the opposite";
  all.statistics(0, 0) = std::numeric_limits<double>::quiet_NaN();
  all.statistics(1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(calibrate(all, {1.0}, {1.0, false}, 10, 1).ranks.rows(), 0U);
}

// Critical values of the Kolmogorov-Smirnov statistic at 5 %: 0.29408 for 20, 0.1340 for 100
// numbers (tables of L. H. Miller, J. Am. Stat. Assoc. 51, 1956).
TEST(Calibration, ProbabilitiesAgreeWithTables) {
  EXPECT_NEAR(kolmogorov_p(0.29408, 20), 0.05, 0.002);
  EXPECT_NEAR(kolmogorov_p(0.1340, 100), 0.05, 0.002);
  EXPECT_EQ(kolmogorov_p(0.01, 100), 1.0);
  EXPECT_LT(kolmogorov_p(0.9, 100), 1e-12);
}

}  // namespace
}  // namespace somato
