#include "studies/sweep/design.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "somato/core/check.h"

namespace somato {
namespace {

TEST(LatinHypercube, HasOnePointInEachPartOfEachDimension) {
  for (const std::size_t points : {1U, 2U, 7U, 64U, 1000U}) {
    const auto all = latin_hypercube(points, 5, 3);
    ASSERT_EQ(all.size(), points);
    for (std::size_t d = 0; d < 5; ++d) {
      std::set<double> parts;
      for (const auto& point : all) {
        ASSERT_GE(point[d], 0.0);
        ASSERT_LT(point[d], 1.0);
        parts.insert(std::floor(point[d] * static_cast<double>(points)));
      }
      EXPECT_EQ(parts.size(), points) << d;
    }
  }
}

// With each order as likely as any other, a part stands in each place equally often.
TEST(LatinHypercube, OrdersArePermutationsThatAreEquallyLikely) {
  constexpr int kSeeds = 6000;
  std::vector<int> first_part(3);
  for (int seed = 0; seed < kSeeds; ++seed) {
    const double number = latin_hypercube(3, 1, static_cast<std::uint64_t>(seed))[0][0];
    ++first_part[static_cast<std::size_t>(number * 3)];
  }
  for (const int count : first_part)
    EXPECT_NEAR(count, kSeeds / 3.0, 5 * std::sqrt(kSeeds * 2 / 9.0));
}

TEST(LatinHypercube, IsTheSameForASeedAndKeepsItsFirstDimensions) {
  const auto three = latin_hypercube(20, 3, 7);
  EXPECT_EQ(three, latin_hypercube(20, 3, 7));
  EXPECT_NE(three, latin_hypercube(20, 3, 8));
  const auto two = latin_hypercube(20, 2, 7);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(two[i][0], three[i][0]);
    EXPECT_EQ(two[i][1], three[i][1]);
  }
  EXPECT_THROW(latin_hypercube((std::size_t{1} << 20) + 1, 1, 1), InvalidArgument);
}

TEST(FullFactorial, HasEveryCombinationOnce) {
  using Points = std::vector<std::vector<std::size_t>>;
  EXPECT_EQ(full_factorial({2, 3}), (Points{{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}}));
  EXPECT_EQ(full_factorial({4, 1, 3, 2}).size(), 24U);
}

TEST(OneAtATime, MovesOneFromNothing) {
  using Points = std::vector<std::vector<std::optional<std::size_t>>>;
  const std::optional<std::size_t> none;
  EXPECT_EQ(one_at_a_time({2, 1}), (Points{{none, none}, {0, none}, {1, none}, {none, 0}}));
}

}  // namespace
}  // namespace somato
