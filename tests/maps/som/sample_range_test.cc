#include "maps/som/sample_range.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace somato {
namespace {

bool in_range(std::vector<float> values) {
  return is_in_range(SignalView::dense(values));
}

TEST(SampleRange, EndsWhereDistancesLeaveSinglePrecision) {
  EXPECT_TRUE(in_range({0.0F, 0.0F}));
  EXPECT_TRUE(in_range({1e-30F, 0.0F}));
  EXPECT_TRUE(in_range({6e17F, 7e17F}));   // 9.2e17 long
  EXPECT_FALSE(in_range({8e17F, 7e17F}));  // 1.06e18 long
  EXPECT_FALSE(in_range({3e37F, 4.0F}));
}

TEST(SampleRange, HoldsOnlyFiniteNumbers) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(in_range({kInfinity, 1.0F}));
  EXPECT_FALSE(in_range({-kInfinity, kInfinity}));
  EXPECT_FALSE(in_range({std::numeric_limits<float>::quiet_NaN()}));
}

}  // namespace
}  // namespace somato
