#include "studies/sweep/first_order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "somato/core/check.h"

namespace somato {
namespace {

using Values = std::vector<double>;
using Cells = std::vector<std::size_t>;

TEST(FirstOrder, IsOneForWhatDecidesAllAndZeroForWhatDecidesNothing) {
  EXPECT_DOUBLE_EQ(first_order({0, 0, 1, 1}, {0, 0, 1, 1})->index, 1.0);
  EXPECT_DOUBLE_EQ(first_order({0, 1, 0, 1}, {0, 0, 1, 1})->index, 0.0);
}

// Y = a + 2 b on two levels of a and b: variances 1/4 and 4/4 of 5/4.
TEST(FirstOrder, SharesTheVarianceOfASumAmongItsTerms) {
  const Values values{0, 2, 1, 3};
  EXPECT_DOUBLE_EQ(first_order(values, {0, 0, 1, 1})->index, 0.2);
  EXPECT_DOUBLE_EQ(first_order(values, {0, 1, 0, 1})->index, 0.8);
}

// Y = a xor b: all is interaction.
TEST(FirstOrder, DoesNotShowInteractions) {
  const Values values{0, 1, 1, 0};
  EXPECT_DOUBLE_EQ(first_order(values, {0, 0, 1, 1})->index, 0.0);
  EXPECT_DOUBLE_EQ(first_order(values, {0, 1, 0, 1})->index, 0.0);
}

// Cells of different sizes, by hand: means 1 and 4 of 3 and 1 points, 1.75 in all:
// (3 * 0.5625 + 5.0625) / (3.0625 + 0.5625 + 0.0625 + 5.0625) = 6.75 / 8.75.
TEST(FirstOrder, WeighsCellsByTheirPoints) {
  EXPECT_DOUBLE_EQ(first_order({0, 1, 2, 4}, {5, 5, 5, 9})->index, 6.75 / 8.75);
}

TEST(FirstOrder, ByChanceIsTheMeanOverAllPermutations) {
  Values values{0, 0.1, 0.25, 0.7, 0.75, 1.0};
  const Cells cells{0, 0, 0, 1, 1, 2};
  double sum = 0.0;
  int count = 0;
  do {
    sum += first_order(values, cells)->index;
    ++count;
  } while (std::next_permutation(values.begin(), values.end()));
  EXPECT_EQ(count, 720);
  EXPECT_NEAR(first_order(values, cells)->by_chance, sum / count, 1e-12);
}

TEST(FirstOrder, IsNothingWhereThereIsNothingToExplain) {
  EXPECT_FALSE(first_order({}, {}));
  EXPECT_FALSE(first_order({0.1, 0.1, 0.1}, {0, 1, 2}));
  EXPECT_FALSE(first_order({0.1, 0.2}, {3, 3}));
  EXPECT_THROW(first_order({1.0}, {}), InvalidArgument);
}

}  // namespace
}  // namespace somato
